"""Items of a list whose texts take several lines, each of them whole."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QSize, Qt
from PySide6.QtWidgets import QListView, QStyledItemDelegate, QStyleOptionViewItem

AROUND_PX = 24  # what padding, margins and spacing take of an item's width; Qt reckons without them


class WholeText(QStyledItemDelegate):
    """High enough for the text as it is drawn: Qt ends the last line of what is a line too long in dots."""

    def __init__(self, view: QListView) -> None:
        super().__init__(view)
        self._view = view

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> QSize:
        """As Qt has it, or the lines that the text takes in the width there is."""
        hint, text = super().sizeHint(option, index), str(index.data(Qt.ItemDataRole.DisplayRole) or "")
        width = max(1, self._view.viewport().width() - AROUND_PX)
        lines = self._view.fontMetrics().boundingRect(0, 0, width, 0, Qt.TextFlag.TextWordWrap, text)
        return QSize(hint.width(), max(hint.height(), lines.height() + AROUND_PX // 2))
