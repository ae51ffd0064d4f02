"""Qt's own dialog for files, wide enough for what stands in it: the names of files are what is read there."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QFileDialog, QHeaderView, QTreeView

SHARE = 3, 4  # of the window's width and height that it takes, where its own hint is less


def show_names_whole(dialog: QFileDialog) -> None:
    """Size, kind and day take what they need, and the names all that is left."""
    tree = dialog.findChild(QTreeView, "treeView")
    if tree is None:
        return  # the system's own
    header, mode = tree.header(), QHeaderView.ResizeMode
    header.setStretchLastSection(False)
    for column in range(header.count()):
        header.setSectionResizeMode(column, mode.ResizeToContents if column else mode.Stretch)
    window = dialog.parentWidget()
    if window is not None:
        part, whole = SHARE
        room = window.window().size() * part / whole
        dialog.resize(dialog.size().expandedTo(QSize(room.width(), room.height())))
