"""Where a calibration file is dropped to be verified."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QFileDialog, QHBoxLayout

from labcal.files.home import home
from labcal.gui.theming.theme import GRID
from labcal.gui.widgets.common import Surface, button, label


class Drop(Surface):
    """Where a calibration file is dropped, or chosen with Enter, to be verified."""

    dropped = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.setAcceptDrops(True)
        row = QHBoxLayout(self)
        row.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        self.words = label(self.tr("Drop a calibration file here to verify it"), wrap=True)
        choose = button(self.tr("Choose a file …"), self.tr("A calibration .json with its .sshsig beside it"))
        choose.clicked.connect(self._choose)
        row.addWidget(self.words, 1)
        row.addWidget(choose)

    def _choose(self) -> None:
        path, _ = QFileDialog.getOpenFileName(
            self, self.tr("Verify a calibration"), str(home() / "calibrations"), "*.json"
        )
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
