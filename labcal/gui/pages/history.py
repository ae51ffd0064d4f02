"""History: find a run by DUT, date, operator or verdict; the trend of a DUT's parameters; open any run read-only."""

from __future__ import annotations

from datetime import datetime
from functools import cached_property
from pathlib import Path

from PySide6.QtCore import QItemSelectionModel, QSignalBlocker
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QInputDialog, QLineEdit, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import CalibrationFile, Comparison, RunLine
from labcal.gui.ipc.messages import CompareRuns, CorrectSerial, ExportRun, ImportBundle, ListCalibrations, ListRuns
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.comparable import in_full, run_key, why_not_compared
from labcal.gui.viewmodels.export_formats import FORMATS, Format
from labcal.gui.viewmodels.run_count import count_words
from labcal.gui.viewmodels.run_results import RunResults
from labcal.gui.viewmodels.run_search import HEADINGS, NOT_WHOLE, OF_ARCHIVE, file_name, measured_s, moment_s, rows_of
from labcal.gui.viewmodels.signing import doubtful
from labcal.gui.widgets.barcode_scanner import takes_scans
from labcal.gui.widgets.common import Card, FaceStack, button, combo_box, label, set_state, shrinkable
from labcal.gui.widgets.comparison import ComparisonView
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.idle_queue import IdleQueue
from labcal.gui.widgets.open_externally import FolderButton
from labcal.gui.widgets.record_words import RecordWords
from labcal.gui.widgets.recording_view import RecordingView
from labcal.gui.widgets.sorted_table import SortedTable
from labcal.gui.widgets.trend import Trend


