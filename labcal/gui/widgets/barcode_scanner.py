"""Tells a barcode scanner from a person: more than 40 characters a second are a scan.

It goes into the field that has the focus where that `takes_scans`, or `takes_names`; what comes fast into any other
field was typed there, and stays; where no field takes text it is for whoever hears `scanned`.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from typing import TypeGuard

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication, QFileDialog, QLineEdit, QMainWindow, QPlainTextEdit, QTextEdit, QWidget

FASTEST_TYPIST_S = 1 / 40  # between two characters; a scanner takes 20 ms at most
SHORTEST = 4  # characters of a scan
TAKES_SCANS, TAKES_NAMES, TAKES_NUMBERS = "takes_scans", "takes_names", "takes_numbers"
NUMBERS = re.compile(r"[-+\u2212\d.,; ]+")
LONGEST_NUMBER = 12  # letters that come in one burst
ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)
MODIFIERS = (Qt.Key.Key_Shift, Qt.Key.Key_Control, Qt.Key.Key_Alt, Qt.Key.Key_AltGr, Qt.Key.Key_Meta)
STRUCK = (QEvent.Type.KeyPress, QEvent.Type.ShortcutOverride)


class Scanner(QObject):
    """Handles all keys (see `Frame.key_handlers`): holds them back for the blink in which a burst shows itself.

    A single key is handed on 40 ms later, exactly as it came; a burst replaces what stands in a field that takes scans,
    stays in any other that takes text, but for the Enter that ends it, and else it is emitted whole as `scanned`: no
    button has it. `asked`: whether a scan is asked for, whatever has the focus.
    """

    scanned = Signal(str)

    def __init__(self, parent: QObject, now: Callable[[], float] = time.monotonic) -> None:
        super().__init__(parent)
        self.now = now
        self._last_s = 0.0
        self._kept: list[tuple[QWidget, QKeyEvent]] = []
        self.asked: Callable[[], bool] = lambda: False
        self._replaying = False
        self.wait = QTimer(self, interval=int(FASTEST_TYPIST_S * 1000) + 7, singleShot=True)
        self.wait.timeout.connect(self.flush)

    def handle_key(self, watched: QWidget, event: QKeyEvent) -> bool:
        """Hold characters back until it is known who types."""
        if self._replaying or self._of_another(watched.window()):
            return False
        if event.type() == QEvent.Type.KeyRelease and any(event.key() == kept.key() for _, kept in self._kept):
            self._kept.append((watched, event.clone()))  # a release never comes before its press
            return True
        if event.type() in STRUCK and not self._counts(event) and event.key() not in MODIFIERS:
            self.flush()  # a window that was busy hears Tab before the blink is over: what was typed comes first
        if event.type() != QEvent.Type.KeyPress or not self._counts(event):
            return False
        if watched is not (QApplication.focusWidget() or watched.window()) or _secret(watched):
            return False
        at_s = event.timestamp() / 1000 or self.now()  # when it was struck, however late a busy window hears of it
        if self._kept and at_s - self._last_s > FASTEST_TYPIST_S:
            self.flush()
        self._last_s = at_s
        self._kept.append((watched, event.clone()))
        self.wait.start()
        return True

    def _of_another(self, window: QWidget) -> bool:
        """Whether these keys go to another main window, or name a file; those of any other dialog are ours."""
        return isinstance(window, QFileDialog) or (isinstance(window, QMainWindow) and window is not self.parent())

    def _counts(self, event: QKeyEvent) -> bool:
        command = event.modifiers() & ~(Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.KeypadModifier)
        if command or event.isAutoRepeat():
            return False
        return (event.text().isprintable() and bool(event.text())) or (event.key() in ENTER and bool(self._kept))

    def _scan(self, into: QWidget, text: str) -> None:
        field = into if isinstance(into, QLineEdit) and not into.isReadOnly() else None
        if field is not None and field.property(TAKES_SCANS):
            field.selectAll()
            return field.insert(text.strip())  # as if it had been typed
        return self.scanned.emit(text.strip())

    def flush(self) -> None:
        """Decide about what is held: a scan, or keys of a person."""
        kept, self._kept = self._kept, []
        self.wait.stop()
        struck = [event for _, event in kept if event.type() == QEvent.Type.KeyPress]
        text = "".join(event.text() for event in struck if event.key() not in ENTER)
        if len(text) >= SHORTEST and not _is_number(kept[0][0], text):
            into = kept[0][0]
            if not _is_for_a_name(into):
                if self.asked() or into.property(TAKES_SCANS) or not _takes_text(into):
                    return self._scan(into, text)
                kept = [(widget, event) for widget, event in kept if event.key() not in ENTER]  # it answers nothing
            elif not into.isModified():
                into.selectAll()  # a badge in place of yesterday's name; within a name that is being typed, more of it
        self._replaying = True
        try:
            for widget, event in kept:
                QCoreApplication.sendEvent(widget, event)
        finally:
            self._replaying = False


def takes_scans(field: QLineEdit) -> None:
    """What is scanned while `field` has the focus is written into it: it is for a serial, or searches."""
    field.setProperty(TAKES_SCANS, True)


def takes_names(field: QLineEdit) -> None:
    """What comes quickly while `field` has the focus is a name: of a badge, a password manager or quick fingers."""
    field.setProperty(TAKES_NAMES, True)
    field.editingFinished.connect(lambda: field.setModified(False))


def takes_numbers(field: QLineEdit) -> None:
    """What comes quickly while `field` has the focus, and may be a number, was typed there by quick fingers."""
    field.setProperty(TAKES_NUMBERS, True)


def _is_number(into: QWidget, text: str) -> bool:
    plausible = len(text) <= LONGEST_NUMBER and bool(NUMBERS.fullmatch(text)) and not re.search(r"\d{7}", text)
    return isinstance(into, QLineEdit) and bool(into.property(TAKES_NUMBERS)) and not into.isReadOnly() and plausible


def _is_for_a_name(into: QWidget) -> TypeGuard[QLineEdit]:
    return isinstance(into, QLineEdit) and bool(into.property(TAKES_NAMES)) and not into.isReadOnly()


def _takes_text(into: QWidget) -> bool:
    return isinstance(into, QLineEdit | QPlainTextEdit | QTextEdit) and not into.isReadOnly()


def _secret(watched: QWidget) -> bool:
    """Whether this is where a passphrase is typed: what a password manager types stays there, unseen."""
    return isinstance(watched, QLineEdit) and watched.echoMode() != QLineEdit.EchoMode.Normal
