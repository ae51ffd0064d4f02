"""Where a calibration file is dropped to be verified, beside what is chosen."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QVBoxLayout, QWidget

from labcal.files.home import home
from labcal.gui.theming.theme import GRID
from labcal.gui.widgets.common import Card, button, flat, label, set_state


class Drop(QWidget):
    """A row of `beside` and the button that verifies a file, and below it how that one stands.

    A file is chosen with Enter, or dropped here.
    """

    dropped = Signal(str)
    closed = Signal()  # what was said of a file is put away

    def __init__(self, beside: QWidget) -> None:
        super().__init__()
        self.setAcceptDrops(True)
        column, row = QVBoxLayout(self), QHBoxLayout()
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(GRID)
        self.name, self.words = label("", "ask", wrap=True), label("", wrap=True)
        self.card = flat(Card())  # else its lines stand far apart where there is nothing below it
        for said in (self.name, self.words):
            self.card.body.addWidget(said)
        self.close_card = button(self.tr("Close"), self.tr("The chosen calibration alone again"))
        self.close_card.clicked.connect(self.put_away)
        self.close_card.clicked.connect(self.closed)
        self.card.body.addWidget(self.close_card, 0, Qt.AlignmentFlag.AlignLeft)
        self.card.hide()
        self.choose = button(
            self.tr("Verify a file …"),
            self.tr("Choose a calibration .json with its .sshsig beside it, or drop it on the window"),
        )
        self.choose.clicked.connect(self._choose)
        self._folder = ""  # where something was handed out last
        row.addWidget(beside, 1)
        row.addStretch()
        row.addWidget(self.choose)
        column.addLayout(row)
        column.addWidget(self.card)

    def open_at(self, folder: str) -> None:
        """Choose from this folder: something was handed out there last."""
        self._folder = folder

    def put_away(self) -> None:
        """What was said of a file is past."""
        self.words.clear()
        self.card.hide()

    def say(self, name: str, words: str, state: str) -> None:
        """How the file called `name` stands: on a card of its own, above those of the calibration that is chosen."""
        self.name.setText(name)
        self.words.setText(words)
        self.card.show()
        for said in (self.name, self.words):
            set_state(said, state)

    def _choose(self) -> None:
        there = Path(self._folder) if self._folder else None
        start = there if there is not None and there.is_dir() else home() / "calibrations"
        path, _ = QFileDialog.getOpenFileName(self, self.tr("Verify a calibration"), str(start), "*.json")
        if path:
            self.dropped.emit(path)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take files."""
        if event.mimeData().hasUrls():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Verify the first file; a signature stands for its calibration."""
        path = event.mimeData().urls()[0].toLocalFile()
        if path.endswith(".sshsig"):
            path = path.removesuffix(".sshsig").removesuffix(".2")
        self.dropped.emit(path)
