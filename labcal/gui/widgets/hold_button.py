"""A button for what acts on the lab: a click, or its own key held for 0.7 s. Never Enter, never a scanner's burst.

What energises or turns is held by mouse as well. It fills while it is held. How long it was held is told by the time
stamps of press and release: a busy window hears of both late, and of the one later than of the other. A key that
repeats by letting go for a blink, as through a remote screen, is held all the same; one that is only tapped says what
it wants. A key that stays down after it has answered begins nothing: it has to be let go, and pressed anew on a button
that is alive.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from weakref import WeakSet

from PySide6.QtCore import QEvent, QRect, Qt, QTimer, Signal
from PySide6.QtGui import QInputEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QApplication, QDialog, QPushButton, QWidget
from shiboken6 import isValid

from labcal.gui.viewmodels.number_format import format_number

HOLD_MS = 700
LET_GO_MS = 150  # a key that comes down again sooner was not let go
FILL_MS, FILL_PX = 30, 6
KEYS = (Qt.Key.Key_F8, Qt.Key.Key_F7, Qt.Key.Key_F6)  # a button's own is one of these
heard_ms: dict[int, tuple[float, float]] = {}  # by key: its last event, by this computer's clock and by the screen's
buttons: WeakSet[HoldButton] = WeakSet()  # all there are: to look for them among all widgets costs more than a key may


@dataclass(frozen=True, slots=True)
class HeardAt:
    """When an event was: by the screen's stamp of it, where it has one, and by this computer's clock as it is heard."""

    stamp_ms: float
    clock_ms: float

    @classmethod
    def of(cls, event: QInputEvent) -> HeardAt:
        """Of this one."""
        return cls(float(event.timestamp()), time.monotonic() * 1000)

    def after_ms(self, earlier: HeardAt) -> float:
        """How long after another one."""
        if self.stamp_ms and earlier.stamp_ms:
            return self.stamp_ms - earlier.stamp_ms
        return self.clock_ms - earlier.clock_ms


def handle_key(watched: QWidget, event: QKeyEvent) -> bool:
    """Hand a key to the button of the same window whose own it is, wherever the focus is.

    A key that is held comes thirty times a second, to one widget after another: nothing is searched for it.
    """
    if event.key() not in KEYS or event.type() not in (QEvent.Type.KeyPress, QEvent.Type.KeyRelease):
        return False
    anew = _pressed_anew(event)
    window = watched.window()
    asked = [one for one in buttons if isValid(one) and one.window() is window and one.isVisible()]
    if not asked or _covered(window):  # a question that is covered is not answered
        return False
    return any(button.handle_key(event, anew=anew) for button in asked)


def _covered(window: QWidget) -> bool:
    """Whether a dialog of this window is open."""
    return any(
        isinstance(one, QDialog) and one.isVisible() and _is_of(one, window) for one in QApplication.topLevelWidgets()
    )


def _is_of(dialog: QWidget, window: QWidget) -> bool:
    parent = dialog.parentWidget()
    while parent is not None and parent is not window:
        parent = parent.parentWidget()
    return parent is window


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

    tapped = Signal(str)  # it was let go too early, or pressed too soon: which of them, in words
    freed = Signal()  # of a key that was said to be down from before: it is up, or nobody can tell any more

    def __init__(self, text: str, key: Qt.Key, *, held_by_mouse: bool = False) -> None:
        super().__init__(text)
        buttons.add(self)
        self.key, self.held_by_mouse = key, held_by_mouse
        self.setObjectName("primary")
        self.setAutoDefault(False)
        self.held = QTimer(self, interval=HOLD_MS, singleShot=True)
        self.held.timeout.connect(lambda: QTimer.singleShot(0, self, self._confirm))  # a release that waits comes first
        self._began: HeardAt | None = None  # of the press that is held
        self._ended: HeardAt | None = None  # of the release that may be a blink
        self._dead = False  # its key was pressed while it took none
        self._told = False  # that its key is still down
        self._says_down = False  # and that stands there
        self._up = QTimer(self, interval=LET_GO_MS, singleShot=True)  # a key that repeats comes down again before
        self._up.timeout.connect(self._is_free)
        self.let_go = QTimer(self, interval=LET_GO_MS, singleShot=True)
        self.let_go.timeout.connect(self._give_up)
        self._fill = QTimer(self, interval=FILL_MS)
        self._fill.timeout.connect(self.update)

    def handle_key(self, event: QKeyEvent, *, anew: bool) -> bool:
        """Take press and release of its own key, and say whether it was; only what is pressed `anew` begins."""
        if event.key() != self.key or not self.isVisible():
            return False
        pressed = event.type() == QEvent.Type.KeyPress
        self._up.stop() if pressed or event.isAutoRepeat() else self._up.start()
        if pressed:
            self._say_held(anew=anew)
        if not event.isAutoRepeat() and self._dead_says(pressed=pressed, anew=anew):
            return True
        if not self.isEnabled():
            return False
        if event.isAutoRepeat():
            return True
        if not pressed:
            if self._began is not None:
                self._ended = HeardAt.of(event)
                self.let_go.start()
        elif self._began is not None:
            self._ended = None
            self.let_go.stop()
        elif anew:
            self._hold(event)
        return True

    def _say_held(self, *, anew: bool) -> None:
        """Of a key that is down from before, once: why it fills nothing."""
        if anew:
            self._is_free()
        if anew or self._began is not None or self._dead:
            self._told = anew
        elif not self._told:
            self._told = self._says_down = True
            words = self.tr("▲ Let go of {0}: it was down before this question came. Then hold it for 0.7 s.")
            self.tapped.emit(words.format(self._key_name()))

    def _is_free(self) -> None:
        """What was said of a key that is down is past."""
        said, self._says_down = self._says_down, False
        if said:
            self.freed.emit()

    def _dead_says(self, *, pressed: bool, anew: bool) -> bool:
        """Of a press that came too soon: that it did, when the key is let go."""
        if pressed:
            self._dead = self._dead or (anew and not self.isEnabled())
            return False
        dead, self._dead = self._dead, False
        if dead:
            too_soon = self.tr("▲ {0} was pressed before this question took an answer. Press it anew.")
            self.tapped.emit(too_soon.format(self._key_name()))
        return dead

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin to hold it, where a click is not enough."""
        if not self.held_by_mouse:
            return super().mousePressEvent(event)
        if event.button() == Qt.MouseButton.LeftButton and self._began is None:
            self._hold(event)
        return None

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """A press that leaves the button is over."""
        if not self.held_by_mouse:
            super().mouseMoveEvent(event)
        elif self._began is not None and event.buttons() and not self.rect().contains(event.position().toPoint()):
            self._give_up()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go: too early, where it is still filling."""
        if not self.held_by_mouse:
            super().mouseReleaseEvent(event)
        elif self._began is not None:
            self._ended = HeardAt.of(event)
            self._give_up()

    def _hold(self, event: QInputEvent) -> None:
        self._began, self._ended = HeardAt.of(event), None
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
        """Held long enough; but where it may have been let go already that counts."""
        if self._ended is not None:
            return self._give_up()
        if self._began is not None:
            self._stop()
            self.click()
        return None

    def _give_up(self) -> None:
        """Let go, or the mouse has left it."""
        lasted_ms = 0.0 if self._began is None or self._ended is None else self._ended.after_ms(self._began)
        left = self._ended is None
        self._stop()
        if lasted_ms >= HOLD_MS:
            return self.click()
        words = self.tr("▲ Let go too early, after {0} s: hold {1} for 0.7 s.")
        if left:
            words = self.tr("▲ Let go too early: the mouse has left the button. Hold {1} for 0.7 s.")
        elif self.held_by_mouse:
            words = self.tr("▲ Let go too early, after {0} s: hold this button, or {1}, for 0.7 s.")
        return self.tapped.emit(words.format(format_number(lasted_ms / 1000, signed=False), self._key_name()))

    def _key_name(self) -> str:
        return self.key.name.removeprefix("Key_")

    def _stop(self) -> None:
        self._began = self._ended = None
        for timer in (self.held, self.let_go, self._fill):
            timer.stop()
        self.update()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Space and Enter do nothing here."""
        event.ignore()

    def hideEvent(self, event: object) -> None:
        """A key held over the end of a card confirms nothing in the next."""
        self._dead = self._says_down = False
        self._stop()

    def changeEvent(self, event: QEvent) -> None:
        """A window that is left, or a button that dies, hears no key being let go."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.ActivationChange, QEvent.Type.EnabledChange):
            self._stop()
        if event.type() == QEvent.Type.ActivationChange:
            self._is_free()
