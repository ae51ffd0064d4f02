"""Asks for a folder: one that is there, or a new one whose name is typed."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QFileDialog, QLineEdit, QWidget


class FolderDialog(QFileDialog):
    """Qt's own takes the name of a new one, and then none that is there: its button is grey, and Enter goes into it."""

    def __init__(self, parent: QWidget, title: str, accept: str, name: str) -> None:
        super().__init__(parent, title)
        self.setFileMode(QFileDialog.FileMode.AnyFile)
        self.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        self.setOption(QFileDialog.Option.DontUseNativeDialog)
        self.setOption(QFileDialog.Option.ShowDirsOnly)
        self.setOption(QFileDialog.Option.DontConfirmOverwrite)  # nothing in a folder that is there is written over
        self.setLabelText(QFileDialog.DialogLabel.Accept, accept)
        self.setDirectory(str(Path.home()))
        self.selectFile(name)
        self._typed = self.findChild(QLineEdit, "fileNameEdit")
        if self._typed is not None:
            self._typed.textChanged.connect(lambda _: QTimer.singleShot(0, self, self._let_accept))

    def folder(self) -> str:
        """What is typed, in the folder that is open; that one where nothing is."""
        typed = "" if self._typed is None else self._typed.text().strip()
        return str(Path(self.directory().absolutePath()) / Path(typed).expanduser())

    def accept(self) -> None:
        """One that is there is taken, and not gone into."""
        QDialog.accept(self) if Path(self.folder()).is_dir() else super().accept()

    def _let_accept(self) -> None:
        box = self.findChild(QDialogButtonBox)
        button = None if box is None else box.button(QDialogButtonBox.StandardButton.Save)
        if button is not None and Path(self.folder()).is_dir():
            button.setEnabled(True)
