"""What a calibration is given away as: reports, paper, the label for its DUT, its files, and readings in nT."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFileDialog, QMenu

from labcal.gui.ipc.answers import CalibrationFile
from labcal.gui.ipc.messages import ApplyCalibration, Command, HandOut, WriteLabel, WriteReport
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.handed_files import handed_files
from labcal.gui.widgets.common import button
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.flow import Flow
from labcal.gui.widgets.folder_dialog import FolderDialog
from labcal.gui.widgets.open_externally import CopyPathButton, FolderButton, open_externally
from labcal.gui.widgets.printer import Printer
from labcal.gui.widgets.remark import Remark
from labcal.gui.widgets.step_card import StepCard
from labcal.record.run_id import name_outside

R = TypeVar("R")
REPORTS = "HTML (*.html);;PDF (*.pdf);;DCC (*.xml)"
LABELS = "PDF (*.pdf);;SVG (*.svg);;PNG (*.png)"


class Paper(StepCard):
    """Buttons for the calibration that `chosen` gives, and a line that says what came of it; faults go to `fault`."""

    handed_out = Signal(object, str)  # the CalibrationFile whose files were copied, and its copy

    def __init__(self, app_state: AppState, chosen: Callable[[], CalibrationFile | None], fault: FaultCard) -> None:
        super().__init__(" ")
        self.name_it(self.tr("4  Hand it out"))
        self._app_state, self._chosen, self._fault = app_state, chosen, fault
        self.said, self.folder, self.copy = Remark(), FolderButton(), CopyPathButton()
        self.printer = Printer(self)
        self.printer.said.connect(self.said.setText)
        self.report = button(
            self.tr("Report …"), self.tr("For people as .html or .pdf, for machines as a DCC (.xml, PTB's schema)")
        )
        self.report.clicked.connect(self._report)
        self.export = button(
            self.tr("Hand out"),
            self.tr("A folder with all that goes to the customer; the certificate on paper, a label for the DUT"),
        )
        self.export.setMenu(self._menu())
        self.apply = button(
            self.tr("Apply to readings …"), self.tr("Add the field, its uncertainty and flags to a .csv of readings")
        )
        self.apply.clicked.connect(self._apply)
        self.body.insertLayout(0, Flow(self.export, self.report, self.apply, left=True))
        at = self.body.indexOf(self.words) + 1
        self.body.insertWidget(at, self.said)
        self.body.insertLayout(at + 1, Flow(self.folder, self.copy, left=True))
        self.button = self.export

    def _menu(self) -> QMenu:
        menu = QMenu(self)
        for words, act in (
            (self.tr("All into one folder …"), self._hand_out),
            (self.tr("Print the certificate"), self.print_certificate),
            (self.tr("Print a label for the DUT"), self.print_label),
            (self.tr("Label as a file …"), self._label),
        ):
            menu.addAction(words).triggered.connect(act)
        return menu

    def print_certificate(self) -> None:
        """Print the certificate of the chosen calibration."""
        if (one := self._chosen()) is not None:
            self._print(WriteReport(one.path, self.printer.file(one.path, "certificate")))

    def print_label(self) -> None:
        """Print the label for the DUT of the chosen calibration."""
        if (one := self._chosen()) is not None:
            self._print(WriteLabel(one.path, self.printer.file(one.path, "label")))

    def _print(self, command: WriteReport | WriteLabel) -> None:
        words = self.tr("Sent to the printer: {0}").format(Path(command.out).name)

        def sent(out: str) -> str:
            self.said.setText(self.tr("Asking the printer …"))
            self.printer.print_file(out, words)
            return self.said.text()

        self._send(command, sent)

    def _label(self) -> None:
        if (one := self._chosen()) is not None:
            start = str(Path.home() / f"{_file_name(one)}-label.pdf")
            out, _ = QFileDialog.getSaveFileName(self, self.tr("Write the label"), start, LABELS)
            if out:
                self._send(WriteLabel(one.path, out), self._written)

    def _written(self, out: str) -> str:
        """Say where something was written; what people read is opened."""
        self._show_where(out)
        if not out.endswith(".xml"):
            open_externally(out)
        return self.tr("Written: {0}").format(out)

    def _show_where(self, written: str) -> None:
        """Two ways to what was written; none where that is ""."""
        self.folder.show_folder(written)
        self.copy.show_path(written)

    def _report(self) -> None:
        if (one := self._chosen()) is not None:
            start = str(Path.home() / f"{_file_name(one)}.html")
            out, _ = QFileDialog.getSaveFileName(self, self.tr("Write the report"), start, REPORTS)
            if out:
                self.write_report(one.path, out)

    def write_report(self, source: str, out: str) -> None:
        """Write the report of a calibration to `out`; what people read is opened."""
        self._send(WriteReport(source, out), self._written)
        self.said.setText(self.tr("Writing the report …"))

    def _hand_out(self) -> None:
        if (one := self._chosen()) is not None and (folder := self._asked_folder(_file_name(one))):
            self.hand_out(folder)

    def _asked_folder(self, name: str) -> str:
        """One that is there, or a new one whose name is typed."""
        title = self.tr("Copy the calibration to: a folder, or the name of a new one")
        asks = FolderDialog(self, title, self.tr("Copy here"), name)
        return asks.folder() if asks.exec() else ""

    def hand_out(self, folder: str) -> None:
        """Everything that goes to the customer into `folder`: file, signatures, keys, the certificate, and a list."""
        if (one := self._chosen()) is not None:
            words, name = self.tr("Handed out into {0}:").format(folder), _file_name(one)

            def said(_: object) -> str:
                self._show_where(folder)
                self.handed_out.emit(one, str(Path(folder) / f"{name}.json"))
                return "\n".join([words, *handed_files(Path(folder), name)])

            self._send(HandOut(one.path, folder), said)
            self.said.setText(self.tr("Writing the certificate …"))

    def _apply(self) -> None:
        source, _ = QFileDialog.getOpenFileName(self, self.tr("Readings of this DUT"), "", "CSV (*.csv)")
        if source:
            start = str(Path(source).with_suffix("")) + "-nT.csv"
            out, _ = QFileDialog.getSaveFileName(self, self.tr("Where the field goes"), start, "CSV (*.csv)")
            if out:
                self.apply_to(source, out)

    def apply_to(self, source: str, out: str) -> None:
        """Correct the readings in `source` by the chosen calibration."""
        if (one := self._chosen()) is not None:
            self._send(ApplyCalibration(one.path, source, out, one.dut.serial), str)

    def _send(self, command: Command[R], words: Callable[[R], str]) -> None:
        """Ask the quick worker, and say what came of it beside the buttons."""

        def failed(fault: Fault) -> None:
            self.said.setText("")
            self._fault.show_fault(fault)

        self._fault.show_fault(None)
        self._show_where("")
        self._app_state.quick_worker.request(command, lambda said: self.said.setText(words(said)), failed)


def _file_name(one: CalibrationFile) -> str:
    """By serial and run, as it is found again in a folder."""
    return name_outside(one.dut.serial, Path(one.path).stem)
