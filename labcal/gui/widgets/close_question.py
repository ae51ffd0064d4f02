"""What a person who closes the window in a run is asked: to stop it, as on the Run page, or keep it running behind."""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QGridLayout, QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.translations.translate import translated
from labcal.gui.widgets.common import button, label, set_state
from labcal.gui.widgets.growing_dialog import GrowingDialog
from labcal.gui.widgets.lab_lines import LabLines

KEEP_OFF_PX = 8 * GRID  # three lines of it
Way = Literal["stop", "behind", "later"]


class CloseQuestion(GrowingDialog):
    """`chosen` carries the way out; Esc and Back leave all as it is. It holds up nothing: the run goes on meanwhile."""

    chosen = Signal(str)

    def __init__(self, parent: QWidget, run: str, *, resumable: bool) -> None:
        super().__init__(parent)
        self.setModal(True)
        self.setWindowTitle(self.tr("A run goes on"))
        column, grid = QVBoxLayout(self), QGridLayout()
        column.setContentsMargins(3 * GRID, 3 * GRID, 3 * GRID, 3 * GRID)
        column.setSpacing(2 * GRID)
        grid.setSpacing(2 * GRID)
        self.keep_off = label("", "title", wrap=True)
        self.keep_off.setMinimumHeight(KEEP_OFF_PX)  # what moves below it no button may
        column.addWidget(self.keep_off)
        column.addWidget(label(self.tr("A run goes on: {0}").format(run), "title", wrap=True))
        self.lab_lines = LabLines()
        later = self.tr(
            "The coils go to zero, the window closes. What is missing is measured later: Go on, on the Start page."
        )
        kept = self.tr(
            "The coils go to zero, the window closes. What was measured is kept; this procedure cannot be gone on with."
        )
        self.ways: dict[Way, tuple[str, str]] = {
            "later" if resumable else "stop": (self.tr("Stop"), later if resumable else kept),
            "behind": (
                self.tr("Keep running behind"),
                self.tr("The window goes out of sight, and comes back when you are needed or the run has ended."),
            ),
        }
        self.buttons = {way: button(words, tip) for way, (words, tip) in self.ways.items()}
        for row, (way, (_, tip)) in enumerate(self.ways.items()):
            self.buttons[way].clicked.connect(lambda _=False, one=way: self._choose(one))
            grid.addWidget(self.buttons[way], row, 0)
            grid.addWidget(label(tip, wrap=True), row, 1)
        grid.setColumnStretch(1, 1)
        grid.setColumnMinimumWidth(1, 45 * GRID)
        column.addLayout(grid)
        self.back = button(self.tr("Back to the run"), self.tr("Close nothing (Esc)"), primary=True)
        self.back.clicked.connect(self.reject)
        self.back.setDefault(True)
        self.back.setFocus()  # Enter and Space close nothing either
        column.addWidget(self.back)
        column.addWidget(self.lab_lines)  # below: however its lines wrap, the buttons keep their place
        column.addStretch()

    def say_hands(self, words: str, mark: str) -> None:
        """Whether they have to be off, and why, before anything else."""
        off, _, why = words.partition(":")
        loud = translated("HANDS OFF – {0}").format(why.strip() or off) if mark == "bad" else words
        self.keep_off.setText(loud)
        set_state(self.keep_off, mark)

    def say_lab(self, coil_words: str, platform_words: str) -> None:
        """How coils and platform are now."""
        self.lab_lines.say(coil_words, platform_words)

    def _choose(self, way: str) -> None:
        self.accept()
        self.chosen.emit(way)
