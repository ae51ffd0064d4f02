"""What happens now, to be read from the cage: an alarm is no smaller than what stood there before it."""

from __future__ import annotations

from PySide6.QtGui import QColor, QPalette

from labcal.gui.theming.theme import GRID, Theme, state_ink
from labcal.gui.widgets.common import AutoSizeLabel

LARGEST_PT = 36
LOW, HIGH = (5 * GRID, 9 * GRID), (15 * GRID, 27 * GRID)  # at least, at most: an alarm has three lines


class RunHeadline(AutoSizeLabel):
    """In the middle of the Run page."""

    def __init__(self, theme: Theme) -> None:
        super().__init__(LARGEST_PT)
        self._theme, self._state = theme, ""
        self.setAccessibleName(self.tr("What happens now"))
        self._show()

    def say(self, words: str, state: str) -> None:
        """Write `words`, in the colour of a state of hands; "bad" is an alarm."""
        if state != self._state:
            self._state = state
            self._show()
            self._be_placed()
        self.set_text(words)

    def set_theme(self, theme: Theme) -> None:
        """In the theme's colours."""
        self._theme = theme
        self._show()

    def _be_placed(self) -> None:
        """At once: in a frame before Qt lays it out an alarm would be cut in the middle of a line."""
        card = self.parentWidget()
        if card is not None and (layout := card.layout()) is not None and self.isVisible():
            layout.activate()

    def _show(self) -> None:
        least, most = HIGH if self._state == "bad" else LOW
        self.setMinimumHeight(least)
        self.setMaximumHeight(most)
        palette = self.palette()
        palette.setColor(QPalette.ColorRole.WindowText, QColor(state_ink(self._theme, self._state)))
        self.setPalette(palette)
