"""Paper: a PDF is given to the computer's own printing, by its program `lp`, on Windows by what prints PDFs there.

Where nothing of that is there, or no printer, the file is opened instead, and that is said.
"""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

from PySide6.QtCore import QObject, QProcess, QTemporaryDir, Signal

from labcal.gui.ipc.environment import child_environment
from labcal.gui.widgets.open_externally import open_externally

PROGRAM = "lp"  # of CUPS, on Linux and macOS


class Printer(QObject):
    """Prints files; `said` tells what came of it."""

    said = Signal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._folder = QTemporaryDir()

    def file(self, source: str, what: str) -> str:
        """Where to write what is to be printed of `source`: gone when the window is."""
        return str(Path(self._folder.path()) / f"{Path(source).stem}-{what}.pdf")

    def print_file(self, path: str, done: str) -> None:
        """Print the PDF at `path`, and say `done`; nothing waits for it."""
        if sys.platform == "win32":
            return self._by_windows(path, done)
        program = shutil.which(PROGRAM)
        if program is None:
            return self._open(path, self.tr("this computer has no program {0}").format(PROGRAM))
        process = QProcess(self)
        process.setProcessEnvironment(child_environment())
        process.finished.connect(lambda code, _: self._finished(process, code, path, done))
        process.start(program, [path])
        return None

    def _finished(self, process: QProcess, code: int, path: str, done: str) -> None:
        why = bytes(process.readAllStandardError().data()).decode(errors="replace").strip().splitlines()
        process.deleteLater()
        if code == 0:
            return self.said.emit(done)
        return self._open(path, why[-1] if why else self.tr("{0} ended with {1}").format(PROGRAM, code))

    def _by_windows(self, path: str, done: str) -> None:
        if sys.platform == "win32":
            try:
                os.startfile(path, "print")
            except OSError as error:
                return self._open(path, str(error))
        return self.said.emit(done)

    def _open(self, path: str, why: str) -> None:
        open_externally(path)
        self.said.emit(self.tr("Not printed ({0}): opened, to be printed from there.").format(why))
