"""What happens now, to be read from the cage: an alarm is red, and no smaller than what stood there before it."""

from __future__ import annotations

from PySide6.QtGui import QColor, QPalette

from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.widgets.common import AutoSizeLabel

LARGEST_PT = 36
LOW, HIGH = (5 * GRID, 9 * GRID), (15 * GRID, 27 * GRID)  # at least, at most: an alarm has three lines


class RunHeadline(AutoSizeLabel):
    """In the middle of the Run page."""

    def __init__(self, theme: Theme) -> None:
        super().__init__(LARGEST_PT)
        self._theme, self._alarms = theme, False
        self.setAccessibleName(self.tr("What happens now"))
        self._show()

    def say(self, words: str, *, alarms: bool) -> None:
        """Write `words`."""
        if alarms is not self._alarms:
            self._alarms = alarms
            self._show()
        self.set_text(words)

    def set_theme(self, theme: Theme) -> None:
        """In the theme's colours."""
        self._theme = theme
        self._show()

    def _show(self) -> None:
        least, most = HIGH if self._alarms else LOW
        self.setMinimumHeight(least)
        self.setMaximumHeight(most)
        palette = self.palette()
        ink = self._theme.bad if self._alarms else self._theme.text
        palette.setColor(QPalette.ColorRole.WindowText, QColor(ink))
        self.setPalette(palette)
