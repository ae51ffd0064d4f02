"""How a run came out, to be read from five metres: serial, verdict, the rule behind it, and what is next."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QPalette

from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.run_verdict import RunVerdict
from labcal.gui.widgets.common import AutoSizeLabel, button, label, set_state
from labcal.gui.widgets.record_words import RecordWords
from labcal.gui.widgets.whole_card import WholeCard

HUGE_PT = 150
NO_BREAK = "\N{NO-BREAK SPACE}"


class VerdictCard(WholeCard):
    """`details_wanted`: what was measured is to be shown instead."""

    details_wanted = Signal()

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._theme, self._state = theme, ""
        self.told = RecordWords(app_state)
        self.serial, self.word = AutoSizeLabel(HUGE_PT), AutoSizeLabel(HUGE_PT)
        self.serial.setAccessibleName(self.tr("DUT"))
        self.word.setAccessibleName(self.tr("Verdict"))
        self.rule, self.next = label("", wrap=True), label("", "title", wrap=True)
        self.reason = label("", "title", wrap=True)  # where the card that says it gives way to another
        self.details = button(self.tr("What was measured"), self.tr("The pictures and every value with its limit"))
        self.details.clicked.connect(self.details_wanted)
        for part, share, least in ((self.serial, 1, 2 * GRID), (self.word, 3, 3 * GRID)):
            part.setAlignment(Qt.AlignmentFlag.AlignCenter)
            part.setMinimumHeight(least)
            self.body.addWidget(part, share)
        for words in (self.reason, self.rule, self.next):
            words.setAlignment(Qt.AlignmentFlag.AlignCenter)
        for below in (self.reason, self.rule, self.told, self.next):
            self.body.addWidget(below)
        self.body.addWidget(self.details, 0, Qt.AlignmentFlag.AlignHCenter)

    def show_verdict(self, serial: str, verdict: RunVerdict) -> None:
        """Show how the run of `serial` came out."""
        self._state = verdict.state
        self.serial.set_text(serial)
        self.serial.show()
        self.word.set_text(verdict.word.replace(" ", NO_BREAK, 1))  # no shape on a line of its own
        self.rule.setText(verdict.rule)
        self.rule.setVisible(bool(verdict.rule))
        self.next.setText(verdict.next)
        self._colour()

    def say_off(self, words: str, state: str) -> None:
        """What COILS OFF has reached comes before all else, and how the run ended below it."""
        self.rule.setText(" ".join(filter(None, (self.word.text().replace(NO_BREAK, " ") + ".", self.rule.text()))))
        self.serial.hide()
        self._state = state
        self.word.set_text(words.replace(" ", NO_BREAK, 1))
        self._colour()

    def say_reason(self, reason: str, state: str = "bad") -> None:
        """Why it ended so, or did not go on; that its cause is gone is no alarm."""
        self.reason.setText(reason)
        self.reason.setVisible(bool(reason))
        set_state(self.reason, state)

    def set_theme(self, theme: Theme) -> None:
        """The word in the theme's colour of its state."""
        self._theme = theme
        self._colour()

    def _colour(self) -> None:
        palette = self.word.palette()
        ink = getattr(self._theme, self._state or "text")
        palette.setColor(QPalette.ColorRole.WindowText, QColor(ink))
        self.word.setPalette(palette)
