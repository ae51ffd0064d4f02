"""What the archive has, as far as it was asked: runs, and the calibrations of DUTs. Nothing waits for it."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QObject, QTimer, Signal

from labcal.gui.ipc.answers import RunLine
from labcal.gui.ipc.archive_messages import (
    ArchivedCalibration,
    FetchRun,
    ListArchivedCalibrations,
    ListArchivedRuns,
)
from labcal.gui.ipc.client import Client
from labcal.gui.ipc.kinds import Command
from labcal.gui.ipc.named_archive import named
from labcal.gui.ipc.wire import Fault

R = TypeVar("R")
RUNS = ""  # asked for, where a DUT's serial stands else
PATIENCE_MS = 90_000  # longer than the server gives a statement: it says itself what became of it


class ArchivedViewModel(QObject):
    """One question at a time, by a worker of its own: an archive that is away keeps nobody else waiting."""

    changed = Signal()

    def __init__(self, worker: Client) -> None:
        super().__init__()
        self.worker = worker
        self._url = named()
        self.runs: tuple[RunLine, ...] = ()
        self.calibrations: dict[str, tuple[ArchivedCalibration, ...]] = {}  # by DUT, the oldest first
        self.fault: Fault | None = None
        self._asked = set[str]()
        self._patience = QTimer(self, interval=PATIENCE_MS, singleShot=True)
        self._patience.timeout.connect(self.worker.kill)

    @property
    def named(self) -> bool:
        """Whether anybody said where an archive is."""
        return bool(self._url)

    @property
    def asked(self) -> bool:
        """Whether its runs are asked for and have not come."""
        return RUNS in self._asked

    def ask(self) -> None:
        """Ask for its runs; what was known of calibrations is asked anew too."""
        if self.asked or not self.named:
            return
        self.calibrations.clear()
        self._ask(RUNS, ListArchivedRuns(self._url), self._runs_known)

    def ask_for(self, dut: str) -> None:
        """Ask for the calibrations of `dut`, unless they are known, or the archive does not answer."""
        known = dut in self.calibrations or dut in self._asked
        if dut and self.named and not known and not self.asked and self.fault is None:
            self._ask(dut, ListArchivedCalibrations(self._url, dut), partial(self._known, dut))

    def close(self, wait_ms: int) -> None:
        """End its worker; nothing is asked after that."""
        self._url = ""
        self._patience.stop()
        self.worker.close(wait_ms)

    def fetch(self, run: RunLine, out: str, then: Callable[[str], object], failed: Callable[[Fault], object]) -> None:
        """Write the bundle of a run to `out`."""
        self.worker.request(FetchRun(self._url, run.sha256, run.site, out), then, failed)

    def _ask(self, what: str, command: Command[R], then: Callable[[R], object]) -> None:
        def known(answer: R) -> None:
            self._answered(what)
            then(answer)
            self.changed.emit()

        def failed(fault: Fault) -> None:
            self._answered(what)
            self.fault = self._no_answer(fault) if fault.kind == "ended" else fault
            if what == RUNS:
                self.runs = ()
            self.changed.emit()

        self._asked.add(what)
        self.fault = None
        self._patience.start()
        self.worker.request(command, known, failed)
        self.changed.emit()

    def _no_answer(self, fault: Fault) -> Fault:
        """Its worker was ended, by this window's patience or otherwise."""
        return Fault(fault.kind, self.tr("The archive has not answered."), "", f"{fault.text}\n{fault.details}")

    def _answered(self, what: str) -> None:
        self._asked.discard(what)
        if not self._asked:
            self._patience.stop()

    def _runs_known(self, found: tuple[RunLine, ...]) -> None:
        self.runs = found

    def _known(self, dut: str, found: tuple[ArchivedCalibration, ...]) -> None:
        self.calibrations[dut] = found
