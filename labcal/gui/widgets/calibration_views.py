"""What of a calibration stands in its table, a few figures at a time.

First its figures in short, then the specification's lines and what changed since before; behind them, for who wants
them, the map, what is corrected beside it, and what makes each uncertainty.
"""

from __future__ import annotations

from PySide6.QtWidgets import QTabBar, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import CalibrationFile
from labcal.gui.theming.theme import Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.calibration_rows import (
    PARAMETERS,
    Cell,
    budget_rows,
    cause_rows,
    map_rows,
    short_remark,
    short_rows,
)
from labcal.gui.viewmodels.conformity import (
    CHANGES,
    SPECIFICATION,
    change_rows,
    rule_of,
    specification_rows,
    verdict,
)
from labcal.gui.widgets.common import label
from labcal.gui.widgets.measurement_table import Table
from labcal.uncertainty.conformity import Changes

SPECIFIED, CHANGED, MAP, CAUSES, BUDGET = 1, 2, 3, 4, 5  # tabs beside the figures in short


class CalibrationViews(QWidget):
    """Tabs above `table`, those that have something to show; the second one's name says what the lines come to.

    `remark`, to be put below the table, says by which rule was decided, or what changed most.
    """

    def __init__(self, table: Table, theme: Theme) -> None:
        super().__init__()
        self._table, self._theme = table, theme
        self._one: CalibrationFile | None = None
        self._changes: Changes | None = None
        self.tabs, self.remark = QTabBar(), label("", "caption", wrap=True)
        self.tabs.setAccessibleName(self.tr("What of the calibration is shown"))
        self.tabs.setDrawBase(False)
        self.tabs.setExpanding(False)
        names = self.tr("In short"), verdict(()), self.tr("As found, as left")
        for name in (*names, self.tr("Map"), self.tr("Causes"), self.tr("Uncertainty")):
            self.tabs.addTab(name)
        self.tabs.currentChanged.connect(self.show_view)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.tabs)
        self.missing = label("", "caption", wrap=True)
        column.addWidget(self.missing)

    def set_theme(self, theme: Theme) -> None:
        """Results in the theme's colours."""
        self._theme = theme
        self.show_view()

    def show_calibration(self, one: CalibrationFile) -> None:
        """Show another calibration; what changed before it is not known yet."""
        another = self._one is None or self._one.path != one.path
        self._one = one
        if another:
            self.show_changes(one.path, None)
        self.tabs.setTabText(SPECIFIED, verdict(one.specification))
        for at, rows in ((CAUSES, cause_rows(one)), (BUDGET, one.budget)):
            self._offer(at, bool(rows))
        self._offer(SPECIFIED, bool(one.specification or one.left_open))
        self.show_view()

    def _offer(self, at: int, there: bool) -> None:
        """A tab only where it shows something; what there is not is said below, with the reason."""
        self.tabs.setTabEnabled(at, there)
        self.tabs.setTabVisible(at, there)
        reasons = {
            SPECIFIED: self.tr("No specification was stated for this run."),
            CHANGED: self.tr("This DUT has no earlier calibration."),
        }
        self.missing.setText(" ".join(said for n, said in reasons.items() if not self.tabs.isTabEnabled(n)))
        self.missing.setVisible(bool(self.missing.text()))

    def show_changes(self, path: str, found: Changes | None) -> None:
        """What changed since the calibration before the one at `path`, if that is shown; nothing where none is."""
        if self._one is None or self._one.path != path:
            return
        self._changes = found
        self._offer(CHANGED, found is not None)
        moved = 0 if found is None else sum(row.changed for row in found.rows)
        name = self.tr("As found, as left")
        self.tabs.setTabText(CHANGED, f"▲ {name}: {translated('{0} changed').format(moved)}" if moved else name)
        self.show_view()

    def show_view(self) -> None:
        """The table of the chosen tab."""
        one, at = self._one, self.tabs.currentIndex()
        if one is None:
            return
        self._table.clearContents()
        if at == CHANGED and self._changes is not None:
            remark = " ".join(map(in_words, (self._changes.in_words(), *self._changes.remarks)))
            self._show_rows(CHANGES, change_rows(self._changes), remark)
        elif at == SPECIFIED:
            remark = " ".join((rule_of(one.specification), *one.left_open))
            self._show_rows(SPECIFICATION, specification_rows(one.specification), remark)
        else:
            makes = {MAP: map_rows, CAUSES: cause_rows}.get(at, short_rows)
            remark = short_remark(one) if makes is short_rows and at != BUDGET else ""
            self._show_rows(PARAMETERS, budget_rows(one.budget) if at == BUDGET else makes(one), remark)

    def _show_rows(self, headings: tuple[str, ...], rows: list[list[Cell]], remark: str = "") -> None:
        self._table.set_headings(headings)
        self._table.right_heading(*(column for column, cell in enumerate(rows[0] if rows else []) if cell.right))
        self._table.setRowCount(len(rows))
        for row, cells in enumerate(rows):
            for column, cell in enumerate(cells):
                colour = getattr(self._theme, cell.state) if cell.state else ""
                self._table.set_cell(row, column, cell.text, right=cell.right, colour=colour, tip=cell.tip)
        self.remark.setText(remark)
        self.remark.setVisible(bool(remark))
