"""Lines of a card that come, go and grow while it tells of one thing: what stands below them all keeps its place."""

from __future__ import annotations

from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget


class KeptLines(QWidget):
    """Below `lines` it has the room that they took and take no more, until `forget`: none is left among them."""

    def __init__(self, *lines: QLabel, apart_px: int) -> None:
        super().__init__()
        self._lines, self._apart_px, self._most_px = lines, apart_px, 0
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._take(0)

    def keep(self) -> None:
        """Before they say something else, or go."""
        if any(one.isVisible() for one in self._lines):
            self._most_px = max(self._most_px, self._high())

    def fit(self) -> None:
        """They have said it."""
        self._take(self._most_px - self._high())

    def forget(self) -> None:
        """Something else is told, or the card has another width."""
        self._most_px = 0
        self._take(0)

    def _high(self) -> int:
        """What they need, with what keeps them apart."""
        card = self.parentWidget()
        layout = None if card is None else card.layout()
        if card is None or layout is None:
            return 0
        around = layout.contentsMargins()
        width = card.contentsRect().width() - around.left() - around.right()  # of a line that has just come too
        return sum(one.heightForWidth(width) + self._apart_px for one in self._lines if not one.isHidden())

    def _take(self, high: int) -> None:
        self.setVisible(high > self._apart_px)  # what is shown has that above it
        self.setFixedHeight(max(0, high - self._apart_px))
