"""The button Next: what it does changes by itself, so that a press just after a change was meant for what it was."""

from __future__ import annotations

import time

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QPushButton

TOO_SOON_MS = 700  # to see the new words, and to hold a finger back


class NextButton(QPushButton):
    """`too_soon`: it was pressed before its new words could be read, and does nothing."""

    too_soon = Signal()

    def __init__(self, tip: str) -> None:
        super().__init__()
        self.setToolTip(tip)
        self.setObjectName("primary")
        self.setAutoDefault(False)
        self.following = ""
        self._changed_s: float | None = None

    def say(self, words: str, following: str) -> None:
        """What it does from now on: `following`, in its own `words`."""
        self.following = following
        if words != self.text():
            self._changed_s = time.monotonic() if self.text() else None  # nobody presses one that said nothing
            self.setText(words)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Not taken where the words have just changed."""
        self.too_soon.emit() if self._just_changed() else super().mousePressEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """The same by Space; Tab goes on."""
        presses = event.key() in (Qt.Key.Key_Space, Qt.Key.Key_Select)
        self.too_soon.emit() if presses and self._just_changed() else super().keyPressEvent(event)

    def press(self) -> None:
        """The same by the shortcut."""
        self.too_soon.emit() if self._just_changed() else self.click()

    def _just_changed(self) -> bool:
        return self._changed_s is not None and time.monotonic() - self._changed_s < TOO_SOON_MS / 1000
