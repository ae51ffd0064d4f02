"""The path of one DUT from bench to signature: how far it has come, and what is next. No widgets."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Literal

from PySide6.QtCore import QObject, Signal

from labcal.gui.ipc.answers import CalibrationFile, RunLine
from labcal.gui.ipc.record_messages import RunResult
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.handed_out import HandedOut
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.lab_now import mark_of
from labcal.gui.viewmodels.mark_words import just_read
from labcal.gui.viewmodels.may_answer import may_answer, wanted
from labcal.gui.viewmodels.procedure_groups import CALIBRATES
from labcal.gui.viewmodels.resumed import to_be_resumed
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.signing import NO_LONGER, awaited, doubts, file_word, handed_out_as, handed_out_word
from labcal.gui.viewmodels.study import StudyViewModel
from labcal.gui.viewmodels.what_happens import kept_out
from labcal.record.endings import ended_word

Mark = Literal["done", "now", "doubt", "broken", "open"]
SHAPES: dict[Mark, str] = {"done": "✓", "now": "●", "doubt": "▲", "broken": "✕", "open": "○"}
WHOLE = ("finished", "imported")  # runs that a calibration may be made of
EXPLAINED = ("clean", "explained")


@dataclass(frozen=True, slots=True)
class Next:
    """What is to be done, in words, and the page for it; with the run to be studied there.

    `waits`: it works. `ready`: whoever sees the page has its Begin before them. `closes`: the run that is done with.
    `presses`: on that page Next does what its one button does. `off`: Next is COILS OFF, whatever page is open.
    `resumes`: the run that Next goes on with at once. `of`: the run whose calibration it is about.
    `in_the_bar`: it is said at the top, over whatever page is open.
    """

    page: str
    words: str
    run: str = ""
    waits: bool = False
    ready: bool = False
    closes: str = ""
    presses: bool = False
    off: bool = False
    resumes: RunLine | None = None
    of: str = field(default="", compare=False)
    in_the_bar: bool = False

    @property
    def about(self) -> str:
        """The run that it speaks of; "" where of none."""
        return self.run or self.closes or self.of or ("" if self.resumes is None else self.resumes.run_id)


@dataclass(frozen=True, slots=True)
class Wanted:
    """A procedure to be shown on the Run page: `names` apart by |, the first that there is; its `plan` too."""

    names: str
    plan: bool = False
    settings: Mapping[str, str] = field(default_factory=dict)  # that it is proposed with, for this once


class PathViewModel(QObject):
    """Marks of the pages Bench to Certificate for the DUT at the top, from what the pages have learned of the store."""

    changed = Signal()

    def __init__(self, lab: LabViewModel, run: RunViewModel, study: StudyViewModel, handed_out: HandedOut) -> None:
        super().__init__()
        self._lab, self._run, self._study, self.handed_out = lab, run, study, handed_out
        self.runs: tuple[RunLine, ...] = ()
        self.resumable: frozenset[str] = frozenset()  # procedures that can be gone on with, once these are known
        self.listed = False  # whether the store has been read
        self.another_bench: Callable[[RunLine], str] = lambda one: ""  # that another is open than it was begun on
        self.files: tuple[CalibrationFile, ...] = ()
        self._step: tuple[object, str] = (None, "")  # which state of which file the Certificate page shows; its step
        self.results = dict[str, RunResult]()  # of runs, as far as they were told: no window asks for them anew
        self.refused = ""  # of the form on the Run page, where it is that of the preflight
        self.begins = ""  # the procedure that Begin there begins, whichever it is
        for source in (lab.changed, run.changed, study.changed):
            source.connect(self.changed)

    def take_runs(self, runs: tuple[RunLine, ...]) -> None:
        """The runs of the store, the newest first."""
        self.runs, self.listed = runs, True
        self.changed.emit()

    def take_calibrations(self, files: tuple[CalibrationFile, ...]) -> None:
        """The calibrations of the lab, the newest first."""
        self._step = (None, "")  # the page says it of these
        self.files = files
        self.changed.emit()

    def take_handed_out(self, one: CalibrationFile) -> None:
        """This file has left the lab."""
        self.handed_out.add(one)
        self.changed.emit()

    def take_step(self, file: CalibrationFile, step: str) -> None:
        """What the cards of this calibration say is to be done now; Next says it in the same words."""
        if self._step != (said := (_state_of(file), step)):
            self._step = said
            self.changed.emit()

    def close(self, run_id: str) -> None:
        """The next DUT comes: this run's is done with."""
        self.handed_out.close(run_id)
        self.changed.emit()

    def stands(self, run_id: str) -> str:
        """What became of a run's calibration: a draft, released, handed out …; "" where there is none."""
        file = self.kept(run_id)
        if file is None:
            return ""
        return handed_out_word(file) if self.handed_out.holds(file) else file_word(file)

    def kept(self, run_id: str) -> CalibrationFile | None:
        """The calibration of a run: the signed one where there is one."""
        mine = [one for one in self.files if one.run_id == run_id]
        return next((one for one in mine if one.standing.signatures), mine[0] if mine else None)

    def traced(self, run_id: str) -> str:
        """The loop's verdict on a run, of this session or as the store has it; "" where its residual was not traced."""
        studied = self._study.of(run_id)
        if studied is not None and studied.loop is not None:
            return studied.loop.verdict
        return next((one.verdict for one in self.runs if one.run_id == run_id), "")

    def why_no_fit(self, run_id: str) -> str:
        """Why a run gives no calibration; "" where it may, or is not known."""
        listed = next((one for one in self.runs if one.run_id == run_id), None)
        status = "finished" if listed is None else listed.status
        if listed is None or status in WHOLE:
            return ""
        why = in_words(status.partition(": ")[2])
        known = {
            "stopped": self.tr("was stopped before its end"),
            "broken off": self.tr("was broken off: {0}").format(why) if why else self.tr("was broken off"),
            "running": self.tr("still goes on"),
        }
        remedy = self.tr("What it did not measure would be missing in the calibration. Measure again on the Run page.")
        if status == "interrupted":
            remedy = self.tr("What it has not measured yet would be missing: go on with it on the Start page.")
        return self.tr("Run {0} {1}. {2}").format(run_id, known[ended_word(status, stopped=listed.stopped)], remedy)

    def begun_elsewhere(self, run_id: str) -> str:
        """That another bench is open than a run that broke off was begun on, in words; "" else."""
        broken = (one for one in self.runs if one.run_id == run_id)
        return next(map(self.another_bench, broken), "")

    def broken_off(self, simulated: bool) -> str:
        """The DUT of the newest run in such a lab, where that run is to be gone on with; else ""."""
        newest = next((one for one in self.runs if one.simulated == simulated), None)
        return newest.dut_serial if newest is not None and newest.status == "interrupted" else ""

    def unfinished(self) -> RunLine | None:
        """The newest run of this DUT that is to be gone on with, if no other one has taken its place."""
        mine = (one for one in self.runs if one.dut_serial == self._lab.state.dut_serial)
        return next(iter(to_be_resumed(tuple(mine), self.resumable)), None)

    def take_resumable(self, procedures: frozenset[str]) -> None:
        """These can be gone on with."""
        self.resumable = procedures
        self.changed.emit()

    def last(self) -> RunLine | None:
        """The newest run of this DUT that was to calibrate it, unless it is done with."""
        serial = self._lab.state.dut_serial
        mine = (one for one in self.runs if one.dut_serial == serial)
        newest = next((one for one in mine if one.procedure in CALIBRATES or one.status == "imported"), None)
        return None if newest is None or self.handed_out.closed(newest.run_id) else newest

    def _measured_anew(self) -> bool:
        """Whether a run to calibrate this DUT goes on, or has ended and is not listed: no fit so far is of it."""
        run, order = self._run, self._run.order
        if order is None or order.procedure not in CALIBRATES or order.dut != self._lab.state.dut_serial:
            return False
        listed = run.run_id in {one.run_id for one in self.runs}
        return run.alive or (run.status in WHOLE and bool(run.run_id) and not listed)

    def marks(self) -> dict[str, Mark]:
        """How far this DUT is, by page."""
        last = self.last()
        whole = last is not None and last.status in WHOLE and not self._measured_anew()
        return {
            "Bench": self._of_the_bench(),
            "Run": self._of_the_run(last),
            "Fit": self._of_the_fit(last) if last is not None and whole else "open",
            "Loop": self._of_the_loop(last) if last is not None and whole else "open",
            "Certificate": self._of_the_file(last) if last is not None and whole else "open",
        }

    def next(self) -> Next:
        """The one thing to do now."""
        state, last, marks = self._lab.state, self.last(), self.marks()
        if not state.bench:
            return Next("Bench", self.tr("Open a bench"), waits=state.opening, presses=True)
        if self._run.alive:
            asked = self.may_answer()
            return Next("Run", self.tr("Answer the question") if asked else self.tr("See the run"), waits=not asked)
        if state.now.driven_elsewhere:
            return Next("Start", self.tr("Wait for the other process"), waits=True)
        if state.now.left_turning:
            return Next("Bench", self.tr("Stop the platform (COILS OFF)"), off=True)
        if mark_of(state.now.coil_words)[1] == "bad":
            return Next("Bench", self.tr("See to the coils"), presses=not state.now.left_unseen)
        if failed := state.now.failed:
            return Next("Bench", self.tr("See to {0}").format(failed[0]), presses=not state.now.left_unseen)
        if state.now.left_unseen:
            return Next("Bench", self.tr("Stop the platform (COILS OFF)"), off=True)
        if not state.dut_serial or state.dut_objection:
            return Next("Start", self.tr("Say which DUT"), in_the_bar=True)
        if not state.operator or state.operator_objection:
            return Next("Start", self.tr("Say who works here"), in_the_bar=True)
        broken = self.unfinished()
        if broken is not None and broken == last and not self.another_bench(broken):  # else it might be refused
            return Next("Run", self.tr("Go on with {0}").format(state.dut_serial), resumes=broken)
        if last is None or marks["Run"] != "done":
            return self._to_calibrate(state.dut_serial)
        studied = self._study.of(last.run_id)
        if marks["Loop"] == "now" or (marks["Fit"] == "now" and (studied is None or studied.best() is None)):
            traces = marks["Loop"] == "now"
            words = self.tr("See how far the trace is") if traces else self.tr("See how far the fit is")
            return Next("Loop" if traces else "Fit", words, last.run_id, waits=True)
        if marks["Fit"] == "broken":
            others = Next("Fit", self.tr("Try the other methods"), presses=True, of=last.run_id)
            left = studied is not None and studied.untried(self._study.methods)
            return others if left else self._to_calibrate(state.dut_serial, again=True)
        if marks["Fit"] == "open":
            return Next("Fit", self.tr("Fit the run"), last.run_id)
        if marks["Loop"] == "open":
            return Next("Loop", self.tr("Trace the residual"), last.run_id)
        if marks["Loop"] == "doubt" and marks["Certificate"] == "open":  # the loop says what to do before signing
            return Next("Loop", self.tr("See what is not known"), last.run_id)
        return self._of_the_signatures(last)

    def may_answer(self) -> bool:
        """Whether a question stands that may be answered so that the run goes on."""
        prompt, now = self._run.prompt, self._lab.state.now
        if prompt is None or self._run.state != "asking":
            return False
        return may_answer(prompt, wanted(prompt), lost=bool(now.failed), waits=kept_out(self._run, now)[2])

    def _to_calibrate(self, serial: str, *, again: bool = False) -> Next:
        """By a preflight, `again` where its run gave no fit: where a setting of it is refused, that comes first."""
        if self.refused:
            return Next("Run", self.tr("Correct {0}").format(self.refused))
        words = self.tr("Measure {0} again") if again else self.tr("Calibrate {0}")
        return Next("Run", words.format(serial), ready=bool(self.begins))

    def take_form(self, refused: str, begins: str) -> None:
        """How the form on the Run page stands: a preflight's first setting that is refused, and what may begin."""
        if (refused, begins) != (self.refused, self.begins):
            self.refused, self.begins = refused, begins
            self.changed.emit()

    def _of_the_signatures(self, last: RunLine) -> Next:
        """Sign, as long as somebody is still to; what is provisional for good may be handed out as that."""
        file = self._file(last)
        if file is None or not file.standing.signatures:
            unseen = file is not None and not file.approvers
            words = self.tr("Approve and sign") if unseen else self.tr("Sign")
            of, step = self._step
            words = translated(step) if step and file is not None and of == _state_of(file) else words
            return Next("Certificate", words, of=last.run_id)
        standing = file.standing
        if not standing.valid:
            return Next("Fit", self.tr("Make a new draft"), last.run_id)
        if standing.status in NO_LONGER:
            return self._to_calibrate(last.dut_serial)
        if awaited(file):
            return Next("Certificate", self.tr("The second signature"), of=last.run_id)
        if self.handed_out.holds(file):
            return Next("Start", self.tr("The next DUT"), closes=last.run_id)
        as_what, words = handed_out_as(file), self.tr("Hand it out, as {0}")
        return Next("Certificate", words.format(as_what) if as_what else self.tr("Hand it out"), of=last.run_id)

    def _of_the_bench(self) -> Mark:
        """It is done where every instrument has answered just now, by the age that lets hands in; begun where some."""
        now = self._lab.state.now
        if any(light == "fault" for _, light, _ in now.lights):
            return "broken"
        read = just_read(now).values()
        return "done" if read and all(read) else "now" if any(read) else "open"

    def _of_the_run(self, last: RunLine | None) -> Mark:
        if self._run.alive:
            return "now"
        if last is None:
            return "open"
        broken: Mark = "doubt" if last.status in ("stopped", "interrupted", "running") else "broken"
        return "done" if last.status in WHOLE else broken

    def _of_the_fit(self, last: RunLine) -> Mark:
        studied = self._study.of(last.run_id)
        if studied is not None and studied.computes and not studied.traces:  # a look at it is no fit
            return "now"
        fitted = (studied is not None and studied.best() is not None) or self._file(last) is not None
        return "done" if fitted else "broken" if studied is not None and studied.no_fit else "open"

    def _of_the_loop(self, last: RunLine) -> Mark:
        studied = self._study.of(last.run_id)
        if studied is not None and studied.traces:
            return "now"
        verdict = self.traced(last.run_id)
        return "open" if not verdict else "done" if verdict in EXPLAINED else "doubt"

    def _of_the_file(self, last: RunLine) -> Mark:
        file = self._file(last)
        if file is None or not file.standing.signatures:
            return "open"
        if not file.standing.valid:
            return "broken"
        return "doubt" if file.standing.provisional or doubts(file) else "done"

    def _file(self, last: RunLine) -> CalibrationFile | None:
        return self.kept(last.run_id)


def _state_of(file: CalibrationFile) -> tuple[object, ...]:
    """What another step goes with: a new draft has the name of the one before, and is not signed."""
    return file.run_id, file.path, file.approvers, file.standing
