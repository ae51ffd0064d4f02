"""One DUT on the screen: whose run is opened stands at the top, and a run of another DUT is let go of. No widgets."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QSettings

from labcal.gui.viewmodels.lab import LabState, LabViewModel
from labcal.gui.viewmodels.path import WHOLE, PathViewModel
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.scan import ScanViewModel
from labcal.gui.viewmodels.study import StudyViewModel

KEPT = "dut"  # in the window's settings: for a window that is started again after a crash


class OneDut(QObject):
    """`stated`: a person, or their run, has said which DUT it is; `state` says it in their place."""

    def __init__(
        self,
        settings: QSettings,
        lab: LabViewModel,
        run: RunViewModel,
        views: tuple[StudyViewModel, PathViewModel, ScanViewModel],
        state: Callable[[str], object],
    ) -> None:
        super().__init__()
        self._settings, self._lab, self._run, self._state = settings, lab, run, state
        self._study, self._path, self._scan = views
        self.stated = False
        self._opened = ""  # by a person, and not known yet whose it is
        self._study.changed.connect(self._take_its_dut)
        self._scan.changed.connect(self.settle)
        lab.changed.connect(self._keep)

    def open(self, run: str) -> None:
        """Study `run`, with its DUT at the top."""
        self._opened = run
        self._study.open(run)
        self._take_its_dut()

    def take_up(self) -> None:
        """Where nothing is under study, as after a restart: the last run of the DUT at the top, if it may be fitted."""
        last = self._path.last()
        if last is not None and last.status in WHOLE and not (self._study.run or self._run.alive or self._scan.asks):
            self._study.open(last.run_id)

    def studied(self) -> str:
        """The DUT of the run under study; "" where there is none, or it is not known yet."""
        listed = (one.dut_serial for one in self._path.runs if one.run_id == self._study.run)
        return next(listed, "" if self._study.look is None else self._study.look.dut)

    def settle(self) -> None:
        """Once it is said which DUT it is: what is shown of another one is let go of."""
        studied = self.studied()
        if studied and studied != self._lab.state.dut_serial and not (self._run.alive or self._scan.asks):
            self._study.cancel()
            self._study.forget("")
            self._study.changed.emit()

    def _take_its_dut(self) -> None:
        if self._opened and self._opened == self._study.run and (serial := self.studied()):
            self._opened = ""
            self.take(serial)

    def take(self, serial: str) -> None:
        """What is of this DUT is looked at. A serial that was typed and is of no run is not written over unasked."""
        here = self._lab.state.dut_serial
        if serial == here or self._run.alive:
            return
        if here and self.stated and here not in {one.dut_serial for one in self._path.runs}:
            self._scan.ask(serial, of_run=True)
        else:
            self._state(serial)

    def _keep(self, state: LabState) -> None:
        """Where a crash does not take it: the serial that was said last."""
        if self.stated and state.dut_serial != self._settings.value(KEPT, ""):
            self._settings.setValue(KEPT, state.dut_serial)
            self._settings.sync()
