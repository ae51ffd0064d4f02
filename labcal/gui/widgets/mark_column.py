"""Marks stand in a column as wide as the widest of them: in whatever letters, no name moves with its mark."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QSize
from PySide6.QtGui import QFontMetrics, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QLabel,
    QPushButton,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionButton,
    QStyleOptionViewItem,
    QStylePainter,
    QWidget,
)

from labcal.gui.widgets.grouped_list import WholeItems

BEHIND = "  "  # a mark in a list


def mark_width(metrics: QFontMetrics, marks: Iterable[str], behind: str = "") -> int:
    """In pixels, of the widest of `marks` in these letters, with what stands `behind` each."""
    return max(metrics.horizontalAdvance(mark + behind) for mark in marks)


class MarkedButton(QPushButton):
    """A name with a mark before it, or with the room of one."""

    def __init__(self, name: str, marks: Iterable[str]) -> None:
        super().__init__(name)
        self._mark, self._name, self._marks = "", name, tuple(marks)

    def set_mark(self, mark: str) -> None:
        """Another mark before the same name."""
        self._mark = mark
        self.setText(f"{mark} {self._name}".strip())

    def column(self) -> int:
        """Where its name begins, from where its mark does."""
        return mark_width(self.fontMetrics(), self._marks, " ")

    def sizeHint(self) -> QSize:
        """With the whole column."""
        letters = self.fontMetrics()
        missing = self.column() + letters.horizontalAdvance(self._name) - letters.horizontalAdvance(self.text())
        return super().sizeHint() + QSize(missing, 0)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Mark and name, each at its place."""
        option = QStyleOptionButton()
        self.initStyleOption(option)
        option.text = ""
        painter = QStylePainter(self)
        painter.drawControl(QStyle.ControlElement.CE_PushButton, option)
        option.rect = self.style().subElementRect(QStyle.SubElement.SE_PushButtonContents, option, self)
        for option.text in (self._mark, self._name):
            painter.drawControl(QStyle.ControlElement.CE_PushButtonLabel, option)
            option.rect.setLeft(option.rect.left() + self.column())
        painter.end()


class MarkLabel(QLabel):
    """A mark alone, beside the name that it is of."""

    def __init__(self, marks: Iterable[str]) -> None:
        super().__init__()
        self._marks = tuple(marks)

    def sizeHint(self) -> QSize:
        """As wide as the widest, and a pixel for what was rounded."""
        return QSize(mark_width(self.fontMetrics(), self._marks) + 1, super().sizeHint().height())

    def minimumSizeHint(self) -> QSize:
        """The same."""
        return self.sizeHint()


class MarkedItems(WholeItems):
    """Items of a list: what stands before the first two blanks is the mark."""

    def __init__(self, parent: QWidget, marks: Iterable[str]) -> None:
        super().__init__(parent)
        self._marks = tuple(marks)

    def initStyleOption(self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> None:
        """The name alone."""
        super().initStyleOption(option, index)
        mark, name = _parted(option.text)
        option.text = name if mark else option.text

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> QSize:
        """As high as the lines of its name are beside the column."""
        mark, _ = _parted(str(index.data()))
        column = self._column(option) if mark else 0
        option.rect.adjust(column, 0, 0, 0)
        return super().sizeHint(option, index) + QSize(column, 0)

    def paint(
        self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        """Mark and name, each at its place."""
        mark, _ = _parted(str(index.data()))
        if not mark:
            return super().paint(painter, option, index)
        alone = QStyleOptionViewItem(option)
        QStyledItemDelegate.initStyleOption(self, alone, index)
        alone.text = mark
        widget = option.widget
        widget.style().drawControl(QStyle.ControlElement.CE_ItemViewItem, alone, painter, widget)
        option.rect.adjust(self._column(option), 0, 0, 0)
        return super().paint(painter, option, index)

    def _column(self, option: QStyleOptionViewItem) -> int:
        return mark_width(option.fontMetrics, self._marks, BEHIND)


def _parted(text: str) -> tuple[str, str]:
    """Mark and name; no mark where there is none."""
    mark, apart, name = text.partition(BEHIND)
    return (mark, name) if apart else ("", text)
