"""F1: which keys there are. The list is read from the window's own shortcuts, so that it cannot be another one."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QDialog, QGridLayout, QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.widgets.common import button, label

NATIVE = QKeySequence.SequenceFormat.NativeText


def described(shortcut: QShortcut, words: str) -> QShortcut:
    """`shortcut` with what it does, in words: so it stands on the sheet."""
    shortcut.setWhatsThis(words)
    return shortcut


def shortcuts(window: QWidget) -> dict[str, str]:
    """By its key, what every explained shortcut of `window` does, in the order in which they were made."""
    there = window.findChildren(QShortcut)
    return {one.key().toString(NATIVE): one.whatsThis() for one in there if one.whatsThis()}


class KeySheet(QDialog):
    """Keys at the left, what they do at the right; Esc puts it away, and it stops nothing."""

    def __init__(self, parent: QWidget, keys: Iterable[tuple[str, str]]) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(self.tr("Keys"))
        column, grid = QVBoxLayout(self), QGridLayout()
        column.setContentsMargins(3 * GRID, 3 * GRID, 3 * GRID, 3 * GRID)
        column.setSpacing(2 * GRID)
        grid.setHorizontalSpacing(3 * GRID)
        grid.setVerticalSpacing(GRID)
        for row, (key, words) in enumerate(keys):
            grid.addWidget(label(key), row, 0)
            grid.addWidget(label(words), row, 1)
        column.addLayout(grid)
        close = button(self.tr("Close"), self.tr("Put this sheet away (Esc)"), primary=True)
        close.clicked.connect(self.close)
        column.addWidget(close, 0, Qt.AlignmentFlag.AlignRight)
