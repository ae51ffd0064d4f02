"""The order of a question in the largest letters; while hands are kept out it waits, grey, below the words for that."""

from __future__ import annotations

from PySide6.QtGui import QColor, QPalette

from labcal.gui.theming.theme import GRID, Theme, state_ink
from labcal.gui.widgets.common import AutoSizeLabel, label, set_state

LEAST_PX = 7 * GRID  # for why hands are kept out, which is read from afar however long the order is


class OrderLabel(AutoSizeLabel):
    """`below`: where the order stands meanwhile; it has a place of its own beside this."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme, self._order, self._kept = theme, "", ("", "")
        self.below = label("", wrap=True)
        set_state(self.below, "old")
        self.below.hide()

    def order(self, words: str) -> None:
        """This is asked."""
        self._order = words
        self._write()

    def keep_out(self, words: str, state: str) -> None:
        """Why nobody may follow the order now, and the state that goes with it; "" where one may."""
        if (words, state) != self._kept:
            self._kept = words, state
            self._write()

    def set_theme(self, theme: Theme) -> None:
        """In the theme's colours."""
        self._theme = theme
        self._write()

    def _write(self) -> None:
        words, state = self._kept
        palette = self.palette()
        palette.setColor(QPalette.ColorRole.WindowText, QColor(state_ink(self._theme, state)))
        self.setPalette(palette)
        self.set_text(words or self._order)
        self.setMinimumHeight(LEAST_PX if words else 0)
        self.below.setText(self._order)
        self.below.setVisible(bool(words))
