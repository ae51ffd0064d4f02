"""A button for what acts on the lab: a click, or its own key held for 0.7 s. Never Enter, never a scanner's burst."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QPushButton, QWidget

HOLD_MS = 700
KEYS = (Qt.Key.Key_F8, Qt.Key.Key_F7, Qt.Key.Key_F6)  # a button's own is one of these


def handle_key(watched: QWidget, event: QKeyEvent) -> bool:
    """Hand a key to the button of the same window whose own it is, wherever the focus is."""
    return event.key() in KEYS and any(button.handle_key(event) for button in watched.window().findChildren(HoldButton))


class HoldButton(QPushButton):
    """Clicks by mouse at once; by keyboard only when `key` is held for 0.7 s with any focus in its window."""

    def __init__(self, text: str, key: Qt.Key) -> None:
        super().__init__(text)
        self.key = key
        self.setObjectName("primary")
        self.setAutoDefault(False)
        self.held = QTimer(self, interval=HOLD_MS, singleShot=True)
        self.held.timeout.connect(self.click)

    def handle_key(self, event: QKeyEvent) -> bool:
        """Take the press and the release of its own key; says whether it was."""
        if event.key() != self.key or not self.isVisible() or not self.isEnabled():
            return False
        if not event.isAutoRepeat():
            self.held.start() if event.type() == QEvent.Type.KeyPress else self.held.stop()
        return True

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Space and Enter do nothing here."""
        event.ignore()

    def hideEvent(self, event: object) -> None:
        """A key held over the end of a card confirms nothing in the next."""
        self.held.stop()
