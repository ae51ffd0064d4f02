"""F1: which keys there are. The list is read from the window's own shortcuts, so that it cannot be another one."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QDialog, QGridLayout, QScrollArea, QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.widgets.common import button, label

WIDEST = 100  # letters of a line
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
        column, grid, holder = QVBoxLayout(self), QGridLayout(), QWidget()
        column.setContentsMargins(3 * GRID, 3 * GRID, 3 * GRID, 3 * GRID)
        column.setSpacing(2 * GRID)
        grid.setHorizontalSpacing(3 * GRID)
        grid.setVerticalSpacing(GRID)
        column.addWidget(label(self.tr("Keys"), "large"))  # not every desktop gives a sheet a title
        waits = self.tr("While this sheet is open no key answers a question; COILS OFF (F12) works.")
        column.addWidget(label(waits, "caption", wrap=True))
        for row, (key, words) in enumerate(keys):
            grid.addWidget(label(key), row, 0, Qt.AlignmentFlag.AlignTop)
            grid.addWidget(label(words, wrap=True), row, 1)
        grid.setColumnStretch(1, 1)
        grid.setContentsMargins(0, 0, 0, 0)
        rows = QVBoxLayout(holder)
        rows.setContentsMargins(0, 0, GRID, 0)
        rows.addLayout(grid)
        rows.addStretch()
        self.area = QScrollArea()
        self.area.setWidget(holder)
        self.area.setWidgetResizable(True)
        self.area.setFrameShape(QScrollArea.Shape.NoFrame)
        self.area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.area.viewport().setAutoFillBackground(False)
        holder.setAutoFillBackground(False)
        column.addWidget(self.area, 1)
        close = button(self.tr("Close"), self.tr("Put this sheet away (Esc)"), primary=True)
        close.clicked.connect(self.close)
        column.addWidget(close, 0, Qt.AlignmentFlag.AlignRight)
        self._holder, self._column = holder, column
        self.area.setFocus()  # the arrows roll it

    def fit_into(self, room: QSize) -> None:
        """As large as it would be, no larger than `room`: words go on in a next line, and what is more is rolled."""
        self.ensurePolished()
        within = room - QSize(4 * GRID, 4 * GRID)
        width = min(within.width(), WIDEST * self.fontMetrics().averageCharWidth())
        self.resize(width, within.height())
        self._column.activate()
        rows = self._holder.heightForWidth(self.area.viewport().width())
        self.resize(width, min(within.height(), self.height() - self.area.height() + rows))
