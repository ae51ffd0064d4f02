"""The window made anew in another language: the lab, the bench and what was typed stay as they are."""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QLocale, Qt, QTimer
from PySide6.QtGui import QGuiApplication

from labcal.gui.translations.translate import install_translator
from labcal.gui.window import Window

TOO_SOON_S = 0.5  # after a window has come


class Shown:
    """Holds the window that is in sight, and puts another in its place; `attend` is called with each."""

    def __init__(self, window: Window, attend: Callable[[Window], object] = lambda window: None) -> None:
        self.window, self._attend, self._since_s = window, attend, -TOO_SOON_S
        self._listen()

    def speak(self, language: str) -> None:
        """Have a window in `language` in place of this one, unless a run goes on; kept for the next day.

        The new one is there before the old one goes, so that F12 is heard at every moment.
        """
        old, application = self.window, QCoreApplication.instance()
        if application is None or old.app_state.run.alive:
            return
        QGuiApplication.setOverrideCursor(Qt.CursorShape.WaitCursor)  # it takes seconds
        try:
            self._replace(old, application, language)
        finally:
            QGuiApplication.restoreOverrideCursor()

    def _replace(self, old: Window, application: QCoreApplication, language: str) -> None:
        old.language_switch.setEnabled(False)
        old.language_switch.setText(f"{old.language_switch.text()} …")
        old.language_switch.repaint()
        old.app_state.settings.setValue("language", language)
        install_translator(application, QLocale(language))
        run, lab = old.app_state.run, old.app_state.lab
        ended = lab.state.message == run.message
        if run.state == "ended":
            run.say_how_it_ended()
        said_at = lab.state.said_at if ended else ""  # the words are new, what they tell is not
        lab.update(message=run.message if ended else "", said_at=said_at)  # all else is in the other language
        old.app_state.one_dut.begin_anew()
        self.window = Window(old.app_state)
        self._listen()
        self.window.setGeometry(old.geometry())
        self.window.open_page(old.page_shown())
        self.window.show()
        self.window.language_switch.setFocus()  # where it was; else the DUT's serial has it, selected
        QTimer.singleShot(0, self.window, self.window.prebuild)
        old.hide()
        old.deleteLater()
        self._since_s = time.monotonic()

    def _wanted(self, language: str) -> None:
        """A second click, made while the window stood still, was meant for the first."""
        if time.monotonic() - self._since_s > TOO_SOON_S:
            self.speak(language)

    def _listen(self) -> None:
        self.window.language_wanted.connect(self._wanted)
        self._attendant = self._attend(self.window)
