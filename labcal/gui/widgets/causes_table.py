"""Every cause that the loop looked at, in a table: what it takes off, the evidence for it, its verdict and why."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSignalBlocker, Qt

from labcal.gui.ipc.answers import Loop
from labcal.gui.theming.theme import Theme
from labcal.gui.viewmodels.loop_causes import (
    EVIDENCE,
    HEADINGS,
    ID,
    REASON,
    STANDINGS,
    TAKES_OFF,
    VERDICT,
    CauseRow,
    cause_rows,
    in_order,
)
from labcal.gui.widgets.sorted_table import SortedTable

SMALL = 0.85  # of letters beside others
MOST_ROWS, LEAST_ROWS = 7, 4  # that are seen at once; the others roll


class CausesTable(SortedTable):
    """The named ones first, or in the order of any column; what is chosen stays chosen."""

    def __init__(self, theme: Theme) -> None:
        super().__init__(tuple(map(str, HEADINGS)), REASON)
        self._theme = theme
        self._rows: list[CauseRow] = []
        self._order = VERDICT, False  # the column it is sorted by, and whether the largest is first
        self.setSelectionMode(SortedTable.SelectionMode.SingleSelection)
        self.setVerticalScrollMode(SortedTable.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollMode(SortedTable.ScrollMode.ScrollPerPixel)
        self.setTextElideMode(Qt.TextElideMode.ElideRight)
        self.show_rows(MOST_ROWS, LEAST_ROWS)
        self.right_heading(TAKES_OFF)
        self.horizontalHeader().moveSection(VERDICT, 0)  # where a narrow window shows it
        self.horizontalHeader().moveSection(ID, 2)  # beside the cause
        self.show_order(*self._order[:1], falling=False)
        self.sort_wanted.connect(self.sort_by)
        self.explain_heading(
            TAKES_OFF, self.tr("Off the held-out rms beside declared errors, by it alone; –: not worked out")
        )
        self.explain_heading(
            EVIDENCE, self.tr("Whether it is enough for a name; –: it is for another reason that it is not named")
        )
        self.explain_heading(ID, self.tr("What files and commands call it"))
        self.setAccessibleName(self.tr("Candidates; choose one to see what it alone would change"))

    def show_loop(self, loop: Loop, theme: Theme) -> None:
        """Its causes."""
        self._theme = theme
        self._rows = cause_rows(loop)
        self._fill()

    def changeEvent(self, event: QEvent) -> None:
        """Letters of another size: the small ones too."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._make_small()

    def sort_by(self, column: int) -> None:
        """By this column, figures from the largest; a second time turns the order round."""
        at, falling = self._order
        self._order = column, (not falling if at == column else column in (TAKES_OFF, EVIDENCE))
        self.show_order(column, falling=self._order[1])
        self._fill()

    def picked(self) -> CauseRow | None:
        """What is chosen; None where nothing is."""
        chosen = self.selectedIndexes()
        return self._rows[chosen[0].row()] if chosen and chosen[0].row() < len(self._rows) else None

    def _fill(self) -> None:
        kept = None if (chosen := self.picked()) is None else chosen.cause
        column, falling = self._order
        self._rows = in_order(self._rows, column, falling=falling)
        self.setRowCount(len(self._rows))
        for at, row in enumerate(self._rows):
            self._show_row(at, row)
        self._make_small()
        self.setColumnHidden(ID, not any(row.id for row in self._rows))
        there = [row.cause for row in self._rows]
        with QSignalBlocker(self):
            if kept in there:
                self.selectRow(there.index(kept))
            elif kept is not None:
                self.clearSelection()

    def _show_row(self, at: int, row: CauseRow) -> None:
        for column, text in enumerate(row.cells):
            inks = {VERDICT: STANDINGS[row.standing][1], ID: "muted"}
            ink = getattr(self._theme, inks.get(column, "text"))
            tip = "" if column != REASON else row.why if text in row.why else f"{text}\n{row.why}"
            self.set_cell(at, column, text, right=column == TAKES_OFF, colour=ink, tip=tip)

    def _make_small(self) -> None:
        """The ids, which are of files and not of whoever looks for the cause."""
        font = self.font()
        font.setPixelSize(max(1, round(SMALL * self.fontInfo().pixelSize())))
        for row in range(self.rowCount()):
            if (cell := self.item(row, ID)) is not None and cell.font() != font:
                cell.setFont(font)