class HistoryPage(QWidget):
    """The runs of the store, or of the archive, and the calibrations of the DUT that is chosen over time."""

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state, self._theme = app_state, theme
        self._archived = app_state.archived
        self.runs: tuple[RunLine, ...] = ()
        self._found: list[RunLine] = []
        self._compared: CompareRuns | None = None
        self._idle_queue, self.results = IdleQueue(self), RunResults(app_state.quick_worker, app_state.path.results)
        self.results.changed.connect(self._show)
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.setSpacing(2 * GRID)
        self.fault = FaultCard()
        self.fault.report_requested.connect(app_state.report_requested)
        column.addWidget(self.fault)
        self.faces = FaceStack()
        column.addWidget(self.faces)
        self.faces.addWidget(self._list(theme))
        app_state.run.ended.connect(self.refresh)
        self._archived.changed.connect(lambda: self._show() if self.of_archive else None)

    def showEvent(self, event: object) -> None:
        """What there is now."""
        self.refresh()

    def set_theme(self, theme: Theme) -> None:
        """Trend and comparison in the theme's colours."""
        self._theme = theme
        self.trend.set_theme(theme)
        self.comparison.set_theme(theme)
        self.recording.set_theme(theme)
        self._idle_queue.add(self._show)

    def build_more(self) -> bool:
        """Build another part of what compares two runs; says whether any was missing."""
        if self.faces.count() > 1:
            return self.comparison.loci.build_more()
        return self.comparison is not None

    @cached_property
    def recording(self) -> RecordingView:
        """A recording of others and its mapping, before it is a run."""
        made = RecordingView(self._app_state, self._theme)
        made.left.connect(lambda: self.faces.setCurrentIndex(0))
        made.imported.connect(self._imported)
        self.faces.addWidget(made)
        return made

    @cached_property
    def comparison(self) -> ComparisonView:
        """Two runs beside each other."""
        made = ComparisonView(self._theme)
        made.left.connect(lambda: self.faces.setCurrentIndex(0))
        self.faces.addWidget(made)
        return made

    def refresh(self) -> None:
        """Ask for runs and calibrations again."""
        self._app_state.quick_worker.request(ListRuns(), self._runs_known, self.fault.show_fault)
        self._app_state.quick_worker.request(ListCalibrations(), self._calibrations_known, self.fault.show_fault)
        if self.of_archive:
            self._archived.ask()

    @property
    def of_archive(self) -> bool:
        """Whether it is the archive that is looked at: there is nothing to be written then."""
        return bool(self.place.currentIndex())

    def _choose_place(self) -> None:
        """This computer, or the archive: what there can be done with a run there is shown."""
        for widget in (self.open, self.compare, self.correct, self.take):
            widget.setVisible(not self.of_archive)
        self.export.setToolTip(self._export_tip())
        self.table.set_headings(OF_ARCHIVE if self.of_archive else HEADINGS)
        self.said.hide()
        self.folder.hide()
        self.refresh()
        self._show()

    def _export_tip(self) -> str:
        if self.of_archive:
            return self.tr("The bundle as it was pushed (.zip): import it on this computer to open it")
        return self.tr("As bundle, CSV, HDF5 or MATLAB file; of several runs a bundle each")

    def _list(self, theme: Theme) -> QWidget:
        """The runs, and below them the trend of the DUT that is chosen."""
        holder, self.trend = QWidget(), Trend(theme)
        column = QVBoxLayout(holder)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2 * GRID)
        column.addWidget(self._runs_card(), 3)
        column.addWidget(self.trend, 2)
        return holder

    def _runs_card(self) -> Card:
        card = self.card = Card(self.tr("Runs"))
        self.place = combo_box(
            self.tr("Runs of this computer, or those of all benches in the archive, which are only looked at"),
            self.tr("Where the runs are"),
        )
        self.place.addItems([self.tr("This computer"), self.tr("Archive")])
        self.place.setVisible(self._archived.named)
        self.place.activated.connect(self._choose_place)
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
        self.export = button(self.tr("Export …"), self._export_tip())
        self.export.clicked.connect(self._export)
        self.correct = button(
            self.tr("Correct serial …"),
            self.tr("The DUT was another one: an event of the record, until a calibration of the run is signed"),
        )
        self.correct.clicked.connect(self._correct)
        self.take = button(
            self.tr("Import …"), self.tr("A run bundle (.zip) or a recording of others; or drop the file on the window")
        )
        self.take.clicked.connect(self._import)
        self._compares = self.tr("Choose two runs (Ctrl and a click): their figures, residuals and loci")
        self.compare = button(self.tr("Compare"), self._compares)
        self.compare.clicked.connect(self._compare)
        row = QHBoxLayout()
        for widget in (self.open, self.compare, self.export, self.correct, self.take):
            row.addWidget(widget)
        row.addStretch()
        self.said, self.folder = shrinkable(label("", "caption")), FolderButton()
        self.said.hide()
        self.why_not = label("", "caption", wrap=True)
        self.table = SortedTable(HEADINGS, 6)
        self.table.show_rows(10_000, 5)  # a small window rolls the page before it shows fewer
        self.table.itemSelectionChanged.connect(self._chosen)
        self._order = 0, True  # the column it is sorted by, and whether the largest is first
        header = self.table.horizontalHeader()
        for column in (4, 5):
            header.moveSection(column, column - 2)  # what came out, and became of it, where a narrow window shows it
        self.table.show_order(0, falling=True)
        self.table.sort_wanted.connect(self.sort_by)
        self.table.doubleClicked.connect(self._open)
        self.empty = label("", "caption", wrap=True)
        where = QHBoxLayout()
        where.addWidget(self.said, 1)
        where.addWidget(self.folder)
        looked = QHBoxLayout()
        looked.addWidget(self.place)
        looked.addWidget(self.search, 1)
        card.body.addLayout(looked)
        card.body.addLayout(row)
        card.body.addLayout(where)
        card.body.addWidget(self.why_not)
        card.body.addWidget(self.empty)
        card.body.addWidget(self.table, 1)
        self.told = RecordWords(self._app_state, here=True)
        card.body.addWidget(self.told)
        return card

    def chosen_runs(self) -> list[RunLine]:
        """The runs that are chosen, from the top."""
        rows = sorted({item.row() for item in self.table.selectedItems()})
        return [self._found[row] for row in rows if row < len(self._found)]

    def chosen(self) -> RunLine | None:
        """The run that is chosen, where it is one."""
        several = self.chosen_runs()
        return several[0] if len(several) == 1 else None

    def _runs_known(self, runs: tuple[RunLine, ...]) -> None:
        self.runs = runs
        self._app_state.path.take_runs(runs)
        self.results.ask(runs)
        self._show()

    def _calibrations_known(self, files: tuple[CalibrationFile, ...]) -> None:
        self._app_state.path.take_calibrations(files)
        self._show()
        self._idle_queue.add(self._draw)

    def _show(self) -> None:
        now, chosen = datetime.now().astimezone(), self.chosen_runs()
        runs = self._archived.runs if self.of_archive else self.runs
        rows = rows_of(runs, self.search.text(), now, self._app_state.path.stands, self.results.word, self._order)
        self._found = found = [row.run for row in rows]
        self._say_why_empty(found)
        self.card.unit.setText("" if self.of_archive else count_words(len(runs), len(found)))
        self.table.setRowCount(len(found))
        for row, (one, texts, state) in enumerate(rows):
            for column, text in enumerate(texts):
                tips = {0: self.tr("{0} UTC").format(one.started_utc), 4: in_full(one)}
                ink = getattr(self._theme, {4: state, 5: "warning" if doubtful(text) else ""}.get(column) or "text")
                self.table.set_cell(row, column, text or "–", colour=ink, tip=tips.get(column, ""))
        self._keep_chosen(chosen, found)
        self._chosen()

    def _say_why_empty(self, found: list[RunLine]) -> None:
        """No such run; or the archive has not answered yet, or does not."""
        fault = self._archived.fault if self.of_archive else None
        words = self.tr("No such run. A run from the Run page, or an imported bundle, comes up here.")
        if fault is not None:
            words = self.tr("The archive was not read. {0}").format(in_words(fault.text))
        elif self.of_archive:
            words = self.tr("Asking the archive …") if self._archived.asked else self.tr("The archive has no such run.")
        self.empty.setText(words)
        set_state(self.empty, "bad" if fault is not None else "")
        self.empty.setVisible(not found or fault is not None)

    def _keep_chosen(self, chosen: list[RunLine], found: list[RunLine]) -> None:
        """In another order the same runs are chosen, where they are still there."""
        keys, model = [run_key(one) for one in found], self.table.selectionModel()
        how = QItemSelectionModel.SelectionFlag.Select | QItemSelectionModel.SelectionFlag.Rows
        with QSignalBlocker(self.table):
            self.table.clearSelection()
            for one in chosen:
                if run_key(one) in keys:
                    model.select(self.table.model().index(keys.index(run_key(one)), 0), how)

    def sort_by(self, column: int) -> None:
        """By this column; a second click turns the order round."""
        at, falling = self._order
        self._order = column, (not falling if at == column else column == 0)
        self.table.show_order(column, falling=self._order[1])
        self._show()

    def _chosen(self) -> None:
        one, several = self.chosen(), self.chosen_runs()
        self.told.show_run("" if one is None or self.of_archive else one.run_id)
        self.open.setEnabled(one is not None and one.status not in NOT_WHOLE)
        self.export.setEnabled(bool(several) and all(each.status not in NOT_WHOLE for each in several))
        self._offer_comparison(several)
        self.correct.setEnabled(one is not None and one.status not in ("running", "imported"))
        self._idle_queue.add(self._draw)

    def _offer_comparison(self, several: list[RunLine]) -> None:
        """Of two whole runs; else it is said what is wrong with them."""
        wrong = why_not_compared(several)
        self.compare.setEnabled(len(several) == 2 and not wrong)
        self.why_not.setText(wrong)
        self.why_not.setVisible(bool(wrong))
        self.compare.setToolTip(wrong or self._compares)

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
        said, who = self.tr("Run {0}: DUT {1}").format(run, serial.strip()), self._app_state.lab.state.operator

        def corrected(_: object) -> None:
            self._app_state.lab.update(message=said)
            self._app_state.store_changed.emit()
            self.refresh()

        command = CorrectSerial(run, serial, who)
        return self._app_state.quick_worker.request(command, corrected, self.fault.show_fault)

    def _open(self) -> None:
        if (one := self.chosen()) is not None and self.open.isEnabled() and not self.of_archive:
            self._app_state.open_study(one.run_id)

    def _compare(self) -> None:
        """The two runs that are chosen, beside each other."""
        older, newer = sorted(self.chosen_runs(), key=lambda one: one.started_utc)
        self.comparison.wait_for(self.tr("Comparing {0} with {1} …").format(older.run_id, newer.run_id))
        self.faces.setCurrentWidget(self.comparison)
        command = CompareRuns(older.run_id, newer.run_id)
        self._compared = command
        self._app_state.fit_worker.request(command, lambda found: self._known(command, found), self._not_compared)

    def _known(self, command: CompareRuns, found: Comparison) -> None:
        """What was asked last is shown, and nothing that was asked before."""
        if command is self._compared:
            self.comparison.show_comparison(found, {one.run_id: one.verdict for one in self.runs if one.verdict})

    def _not_compared(self, fault: Fault) -> None:
        self.faces.setCurrentIndex(0)
        self.fault.show_fault(fault)

    def _export(self) -> None:
        one = self.chosen()
        if one is None:
            return self._export_several()
        start = str(Path.home() / file_name(one))
        kinds = [*FORMATS][:1] if self.of_archive else FORMATS
        out, kind = QFileDialog.getSaveFileName(self, self.tr("Export the run"), start, ";;".join(kinds))
        if out:
            self.export_to(one, FORMATS[kind], out)
        return None

    def _export_several(self) -> None:
        folder = QFileDialog.getExistingDirectory(self, self.tr("A bundle of each chosen run, into this folder"))
        outs = {one: Path(folder) / f"{file_name(one)}.zip" for one in self.chosen_runs()}
        there = sorted(out.name for out in outs.values() if out.exists())
        if folder and there:
            words = self.tr("{0} is there already; nothing was written.").format(there[0])
            return self.fault.show_fault(Fault("input", words, self.tr("Choose another folder.")))
        for one, out in outs.items() if folder else ():
            self.export_to(one, "bundle", str(out))
        return None

    def export_to(self, run: RunLine, kind: Format, out: str) -> None:
        """Write `run` to `out`, of the archive the bundle as it was pushed; then say where it lies."""
        words = self.tr("Exported: {0}").format(out)

        def known(_: object) -> None:
            self.said.setText(words)
            self.said.show()
            self.folder.show_folder(out)
            self._app_state.lab.update(message=words)

        if run.sha256:
            return self._archived.fetch(run, out, known, self.fault.show_fault)
        command = ExportRun(run.run_id, kind, out)
        return self._app_state.quick_worker.request(command, known, self.fault.show_fault)

    def _import(self) -> None:
        kinds = (self.tr("Run bundles (*.zip)"), self.tr("Recordings of others (*)"))
        path, _ = QFileDialog.getOpenFileName(self, self.tr("Import a run"), "", ";;".join(kinds))
        if path:
            self.take_file(path)

    def take_file(self, path: str) -> None:
        """A run bundle into the store; of all else its mapping is looked at first."""
        if path.lower().endswith(".zip") or (Path(path) / "run.json").is_file():
            command = ImportBundle(path)
            return self._app_state.quick_worker.request(command, lambda _: self.refresh(), self.fault.show_fault)
        self.faces.setCurrentWidget(self.recording)
        return self.recording.open(path)

    def _imported(self, run_id: str) -> None:
        """The list again, with the new run in it."""
        self.faces.setCurrentIndex(0)
        self.search.clear()
        self.refresh()

    def dut(self) -> str:
        """Of the chosen run, else the one at the top of the window."""
        several = self.chosen_runs()
        return several[0].dut_serial if several else self._app_state.lab.state.dut_serial

    def _draw(self) -> None:
        dut = self.dut()
        self.trend.setVisible(not self.of_archive or self._archived.fault is None)
        if self.of_archive:
            self._archived.ask_for(dut)
            there = self._archived.calibrations.get(dut, ())
            return self.trend.show_files(dut, there, [moment_s(one.measured_utc) for one in there])
        mine = [c for c in reversed(self._app_state.path.files) if c.dut.serial == dut]
        dated = [(one, at_s) for one in mine if (at_s := measured_s(one, self.runs)) is not None]
        return self.trend.show_files(dut, [one for one, _ in dated], [at_s for _, at_s in dated])
