"""History: find a run by DUT, date, operator or verdict; the trend of a DUT's parameters; open any run read-only."""

from __future__ import annotations

import re
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QComboBox, QFileDialog, QHBoxLayout, QInputDialog, QLineEdit, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import CalibrationFile, RunLine
from labcal.gui.ipc.messages import CorrectSerial, ExportRun, ImportBundle, ListCalibrations, ListRuns
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.run_search import cells, in_order, local_time, matches
from labcal.gui.widgets.barcode_scanner import takes_scans
from labcal.gui.widgets.common import Card, button, label, shrinkable
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.idle_queue import IdleQueue
from labcal.gui.widgets.measurement_table import Table
from labcal.gui.widgets.open_externally import FolderButton
from labcal.gui.widgets.plots import apply_theme, legend_above, plot

DAY_S = 86_400.0  # a trend shows at least a day on either side
HEADINGS = ("started", "DUT", "procedure", "operator", "status", "verdict", "run")
Format = Literal["bundle", "csv", "hdf5", "mat"]
FORMATS: dict[str, Format] = {
    "Bundle (*.zip)": "bundle",
    "CSV (*.csv)": "csv",
    "HDF5 (*.h5)": "hdf5",
    "MATLAB (*.mat)": "mat",
}
PARAMETERS = {"k": (9, ("k x", "k y", "k z"), "nT"), "gain": (0, ("K xx", "K yy", "K zz"), "ppm from the first")}


