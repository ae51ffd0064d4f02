"""The measurements of a run: value ± U (k = 2), limit, and the verdict in word, shape and colour."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QEvent, QSize, Qt, QTimer
from PySide6.QtGui import QBrush, QColor, QKeySequence, QResizeEvent, QShortcut
from PySide6.QtWidgets import QAbstractItemView, QApplication, QHeaderView, QTableWidget, QTableWidgetItem

from labcal.gui.theming.theme import GRID, STATES, Theme
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import decimals_for, format_number, short_number, step_title
from labcal.gui.widgets.common import Card, plain, tabular_font
from labcal.gui.widgets.key_sheet import described
from labcal.record.stream import Measurement

NAME_PX = LEAST_PX = 18 * GRID  # of a name, and of the card
NAME_PADDING_PX = 26  # of a cell by the style sheet, and what Qt keeps beside it
QWIDGETSIZE_MAX = 16_777_215  # Qt's word for no limit
FEWEST_ROWS = 5  # of a table as high as its rows are always to be seen
RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class Table(QTableWidget):
    """A read-only table with named columns; Ctrl+C copies what is selected, with tabs."""

    def __init__(self, headings: tuple[str, ...], *stretch: int) -> None:
        super().__init__(0, len(headings))
        self._headings: tuple[str, ...] = ()
        self._rows_shown = self._least = 0
        self.set_headings(headings)
        self.verticalHeader().hide()
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setTabKeyNavigation(False)
        self.setWordWrap(False)
        self.setFont(tabular_font())
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self._stretched, self._keeping = stretch, False
        for column in self._stretched:
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Stretch)
        if not stretch:  # figures stand beside their names: what room is left is behind the last column
            header.setStretchLastSection(True)
        if stretch:  # what is left may be too little
            self._written = QTimer(self, interval=0, singleShot=True)  # once for many cells
            self._written.timeout.connect(self._keep_headings)
            for changed in (header.sectionResized, header.geometriesChanged):
                changed.connect(self._keep_headings)
            self.itemChanged.connect(lambda _: self._written.start())
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        copy = QShortcut(QKeySequence.StandardKey.Copy, self, self.copy, context=Qt.ShortcutContext.WidgetShortcut)
        described(copy, self.tr("in a table: its chosen rows to the clipboard, or all"))

    def show_rows(self, most: int, least: int = FEWEST_ROWS) -> None:
        """Be as high as the rows that there are, up to `most`; with less room roll, down to `least`."""
        self._rows_shown, self._least = most, least
        for changed in (self.model().rowsInserted, self.model().rowsRemoved):
            changed.connect(lambda *_: self.updateGeometry())

    def end_with_rows(self) -> None:
        """Have no frame around the place of rows that there are not, however much room there is."""
        headers = self.horizontalHeader().geometriesChanged, self.verticalHeader().geometriesChanged
        for changed in (self.model().rowsInserted, self.model().rowsRemoved, *headers):
            changed.connect(lambda *_: self.setMaximumHeight(self._height_of(self.rowCount())))

    def sizeHint(self) -> QSize:
        """Room for the rows that are to be seen."""
        return QSize(super().sizeHint().width(), self._height_of(self._rows_shown) or super().sizeHint().height())

    def minimumSizeHint(self) -> QSize:
        """Room for a few of them."""
        least = self._height_of(min(self._rows_shown, self._least))
        return QSize(super().minimumSizeHint().width(), least or super().minimumSizeHint().height())

    def _height_of(self, most: int) -> int:
        if not self._rows_shown:
            return 0
        rows = min(most, self.rowCount())
        within = self.horizontalHeader().sizeHint().height() + rows * self.verticalHeader().defaultSectionSize()
        return within + 2 * self.frameWidth() + self.horizontalScrollBar().sizeHint().height()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """More room, or less, is shared anew."""
        super().resizeEvent(event)
        if self._stretched:
            self._keep_headings()

    def _keep_headings(self) -> None:
        """What takes the room that is left takes no less than its heading needs; all of it where the table rolls."""
        header, mode = self.horizontalHeader(), QHeaderView.ResizeMode
        if self._keeping:
            return
        self._keeping = True
        needed = {column: header.sectionSizeHint(column) for column in self._stretched}
        room = self.viewport().width() - sum(header.sectionSize(n) for n in range(header.count()) if n not in needed)
        whole = room // len(needed) >= max(needed.values())
        for column, width in needed.items():
            header.setSectionResizeMode(column, mode.Stretch if whole else mode.Interactive)
            if not whole:
                room -= width
                least = width + (max(0, room) if column == self._stretched[-1] else 0)
                header.resizeSection(column, max(least, min(self.sizeHintForColumn(column), self.viewport().width())))
        self._keeping = False

    def set_headings(self, headings: tuple[str, ...]) -> None:
        """Name the columns, as many as there are names."""
        if headings != self._headings:
            self._headings = headings
            self.setColumnCount(len(headings))
            self.setHorizontalHeaderLabels([translated(heading) for heading in headings])

    def set_cell(
        self, row: int, column: int, text: str, *, right: bool = False, colour: str = "", tip: str = ""
    ) -> None:
        """Write one cell; numbers stand right in figures of one width."""
        cell = self.item(row, column)
        if cell is None:
            cell = QTableWidgetItem()
            self.setItem(row, column, cell)
        if cell.text() != text:
            cell.setText(text)
        cell.setToolTip(plain(tip or text))
        if right:
            cell.setTextAlignment(RIGHT)
        if colour:
            cell.setForeground(QBrush(QColor(colour)))

    def right_heading(self, *columns: int) -> None:
        """Headings over numbers stand right, as the numbers do; a last column of them is no wider than they are."""
        if not self._stretched:
            self.horizontalHeader().setStretchLastSection(self.columnCount() - 1 not in columns)
        for column in columns:
            if (heading := self.horizontalHeaderItem(column)) is not None:
                heading.setTextAlignment(RIGHT)

    def explain_heading(self, column: int, tip: str) -> None:
        """What a column says, for who rests the mouse on its heading."""
        if (heading := self.horizontalHeaderItem(column)) is not None:
            heading.setToolTip(tip)

    def copy(self) -> None:
        """Selected rows to the clipboard, or all where none is."""
        rows = sorted({i.row() for i in self.selectedIndexes()}) or range(self.rowCount())
        lines = ["\t".join(translated(heading) for heading in self._headings)]
        lines += ["\t".join(self.text(row, c) for c in range(self.columnCount())) for row in rows]
        QApplication.clipboard().setText("\n".join(lines))

    def text(self, row: int, column: int) -> str:
        """What stands in a cell."""
        cell = self.item(row, column)
        return cell.text() if cell is not None else ""


class Measurements(Table):
    """The newest on top."""

    def __init__(self, theme: Theme) -> None:
        super().__init__(("measured", "value", "U (k=2)", "unit", "limit", "verdict"))
        self.right_heading(1, 2, 4)
        self.horizontalHeader().setStretchLastSection(False)
        self.horizontalHeader().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        self.setWordWrap(True)  # names differ at their ends
        self.horizontalHeader().moveSection(5, 1)  # the verdict is seen in a narrow window too
        self.horizontalHeader().sectionResized.connect(self._fit_rows)
        self._theme = theme
        self._shown: tuple[Theme, list[Measurement]] | None = None

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Where there is no room for all columns, names keep some of it and the limit is scrolled to."""
        super().resizeEvent(event)
        header, mode = self.horizontalHeader(), QHeaderView.ResizeMode
        others = sum(header.sectionSize(column) for column in range(1, self.columnCount()))
        narrow = self.viewport().width() - others < NAME_PX
        header.setSectionResizeMode(0, mode.Interactive if narrow else mode.Stretch)
        if narrow:
            header.resizeSection(0, NAME_PX)
        self._fit_rows()

    def changeEvent(self, event: QEvent) -> None:
        """Letters of another size."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._fit_rows()

    def _fit_rows(self) -> None:
        """Each as high as its name in the room that there is: no name is cut."""
        metrics, one_line = self.fontMetrics(), self.verticalHeader().defaultSectionSize()
        for row in range(self.rowCount()):
            width = max(1, self.columnWidth(0) - NAME_PADDING_PX)  # a higher row may have brought a scroll bar
            lines = metrics.boundingRect(0, 0, width, 0, Qt.TextFlag.TextWordWrap, self.text(row, 0))
            self.setRowHeight(row, max(one_line, lines.height() + one_line - metrics.height()))

    def set_theme(self, theme: Theme) -> None:
        """What is shown next has the theme's colours."""
        self._theme = theme

    def show_measurements(self, measurements: Iterable[Measurement]) -> None:
        """Write them all."""
        newest = list(measurements)[::-1]
        if (self._theme, newest) == self._shown:
            return  # it is asked at every word of a run
        self._shown = self._theme, newest
        self.setRowCount(len(newest))
        for row, one in enumerate(newest):
            self._show(row, one)
        self._fit_rows()

    def _show(self, row: int, one: Measurement) -> None:
        decimals = decimals_for(2 * one.u, one.value)
        self.set_cell(row, 0, step_title(one.name))
        self.set_cell(row, 1, format_number(one.value, decimals), right=True)
        self.set_cell(row, 2, format_number(2 * one.u, decimals, signed=False) if one.u > 0 else "–", right=True)
        self.set_cell(row, 3, one.unit)
        self.set_cell(row, 4, short_number(one.limit), right=True)
        shape, state = STATES.get(one.verdict, ("", "text"))
        self.set_cell(row, 5, f"{shape} {translated(one.verdict)}".strip() or "–", colour=getattr(self._theme, state))


class MeasuredCard(Card):
    """The table alone on a card, a few rows of it always in sight, and the newest however many lines it has."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self.table = Measurements(theme)
        self.setMinimumHeight(LEAST_PX)
        self.body.addWidget(self.table, 1)
        self.body.addStretch()
        self.table.verticalHeader().geometriesChanged.connect(self._end_with_a_row)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """As many rows as there is room for."""
        super().resizeEvent(event)
        self._end_with_a_row()

    def _end_with_a_row(self) -> None:
        """The last row in sight is a whole one."""
        table, margins = self.table, self.layout()
        around = 0 if margins is None else margins.contentsMargins().top() + margins.contentsMargins().bottom()
        bar = table.horizontalScrollBar()
        high = table.horizontalHeader().height() + 2 * table.frameWidth() + (bar.height() if bar.isVisible() else 0)
        least = around + high + (table.rowHeight(0) if table.rowCount() else 0)
        self.setMinimumHeight(max(LEAST_PX, least))
        room, row = self.height() - around, 0
        while row < table.rowCount() and high + table.rowHeight(row) <= room:
            high, row = high + table.rowHeight(row), row + 1
        table.setMaximumHeight(high if row < table.rowCount() else QWIDGETSIZE_MAX)
