"""Room that is kept below a question for notes that come later: its letters do not shrink for them."""

from __future__ import annotations

from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget


class NotesRoom(QWidget):
    """As high as a line for each of `notes`, `apart_px` from each other, less what those in sight take.

    It gives way before anything else does.
    """

    def __init__(self, *notes: QLabel, apart_px: int) -> None:
        super().__init__()
        self._notes, self._apart_px, self._high = notes, apart_px, 0
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Maximum)

    def minimumSizeHint(self) -> QSize:
        """None."""
        return QSize(0, 0)

    def sizeHint(self) -> QSize:
        """What is left of a line for each."""
        return QSize(0, self._high)

    def fit(self, *, roomy: bool) -> None:
        """One has come, gone or grown; `roomy`: whether there is room to be kept at all."""
        lines = [_line_px(one) for one in self._notes]
        seen = [(one, line) for one, line in zip(self._notes, lines, strict=True) if not one.isHidden()]
        taken = sum(max(line, one.heightForWidth(one.width())) + self._apart_px for one, line in seen)
        high = max(0, sum(lines) + len(lines) * self._apart_px - taken) if roomy else 0
        if high != self._high:
            self._high = high
            self.updateGeometry()


def _line_px(note: QLabel) -> int:
    """How high one line of it is, as Qt lays it out: what its letters are high, rounded."""
    room = QRect(0, 0, note.width(), 10_000)
    return note.fontMetrics().boundingRect(room, int(Qt.TextFlag.TextWordWrap), "x").height()