class HistoryPage(QWidget):
    """The store's runs, and the calibrations of the DUT that is chosen over time."""

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state, self._theme = app_state, theme
        self.runs: tuple[RunLine, ...] = ()
        self._calibrations: tuple[CalibrationFile, ...] = ()
        self._idle_queue = IdleQueue(self)
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.setSpacing(2 * GRID)
        self.fault = FaultCard()
        self.fault.report_requested.connect(app_state.report_requested)
        column.addWidget(self.fault)
        column.addWidget(self._runs_card(), 3)
        column.addWidget(self._trend_card(), 2)
        app_state.run.ended.connect(self.refresh)

    def showEvent(self, event: object) -> None:
        """What there is now."""
        self.refresh()

    def set_theme(self, theme: Theme) -> None:
        """The trend in the theme's colours."""
        self._theme = theme
        apply_theme(self.plot, theme)
        self._idle_queue.add(self._draw)

    def refresh(self) -> None:
        """Ask for runs and calibrations again."""
        self._app_state.quick_worker.request(ListRuns(), self._runs_known, self.fault.show_fault)
        self._app_state.quick_worker.request(ListCalibrations(), self._calibrations_known, self.fault.show_fault)

    def _runs_card(self) -> Card:
        card = Card(self.tr("Runs"))
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Search: DUT, day …"))
        self.search.setToolTip(self.tr("Several words narrow it down: EM-07 yesterday explained; or 22.11.2026"))
        self.search.setClearButtonEnabled(True)
        takes_scans(self.search)
        self.search.textChanged.connect(self._show)
        self.open = button(
            self.tr("Open"), self.tr("Look at this run on the Fit page; nothing recorded is ever changed"), primary=True
        )
        self.open.clicked.connect(self._open)
        self.export = button(self.tr("Export …"), self.tr("As bundle, CSV, HDF5 or MATLAB file"))
        self.export.clicked.connect(self._export)
        self.correct = button(
            self.tr("Correct serial …"),
            self.tr("The DUT was another one: an event of the record, until a calibration of the run is signed"),
        )
        self.correct.clicked.connect(self._correct)
        take = button(self.tr("Import …"), self.tr("Take a run bundle (.zip) into the store, byte for byte"))
        take.clicked.connect(self._import)
        row = QHBoxLayout()
        row.addWidget(self.search, 1)
        for widget in (self.open, self.export, self.correct, take):
            row.addWidget(widget)
        self.said, self.folder = shrinkable(label("", "caption")), FolderButton()
        self.said.hide()
        self.table = Table(HEADINGS, stretch=6)
        self.table.itemSelectionChanged.connect(self._chosen)
        self._order = 0, True  # the column it is sorted by, and whether the largest is first
        header = self.table.horizontalHeader()
        header.setSectionsClickable(True)
        header.setSortIndicatorShown(True)
        header.setSortIndicator(0, Qt.SortOrder.DescendingOrder)
        header.sectionClicked.connect(self._sort)
        header.setToolTip(self.tr("Click to sort by this column, again to turn the order round"))
        self.table.doubleClicked.connect(self._open)
        self.empty = label(
            self.tr("No such run. A run from the Run page, or an imported bundle, comes up here."), "caption"
        )
        where = QHBoxLayout()
        where.addWidget(self.said, 1)
        where.addWidget(self.folder)
        card.body.addLayout(row)
        card.body.addLayout(where)
        card.body.addWidget(self.empty)
        card.body.addWidget(self.table, 1)
        return card

    def _trend_card(self) -> Card:
        card = Card(self.tr("Calibrations over time"), self.tr("bars: U, k=2"))
        self.trend_heading = card.heading
        self.parameter = QComboBox()
        for name in PARAMETERS:
            self.parameter.addItem(translated(name), name)
        self.parameter.setToolTip(self.tr("k: offsets in nT; gain: the diagonal of K, ppm from the first calibration"))
        self.parameter.activated.connect(self._draw)
        self.plot = plot(self._theme, "", "")
        self.plot.getPlotItem().setAxisItems({"bottom": pg.DateAxisItem()})
        card.body.addWidget(self.parameter)
        self.none = label(
            self.tr("No calibration of this DUT yet: its parameters and their U come up here, one dot a day."),
            wrap=True,
        )
        card.body.addWidget(self.none)
        card.body.addWidget(self.plot, 1)
        card.body.addStretch()
        return card

    def chosen(self) -> RunLine | None:
        """The run that is chosen."""
        items = self.table.selectedItems()
        run_id = self.table.item(items[0].row(), 6) if items else None
        return next((one for one in self.runs if run_id is not None and one.run_id == run_id.text()), None)

    def _runs_known(self, runs: tuple[RunLine, ...]) -> None:
        self.runs = runs
        self._app_state.path.take_runs(runs)
        self._show()

    def _calibrations_known(self, files: tuple[CalibrationFile, ...]) -> None:
        self._calibrations = files
        self._idle_queue.add(self._draw)

    def _show(self) -> None:
        now, chosen = datetime.now().astimezone(), self.chosen()
        found = [one for one in self.runs if matches(one, self.search.text(), now)]
        found = in_order(found, *self._order)
        self.empty.setVisible(not found)
        self.table.setRowCount(len(found))
        for row, one in enumerate(found):
            for column, text in enumerate(cells(one)):
                tips = {0: self.tr("{0} UTC").format(one.started_utc), 4: one.status}
                self.table.set_cell(row, column, text or "–", tip=tips.get(column, ""))
        self._keep_chosen(chosen, found)
        self._chosen()

    def _keep_chosen(self, chosen: RunLine | None, found: list[RunLine]) -> None:
        """In another order the same run is chosen, where it is still there."""
        ids = [one.run_id for one in found]
        with QSignalBlocker(self.table):
            if chosen is not None and chosen.run_id in ids:
                self.table.selectRow(ids.index(chosen.run_id))
            else:
                self.table.clearSelection()

    def _sort(self, column: int) -> None:
        """By this column; a second click turns the order round."""
        at, falling = self._order
        self._order = column, (not falling if at == column else column == 0)
        order = Qt.SortOrder.DescendingOrder if self._order[1] else Qt.SortOrder.AscendingOrder
        self.table.horizontalHeader().setSortIndicator(column, order)
        self._show()

    def _chosen(self) -> None:
        one = self.chosen()
        for widget in (self.open, self.export):
            widget.setEnabled(one is not None and one.status not in ("running", "interrupted"))
        self.correct.setEnabled(one is not None and one.status not in ("running", "imported"))
        self._idle_queue.add(self._draw)

    def _correct(self) -> None:
        if (one := self.chosen()) is not None:
            title, words = self.tr("Correct the serial"), self.tr("Serial of the DUT of run {0}:").format(one.run_id)
            serial, good = QInputDialog.getText(self, title, words, text=one.dut_serial)
            if good and serial.strip() and serial.strip() != one.dut_serial:
                self.correct_serial(one.run_id, serial)

    def correct_serial(self, run: str, serial: str) -> None:
        """State another serial of the DUT of `run`, in the operator's name."""
        if refused := self._app_state.serial_objection(serial.strip()):
            return self.fault.show_fault(Fault("input", refused, self.tr("Nothing was changed.")))
        said = self.tr("Run {0}: DUT {1}").format(run, serial.strip())
        who = self._app_state.lab.state.operator

        def corrected(_: object) -> None:
            self._app_state.lab.update(message=said)
            self._app_state.store_changed.emit()
            self.refresh()

        command = CorrectSerial(run, serial, who)
        return self._app_state.quick_worker.request(command, corrected, self.fault.show_fault)

    def _open(self) -> None:
        if (one := self.chosen()) is not None and self.open.isEnabled():
            self._app_state.open_study(one.run_id)

    def _export(self) -> None:
        one = self.chosen()
        if one is None:
            return
        started = local_time(one.started_utc)
        serial = re.sub(r"[^\w.-]", "-", one.dut_serial)
        start = str(Path.home() / f"{serial}_{started:%Y-%m-%d_%H%M}_{one.procedure or 'bundle'}")
        out, kind = QFileDialog.getSaveFileName(self, self.tr("Export the run"), start, ";;".join(FORMATS))
        if out:
            self.export_to(one.run_id, FORMATS[kind], out)

    def export_to(self, run: str, kind: Format, out: str) -> None:
        """Write `run` to `out`, then say where it lies."""
        words = self.tr("Exported: {0}").format(out)

        def known(_: object) -> None:
            self.said.setText(words)
            self.said.show()
            self.folder.show_folder(out)
            self._app_state.lab.update(message=words)

        self._app_state.quick_worker.request(ExportRun(run, kind, out), known, self.fault.show_fault)

    def _import(self) -> None:
        path, _ = QFileDialog.getOpenFileName(self, self.tr("Import a run bundle"), "", "*.zip")
        if path:
            self._app_state.quick_worker.request(ImportBundle(path), lambda _: self.refresh(), self.fault.show_fault)

    def dut(self) -> str:
        """Of the chosen run, else the one at the top of the window."""
        one = self.chosen()
        return one.dut_serial if one is not None else self._app_state.lab.state.dut_serial

    def _draw(self) -> None:
        dut = self.dut()
        mine = [c for c in reversed(self._calibrations) if c.dut.serial == dut]
        self.trend_heading.setText(self.tr("Calibrations of {0}").format(dut or "–"))
        self.plot.clear()
        for widget, shown in ((self.none, not mine), (self.plot, bool(mine)), (self.parameter, bool(mine))):
            widget.setVisible(shown)
        times = [self._when(one) for one in mine]
        start, names, unit = PARAMETERS[self.parameter.currentData()]
        self.plot.getPlotItem().setLabel(
            "left", f"{self.parameter.currentText()}  {translated(unit)}", color=self._theme.muted
        )
        for axis, colour in enumerate(self._theme.axes):
            self._idle_queue.put(("line", axis), partial(self._line, np.array(times), mine, start, axis, colour))
        self._idle_queue.put("range", partial(self._name_and_range, times, names))

    def _name_and_range(self, times: list[float], names: tuple[str, ...]) -> None:
        """What is drawn last: the names above, and what is seen of time and value."""
        if times:
            legend_above(self.plot, zip(names, self._theme.axes, strict=True))
            self.plot.autoRange(padding=0.1)
            if max(times) - min(times) < DAY_S:
                self.plot.setXRange(min(times) - DAY_S, max(times) + DAY_S)

    def _line(self, t: Any, files: list[CalibrationFile], start: int, axis: int, colour: str) -> None:
        if not files:
            return
        at = 9 + axis if start == 9 else 4 * axis
        flat = [[v for row in one.K for v in row] + list(one.k_nT) for one in files]
        value, U = np.array([f[at] for f in flat]), np.array([2 * one.u[at] if one.u else 0.0 for one in files])
        if start == 0:
            value, U = 1e6 * (value / value[0] - 1), 1e6 * U / abs(value[0])
        self.plot.addItem(pg.ErrorBarItem(x=t, y=value, height=2 * U, beam=0, pen=pg.mkPen(colour, width=2)))
        self.plot.plot(t, value, pen=pg.mkPen(colour), symbol="o", symbolSize=7, symbolBrush=colour, symbolPen=None)

    def _when(self, one: CalibrationFile) -> float:
        started = next((run.started_utc for run in self.runs if run.run_id == one.run_id), None)
        if started is None:
            return datetime.fromtimestamp(Path(one.path).stat().st_mtime, UTC).timestamp()
        return datetime.fromisoformat(started.replace("Z", "+00:00")).timestamp()
