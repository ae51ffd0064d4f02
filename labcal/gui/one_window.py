"""One window on one home: who starts a second one has the first brought to the front, and talks to no line.

The lock is a file that names its process, and is nobody's once that is gone, however it went.
"""

from __future__ import annotations

import os
from contextlib import suppress

from PySide6.QtCore import QFileSystemWatcher, QLockFile, QObject, Qt, Signal
from PySide6.QtWidgets import QWidget

from labcal.files.home import home, own_folder

FOLDER, LOCK, KNOCK = "window-open", "lock", "knock"


class OneWindow(QObject):
    """Held from `take` until the process ends. `knocked`: somebody has started another one."""

    knocked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._folder = own_folder(own_folder(home()) / FOLDER)
        self._lock = QLockFile(str(self._folder / LOCK))
        self._lock.setStaleLockTime(0)  # a window may be open for weeks: only that its process is gone frees it
        self._watcher = QFileSystemWatcher(self)
        self._watcher.directoryChanged.connect(self._look)

    def take(self) -> str:
        """Be the one window; returns why this cannot be: that another one is open, which comes to the front. "" else.

        Where no lock can be kept at all nobody is kept out.
        """
        if self._lock.tryLock(0):
            self._look()
            self._watcher.addPath(str(self._folder))
            return ""
        if self._lock.error() != QLockFile.LockError.LockFailedError:
            return ""
        with suppress(OSError):
            (self._folder / KNOCK).touch(mode=0o600)
        return f"a window is open already ({self._who()}) and comes to the front; this one is not opened."

    def _who(self) -> str:
        pid, host, _ = self._lock.getLockInfo()
        return f"process {pid} on {host}" if pid else f"it holds {self._folder / LOCK}"

    def _look(self) -> None:
        knock = self._folder / KNOCK
        if not os.path.lexists(knock):
            return
        with suppress(OSError):
            knock.unlink()
        self.knocked.emit()

    def let_go(self) -> None:
        """The next one may open."""
        self._lock.unlock()


def to_front(window: QWidget) -> None:
    """Have it seen, wherever it was: small, behind others, or in the tray."""
    window.setWindowState(window.windowState() & ~Qt.WindowState.WindowMinimized)
    window.show()
    window.raise_()
    window.activateWindow()
