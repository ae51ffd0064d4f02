"""A button for what acts on the lab: a click, or its own key held for 0.7 s. Never Enter, never a scanner's burst.

It fills while its key is held. A key that repeats by letting go for a blink, as through a remote screen, is held all
the same; one that is only tapped says what it wants.
"""

from __future__ import annotations

from PySide6.QtCore import QEvent, QRect, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QPushButton, QWidget

HOLD_MS = 700
BLINK_MS = 90  # a key that comes down again so soon was not let go
FILL_MS, FILL_PX = 30, 6
KEYS = (Qt.Key.Key_F8, Qt.Key.Key_F7, Qt.Key.Key_F6)  # a button's own is one of these


def handle_key(watched: QWidget, event: QKeyEvent) -> bool:
    """Hand a key to the button of the same window whose own it is, wherever the focus is."""
    return event.key() in KEYS and any(button.handle_key(event) for button in watched.window().findChildren(HoldButton))


class HoldButton(QPushButton):
    """Clicks by mouse at once; by keyboard only when `key` is held for 0.7 s with any focus in its window."""

    tapped = Signal()  # its key was let go too early

    def __init__(self, text: str, key: Qt.Key) -> None:
        super().__init__(text)
        self.key = key
        self.setObjectName("primary")
        self.setAutoDefault(False)
        self.held = QTimer(self, interval=HOLD_MS, singleShot=True)
        self.held.timeout.connect(self._confirm)
        self.let_go = QTimer(self, interval=BLINK_MS, singleShot=True)
        self.let_go.timeout.connect(self._give_up)
        self._fill = QTimer(self, interval=FILL_MS)
        self._fill.timeout.connect(self.update)

    def handle_key(self, event: QKeyEvent) -> bool:
        """Take the press and the release of its own key; says whether it was."""
        if event.key() != self.key or not self.isVisible() or not self.isEnabled():
            return False
        if event.isAutoRepeat():
            return True
        if event.type() == QEvent.Type.KeyRelease:
            self.let_go.start() if self.held.isActive() else None
        elif self.held.isActive():
            self.let_go.stop()
        else:
            self.held.start()
            self._fill.start()
        return True

    def filled(self) -> float:
        """How much of the time it has been held, 0 to 1."""
        left = self.held.remainingTime() / max(1, self.held.interval())
        return max(0.0, 1 - left) if self.held.isActive() else 0.0

    def paintEvent(self, event: QPaintEvent) -> None:
        """The button, and below its words how long it has been held."""
        super().paintEvent(event)
        if width := round(self.filled() * self.width()):
            with QPainter(self) as painter:
                painter.fillRect(QRect(0, self.height() - FILL_PX, width, FILL_PX), self.palette().brightText())

    def _confirm(self) -> None:
        """Held long enough; but a key that may have been let go already has first to be heard again."""
        going = self.let_go.isActive()
        self._stop()
        self.tapped.emit() if going else self.click()

    def _give_up(self) -> None:
        self._stop()
        self.tapped.emit()

    def _stop(self) -> None:
        for timer in (self.held, self.let_go, self._fill):
            timer.stop()
        self.update()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Space and Enter do nothing here."""
        event.ignore()

    def hideEvent(self, event: object) -> None:
        """A key held over the end of a card confirms nothing in the next."""
        self._stop()
