"""The button Next: what it does changes by itself, so that a press just after a change was meant for what it was."""

from __future__ import annotations

import time

from PySide6.QtCore import Qt, QTimer, Signal
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
        self._about, self._by_hand = "", False

    def say(self, words: str, following: str, about: str = "") -> None:
        """What it does from now on: `following`, in its own `words`; `about`: of the DUT that a person has chosen.

        Whoever has just chosen another one presses it for that one, and is not told that it has changed.
        """
        self.following = following
        if about != self._about:
            self._about, self._by_hand = about, True
            QTimer.singleShot(0, self, self._chosen)
        if words != self.text():
            meant = self._by_hand or not self.text()  # nobody presses one that said nothing
            self._changed_s = None if meant else time.monotonic()
            self.setText(words)

    def _chosen(self) -> None:
        self._by_hand = False

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
