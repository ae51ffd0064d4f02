"""What was written is shown by the computer's own programs: a report in its reader, a folder in the file manager."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QPushButton

from labcal.gui.translations.translate import translated


def open_externally(path: str) -> None:
    """Have the computer open a file or a folder; where it has nothing for it, nothing happens."""
    QDesktopServices.openUrl(QUrl.fromLocalFile(path))


class FolderButton(QPushButton):
    """Opens the folder of what was written last; it is not there before anything was."""

    def __init__(self) -> None:
        super().__init__(translated("Open the folder"))
        self.setToolTip(translated("Show in the file manager what was just written"))
        self.setAutoDefault(False)
        self._folder = ""
        self.clicked.connect(lambda: open_externally(self._folder))
        self.hide()

    def show_folder(self, written: str) -> None:
        """Offer the folder of a file, or the folder itself; nothing where `written` is empty."""
        path = Path(written)
        self._folder = str(path if path.is_dir() else path.parent)
        self.setVisible(bool(written))
