"""What the record of one run tells beside its rows: what was noted, interruptions, and what the procedure noted."""

from __future__ import annotations

from collections import Counter

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QPlainTextEdit, QVBoxLayout, QWidget

from labcal.gui.ipc.record_messages import TellRecord
from labcal.gui.translations.sentences import in_words
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.told_words import interrupted_words, noted_words, remarked_words, serials_words
from labcal.gui.widgets.common import OneLine, button, label, set_state
from labcal.record.told import Told

DETAILS_PX = 160


class RecordWords(QWidget):
    """Asks for itself; nothing is seen of a run of which there is nothing to tell.

    `here`: in the History, where all is kept. What the procedure noted is one line; the whole of it is behind
    Details, and scrolled there.
    """

    def __init__(self, app_state: AppState, *, here: bool = False) -> None:
        super().__init__()
        self._app_state, self._run, self._here = app_state, "", here
        self._told_of_it: Told | None = None
        self.interrupted, self.noted = label("", wrap=True), label("", wrap=True)
        self.serials = label("", wrap=True)
        for doubt in (self.interrupted, self.serials):
            set_state(doubt, "warning")
        self.remarked, self.all = OneLine() if here else label("", wrap=True), QPlainTextEdit()
        self.all.setReadOnly(True)
        self.all.setFixedHeight(DETAILS_PX)
        self.all.setAccessibleName(self.tr("What the procedure noted"))
        self.fold = button(
            self.tr("Details"), self.tr("All that the procedure noted, in its order; no verdict rests on its estimates")
        )
        self.fold.setCheckable(True)
        self.fold.toggled.connect(self.all.setVisible)
        self.line = QWidget()
        kept = self.line.sizePolicy()
        kept.setRetainSizeWhenHidden(not here)  # what is above it stays where it is once the record is read
        self.line.setSizePolicy(kept)
        row = QHBoxLayout(self.line)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.remarked, 1)
        row.addWidget(self.fold)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for words in (self.noted, self.interrupted, self.serials):
            if not here:
                words.setAlignment(Qt.AlignmentFlag.AlignCenter)
            column.addWidget(words)
        for part in (self.line, self.all):
            column.addWidget(part)
        self._show(Told())

    def show_run(self, run: str) -> None:
        """Of this run; the same one again is read again. None where it is ""."""
        if run != self._run:
            self._show(Told())
        self._run = run
        if run:
            self._app_state.quick_worker.request(
                TellRecord(run), lambda told: self._told(run, told), lambda _: self._told(run, Told())
            )

    def _told(self, run: str, told: Told) -> None:
        if run == self._run:
            self._show(told)

    def _show(self, told: Told) -> None:
        if told == self._told_of_it:
            return  # a fold that is open stays open
        self._told_of_it = told
        noted = noted_words(told, here=self._here)
        said = {self.interrupted: interrupted_words(told), self.noted: noted, self.serials: serials_words(told)}
        for shown, words in said.items():
            shown.setText(words)
            shown.setVisible(bool(words))
        self.remarked.setText(remarked_words(told))
        self.line.setVisible(bool(told.remarks))
        often = Counter(map(in_words, told.remarks))  # the same words stand once
        self.all.setPlainText("\n".join(one if n == 1 else f"{one} ({n}×)" for one, n in often.items()))
        self.fold.setChecked(False)
        self.all.hide()
