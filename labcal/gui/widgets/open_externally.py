"""What was written is shown by the computer's own programs: a report in its reader, a folder in the file manager."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QApplication, QLabel, QPushButton, QVBoxLayout, QWidget

from labcal.gui.translations.translate import translated
from labcal.gui.widgets.flow import Flow

MAY_BREAK = "\N{ZERO WIDTH SPACE}"  # a line may end there: a long path widens no page


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


class CopyPathButton(QPushButton):
    """The path of what was written last to the clipboard; it is not there before anything was."""

    def __init__(self) -> None:
        super().__init__()
        self.setToolTip(translated("The path of what was just written, to be pasted elsewhere"))
        self.setAutoDefault(False)
        self._path = ""
        self.clicked.connect(self._copy)
        self.hide()

    def show_path(self, written: str) -> None:
        """Offer this path; nothing where `written` is empty."""
        if written != self._path or not self.text():
            self._path = written
            self.setText(translated("Copy the path"))
        self.setVisible(bool(written))

    def _copy(self) -> None:
        QApplication.clipboard().setText(self._path)
        self.setText(translated("✓ Path copied"))


class WrittenAt(QWidget):
    """Where a file lies: its name and folder in words, and two ways there. Not in sight where there is none."""

    def __init__(self) -> None:
        super().__init__()
        self.words, self.folder, self.copy = QLabel(), FolderButton(), CopyPathButton()
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setWordWrap(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.words)
        column.addLayout(Flow(self.folder, self.copy, left=True))
        self.hide()

    def show_file(self, words: str, path: str) -> None:
        """`words` with the name of the file and its folder for {0} and {1}."""
        name, folder = Path(path).name, str(Path(path).parent)
        self.words.setText(words.format(name, folder.replace("/", f"/{MAY_BREAK}")) if path else "")
        self.words.setAccessibleName(words.format(name, folder) if path else "")
        self.folder.show_folder(path)
        self.copy.show_path(path)
        self.setVisible(bool(path))
