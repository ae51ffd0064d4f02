"""The window made anew in another language: the lab, the bench and what was typed stay as they are."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QLocale, QTimer

from labcal.gui.translations.translate import install_translator
from labcal.gui.window import Window


class Shown:
    """Holds the window that is in sight, and puts another in its place; `attend` is called with each."""

    def __init__(self, window: Window, attend: Callable[[Window], object] = lambda window: None) -> None:
        self.window, self._attend = window, attend
        self._listen()

    def speak(self, language: str) -> None:
        """Have a window in `language` in place of this one, unless a run goes on; kept for the next day.

        The new one is there before the old one goes, so that F12 is heard at every moment.
        """
        old, application = self.window, QCoreApplication.instance()
        if application is None or old.app_state.run.alive:
            return
        old.app_state.settings.setValue("language", language)
        install_translator(application, QLocale(language))
        said, of_the_run = old.app_state.lab.state.message, old.app_state.run.message
        old.app_state.lab.update(message=said if said == of_the_run else "")  # all else is in the other language
        self.window = Window(old.app_state)
        self._listen()
        self.window.setGeometry(old.geometry())
        self.window.open_page(old.page_shown())
        self.window.show()
        self.window.language_switch.setFocus()  # where it was; else the DUT's serial has it, selected
        QTimer.singleShot(0, self.window, self.window.prebuild)
        old.hide()
        old.deleteLater()

    def _listen(self) -> None:
        self.window.language_wanted.connect(self.speak)
        self._attendant = self._attend(self.window)
