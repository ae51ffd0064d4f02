"""A button that takes the click that was meant for it, though a card came or went under a mouse that stood still."""

from __future__ import annotations

from PySide6.QtCore import QPoint
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QPushButton


class SteadyButton(QPushButton):
    """What it was pressed on counts, and not where the page has moved it by the time the mouse is let go."""

    _pressed_at: QPoint | None = None  # on the screen

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Remember where."""
        self._pressed_at = event.globalPosition().toPoint()
        super().mousePressEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """The next press is another one."""
        super().mouseReleaseEvent(event)
        self._pressed_at = None

    def hitButton(self, pos: QPoint) -> bool:
        """On it, or where it was pressed: a mouse that is drawn away takes the press back."""
        if super().hitButton(pos) or self._pressed_at is None:
            return super().hitButton(pos)
        moved = self.mapToGlobal(pos) - self._pressed_at
        return moved.manhattanLength() < QApplication.startDragDistance()
