"""Qt's own dialog for files, wide enough for what stands in it: the names of files are what is read there."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QFileDialog, QHeaderView, QTreeView

WIDE, HIGH = 0.9, 0.75  # of the window that it lies over, where its own hint is less
KIND = 2  # its column: the end of a file's name says it


def show_names_whole(dialog: QFileDialog) -> None:
    """Size and day take what they need, and the names all that is left."""
    tree = dialog.findChild(QTreeView, "treeView")
    if tree is None:
        return  # the system's own
    header, mode = tree.header(), QHeaderView.ResizeMode
    tree.setColumnHidden(KIND, True)
    header.setStretchLastSection(False)
    for column in range(header.count()):
        header.setSectionResizeMode(column, mode.ResizeToContents if column else mode.Stretch)
    if (below := dialog.parentWidget()) is not None:
        room = below.window().size()
        dialog.resize(dialog.size().expandedTo(QSize(round(WIDE * room.width()), round(HIGH * room.height()))))
