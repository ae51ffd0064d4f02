"""The DUT to be measured, and whose run is shown: looking at a run changes nothing of what is measured. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QObject, QSettings, Signal

from labcal.gui.ipc.answers import CalibrationFile, RunLine
from labcal.gui.viewmodels.lab import LabState, LabViewModel
from labcal.gui.viewmodels.path import WHOLE, Next, PathViewModel
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.scan import ScanViewModel
from labcal.gui.viewmodels.study import StudyViewModel

KEPT = "dut"  # in the window's settings: for a window that is started again after a crash
STUDIES = ("Fit", "Loop")  # pages that show the run under study


class OneDut(QObject):
    """The serial at the top is the DUT to be measured: a person says it, a scan, or the run that goes on.

    `stated`: one of them has; until then it is proposed, once for each bench. Whose the run under study is, or the
    calibration on the Certificate page, may be another one: `shown` tells. Marks and Next are of the DUT at the top.
    """

    changed = Signal()  # what is shown
    file_wanted = Signal()  # the Certificate page is to show the one that Next speaks of

    def __init__(
        self,
        settings: QSettings,
        lab: LabViewModel,
        run: RunViewModel,
        views: tuple[StudyViewModel, PathViewModel, ScanViewModel],
    ) -> None:
        super().__init__()
        self._settings, self._lab, self._run = settings, lab, run
        self._study, self._path, self._scan = views
        self.stated, self.proposed = False, False
        self.calibration: CalibrationFile | None = None  # the one on the Certificate page
        self._looked_from = ""  # what stood at the top when the run under study was opened
        self._here, self._another = "", False  # what stands there; whether that was changed since one was opened
        self._let_go = False  # whether a run was let go of, and none taken up or opened since
        self._file_wanted = ""  # path of the file that Next has led to
        self._study.changed.connect(self.changed)
        self._path.changed.connect(self.changed)
        self._scan.changed.connect(self._scanned)
        lab.changed.connect(self._keep)

    def propose(self, serial: str) -> str:
        """`serial`, until the store was read or somebody said another; what is learned later switches nothing."""
        settled, self.proposed = self.stated or self.proposed, self.proposed or self._path.listed
        return self._lab.state.dut_serial if settled else serial

    def open(self, run: str) -> None:
        """Study `run`, whosever it is."""
        self._looked_from, self._another, self._let_go = self._lab.state.dut_serial, False, False
        self._study.open(run)
        self.changed.emit()

    def take_up(self) -> None:
        """Where nothing is under study, as after a restart: the last run of the DUT at the top, if it may be fitted."""
        last = self._path.last()
        if last is not None and last.status in WHOLE and not (self._study.run or self._run.alive or self._scan.asks):
            self.open(last.run_id)

    def studied(self) -> str:
        """The DUT of the run under study; "" where there is none, or it is not known yet."""
        listed = (one.dut_serial for one in self._path.runs if one.run_id == self._study.run)
        return next(listed, "" if self._study.look is None else self._study.look.dut)

    def looked_at(self) -> str:
        """The DUT that is looked at: that of the run that was opened since the top was said, else the one there."""
        here = self._lab.state.dut_serial
        return (self.studied() if here == self._looked_from else "") or here

    def shown(self, page: str) -> tuple[str, str]:
        """The serial and the run of what `page` shows, where that is not of the DUT at the top; else ("", "")."""
        serial, run = (self.studied(), self._study.run) if page in STUDIES else ("", "")
        if page == "Certificate" and self.calibration is not None:
            serial, run = self.calibration.dut.serial, self.calibration.run_id
        return (serial, run) if serial and serial != self._lab.state.dut_serial else ("", "")

    def beside_the_marks(self, page: str) -> bool:
        """Whether `page` shows a run of the DUT at the top that is not the one of which the marks and Next speak."""
        if page not in STUDIES or self.shown(page) != ("", "") or self._run.alive:
            return False
        last, run = self._path.last(), self._study.run
        return any(one.run_id == run for one in self._path.runs) and (last is None or last.run_id != run)

    def on_page(self, page: str) -> str:
        """The run that `page` shows; "" where it shows none, or one that goes on."""
        if page == "Run":
            return self._run.run_id if self._run.state == "ended" else ""
        if page == "Certificate":
            return "" if self.calibration is None else self.calibration.run_id
        return self._study.run if page in STUDIES else ""

    def unlike(self, to: Next, page: str) -> RunLine | None:
        """The run of which Next speaks, where `page` shows another one; one name for both would be of neither."""
        shown = self.on_page(page)
        another = bool(shown) and bool(to.about) and shown != to.about
        return next((one for one in self._path.runs if another and one.run_id == to.about), None)

    def take_calibration(self, one: CalibrationFile | None) -> None:
        """The Certificate page shows this one."""
        if one != self.calibration:
            self.calibration = one
            self.changed.emit()

    def back(self) -> None:
        """What is of the DUT at the top is shown again."""
        self.calibration = None
        if self.studied() not in ("", self._lab.state.dut_serial) or self.beside_the_marks(STUDIES[0]):
            self._study.let_go()
        self.take_up()
        self.changed.emit()

    def settle(self) -> None:
        """Once it is said which DUT it is: what was opened while another stood at the top is let go of.

        What is being computed of that goes on; and what was computed of this DUT's last run is shown again.
        """
        if self._run.alive or self._scan.asks:
            return
        if self._another:
            self._let_go_of_others()
        if (last := self._path.last()) is not None and self._study.of(last.run_id) is not None:
            self.take_up()

    def begin_anew(self) -> None:
        """The window is made anew: what it shows of another DUT is not what it begins with."""
        self._another = bool(self._lab.state.dut_serial)
        self.settle()

    def _let_go_of_others(self) -> None:
        """Of a DUT that has come back as well: what was looked at before it went is not what it came back for."""
        studied, here = self.studied(), self._lab.state.dut_serial
        self._looked_from, self._another = here, False
        if self.calibration is not None and self.calibration.dut.serial != here:
            self.calibration = None
            self.changed.emit()
        if studied and studied != here:
            if self._study.busy:
                self._lab.update(message=self.tr("{0}: what is being computed goes on.").format(studied))
            self._study.let_go()
            self._let_go = True
        if self._let_go:  # now, or before the serial was whole that stands there
            self.take_up()
            self._let_go = not self._study.run

    def shows(self, to: Next) -> bool:
        """Whether the page that Next leads to shows the run that it speaks of, or it speaks of none."""
        return not to.about or self.on_page(to.page) == to.about

    def turn_to(self, to: Next) -> None:
        """Next is pressed: its page shows the run and the file that it speaks of, whatever was chosen there."""
        if to.page in STUDIES and not self.shows(to):
            self.open(to.about)
        if to.page == "Certificate":
            if self.studied() not in ("", self._lab.state.dut_serial):
                self.open(to.about)
            file, shown = self._path.kept(to.about), self.calibration
            if file is not None and (shown is None or shown.path != file.path):
                self._file_wanted = file.path
                self.file_wanted.emit()

    def take_wanted(self) -> str:
        """The path of the file that Next has led to, once; "" where there is none."""
        wanted, self._file_wanted = self._file_wanted, ""
        return wanted

    def _scanned(self) -> None:
        self.stated = self.stated or self._scan.taken
        self._keep(self._lab.state)
        self.settle()

    def _keep(self, state: LabState) -> None:
        """Where a crash does not take it: the serial that was said last."""
        if state.dut_serial != self._here:
            self._here, self._another = state.dut_serial, True
            self._let_go = self._let_go and bool(self._here)  # without a DUT there is nothing to come back to
        if self.stated and state.dut_serial != self._settings.value(KEPT, ""):
            self._settings.setValue(KEPT, state.dut_serial)
            self._settings.sync()
        self.changed.emit()
