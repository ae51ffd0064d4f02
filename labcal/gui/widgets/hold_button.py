"""A button for what acts on the lab: a click, or its own key held for 0.7 s. Never Enter, never a scanner's burst.

What energises or turns is held by mouse as well. It fills while it is held. A key that repeats by letting go for a
blink, as through a remote screen, is held all the same; one that is only tapped says what it wants. A key that stays
down after it has answered begins nothing: it has to be let go, and pressed anew on a button that is alive.
"""

from __future__ import annotations

import time

from PySide6.QtCore import QEvent, QRect, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QDialog, QPushButton, QWidget

HOLD_MS = 700
LET_GO_MS = 150  # a key that comes down again sooner was not let go
FILL_MS, FILL_PX = 30, 6
KEYS = (Qt.Key.Key_F8, Qt.Key.Key_F7, Qt.Key.Key_F6)  # a button's own is one of these
heard_ms: dict[int, tuple[float, float]] = {}  # by key: its last event, by this computer's clock and by the screen's


def handle_key(watched: QWidget, event: QKeyEvent) -> bool:
    """Hand a key to the button of the same window whose own it is, wherever the focus is."""
    if event.key() not in KEYS or event.type() not in (QEvent.Type.KeyPress, QEvent.Type.KeyRelease):
        return False
    anew = _pressed_anew(event)
    window = watched.window()
    if any(over.isVisible() for over in window.findChildren(QDialog)):  # a question that is covered is not answered
        return False
    return any(button.handle_key(event, anew=anew) for button in window.findChildren(HoldButton))


def _pressed_anew(event: QKeyEvent) -> bool:
    """Whether this press begins something: X11 repeats a key that stays down by letting it go and pressing it."""
    now = time.monotonic() * 1000, float(event.timestamp())
    before = heard_ms.get(event.key(), (-LET_GO_MS, -LET_GO_MS))
    heard_ms[event.key()] = now
    by_clock, by_screen = (one - other for one, other in zip(now, before, strict=True))
    quiet = by_clock >= LET_GO_MS and (by_screen >= LET_GO_MS or not event.timestamp())
    return quiet and event.type() == QEvent.Type.KeyPress and not event.isAutoRepeat()


class HoldButton(QPushButton):
    """By keyboard only when `key` is held for 0.7 s with any focus in its window; by mouse a click, or `held_by_mouse`.

    Enabled it is alive, and only then a press begins.
    """

    tapped = Signal()  # it was let go too early

    def __init__(self, text: str, key: Qt.Key, *, held_by_mouse: bool = False) -> None:
        super().__init__(text)
        self.key, self.held_by_mouse = key, held_by_mouse
        self.setObjectName("primary")
        self.setAutoDefault(False)
        self.held = QTimer(self, interval=HOLD_MS, singleShot=True)
        self.held.timeout.connect(self._confirm)
        self.let_go = QTimer(self, interval=LET_GO_MS, singleShot=True)
        self.let_go.timeout.connect(self._give_up)
        self._fill = QTimer(self, interval=FILL_MS)
        self._fill.timeout.connect(self.update)

    def handle_key(self, event: QKeyEvent, *, anew: bool) -> bool:
        """Take press and release of its own key, and say whether it was; only what is pressed `anew` begins."""
        if event.key() != self.key or not self.isVisible() or not self.isEnabled():
            return False
        if event.isAutoRepeat():
            return True
        if event.type() == QEvent.Type.KeyRelease:
            self.let_go.start() if self.held.isActive() else None
        elif self.held.isActive():
            self.let_go.stop()
        elif anew:
            self._hold()
        return True

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin to hold it, where a click is not enough."""
        if not self.held_by_mouse:
            return super().mousePressEvent(event)
        if event.button() == Qt.MouseButton.LeftButton and not self.held.isActive():
            self._hold()
        return None

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """A press that leaves the button is over."""
        if not self.held_by_mouse:
            super().mouseMoveEvent(event)
        elif self.held.isActive() and event.buttons() and not self.rect().contains(event.position().toPoint()):
            self._give_up()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go: too early, where it is still filling."""
        if not self.held_by_mouse:
            super().mouseReleaseEvent(event)
        elif self.held.isActive():
            self._give_up()

    def _hold(self) -> None:
        self.held.start()
        self._fill.start()

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

    def changeEvent(self, event: QEvent) -> None:
        """A window that is left, or a button that dies, hears no key being let go."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.ActivationChange, QEvent.Type.EnabledChange):
            self._stop()
