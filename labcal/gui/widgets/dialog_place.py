"""Where a dialog comes up: beside what has to be read at every moment."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QSize
from PySide6.QtWidgets import QDialog, QWidget


def place_below_and_left(dialog: QDialog, above: QWidget, right: QWidget) -> None:
    """Below `above` and left of the widget at the `right`, as far as the screen has room; no smaller than it must be.

    Its frame is not there yet: it will be as wide as that of the window.
    """
    screen, least, window = dialog.screen().availableGeometry(), dialog.minimumSizeHint(), right.window()
    frame = window.frameGeometry().size() - window.size()
    top, edge = above.mapToGlobal(QPoint(0, above.height())).y(), right.mapToGlobal(QPoint(0, 0)).x()
    room = QSize(edge - screen.left(), screen.bottom() + 1 - top) - frame
    dialog.resize(dialog.size().boundedTo(room.expandedTo(least)))
    whole = dialog.size() + frame
    left, highest = edge - whole.width(), screen.bottom() + 1 - whole.height()
    dialog.move(max(screen.left(), left), max(screen.top(), min(top, highest)))
