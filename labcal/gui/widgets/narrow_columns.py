"""What a table does where there is no room for all of it: columns go, the least important first, and words wrap."""

from __future__ import annotations

from collections.abc import Collection

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHeaderView, QTableWidget

WRAPPED_PX = 144  # of a column that wraps its words, where others can go to give it that
PADDING_PX = 26  # of a cell by the style sheet, and what Qt keeps beside it


class NarrowColumns:
    """Of one table: `goes` are columns, the first goes first; `wraps` those whose words take several lines."""

    def __init__(self, table: QTableWidget, goes: tuple[int, ...], wraps: tuple[int, ...] = ()) -> None:
        self._table, self._goes, self._wraps = table, goes, wraps
        self._headings = dict[int, int]()  # [px], as they were when they were seen
        self._empty: Collection[int] = ()

    def leave_out(self, empty: Collection[int]) -> None:
        """These say nothing, whatever room there is."""
        self._empty = empty
        self.let_go()

    def let_go(self) -> None:
        """Hide what there is no room for, and show what there is."""
        table = self._table
        needed = {n: self._needed(n) for n in range(table.columnCount()) if n not in self._empty}
        hidden = set(self._empty)
        for column in self._goes:
            if sum(needed.values()) <= table.viewport().width():
                break
            needed.pop(column, None)
            hidden.add(column)
        for column in self._goes:
            if table.isColumnHidden(column) is not (column in hidden):
                table.setColumnHidden(column, column in hidden)

    def share(self) -> None:
        """The first that wraps has what its words need, up to half of the room for those that wrap."""
        header, others = self._table.horizontalHeader(), range(self._table.columnCount())
        if self._wraps:
            first = self._wraps[0]
            room = self._table.viewport().width() - sum(header.sectionSize(n) for n in others if n not in self._wraps)
            least, words = header.sectionSizeHint(first), self._table.sizeHintForColumn(first)
            header.setSectionResizeMode(first, QHeaderView.ResizeMode.Interactive)
            header.resizeSection(first, max(least, min(words, room // 2)))

    def fit_rows(self) -> None:
        """Each as high as the lines of its words."""
        table, one_line = self._table, self._table.verticalHeader().defaultSectionSize()
        around = one_line - table.fontMetrics().height()
        for row in range(table.rowCount() if self._wraps else 0):
            lines = max(self._lines_px(row, column) for column in self._wraps)
            table.setRowHeight(row, max(one_line, lines + around))

    def _lines_px(self, row: int, column: int) -> int:
        cell, width = self._table.item(row, column), max(1, self._table.columnWidth(column) - PADDING_PX)
        flags = int(Qt.TextFlag.TextWordWrap)
        words = "" if cell is None else cell.text()
        return self._table.fontMetrics().boundingRect(0, 0, width, 0, flags, words).height()

    def _needed(self, column: int) -> int:
        """In pixels: of its heading and of its words, or of as much of these as is for what wraps."""
        header, words = self._table.horizontalHeader(), self._table.sizeHintForColumn(column)
        if not header.isSectionHidden(column):
            self._headings[column] = header.sectionSizeHint(column)
        return max(self._headings.get(column, 0), min(words, WRAPPED_PX) if column in self._wraps else words)
