"""A list with headings that are not chosen: keys go past them, Home too."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QSize, Qt
from PySide6.QtWidgets import QAbstractItemView, QListWidget, QStyledItemDelegate, QStyleOptionViewItem

from labcal.gui.theming.theme import ITEM_PX


class WholeItems(QStyledItemDelegate):
    """Items with the lines that they have within the style sheet's padding; Qt counts them for the whole width."""

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> QSize:
        """As high as its lines are."""
        option.rect.adjust(0, 0, -2 * ITEM_PX, 0)
        return super().sizeHint(option, index)


class GroupedList(QListWidget):
    """As a QListWidget, which stays where it is when a key would lead it to a heading."""

    def __init__(self) -> None:
        super().__init__()
        self.setWordWrap(True)  # a heading that is too long for its line takes two
        self.setResizeMode(QListWidget.ResizeMode.Adjust)
        self.setItemDelegate(WholeItems(self))

    def moveCursor(self, action: QAbstractItemView.CursorAction, modifiers: Qt.KeyboardModifier) -> QModelIndex:
        """Where a key leads to; from a heading on to what is below it."""
        index = super().moveCursor(action, modifiers)
        below = range(max(index.row(), 0), self.count())
        return next((self.indexFromItem(self.item(row)) for row in below if self._may_be_chosen(row)), index)

    def _may_be_chosen(self, row: int) -> bool:
        item = self.item(row)
        return bool(item.flags() & Qt.ItemFlag.ItemIsEnabled) and not item.isHidden()
