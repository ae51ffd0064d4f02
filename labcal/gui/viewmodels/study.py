"""Runs under study: their fits, method by method, and their loops; one of them is shown. No widgets."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QObject, Signal

from labcal.gui.ipc.answers import Change, Fitted, Growth, Look, Loop
from labcal.gui.ipc.client import Worker
from labcal.gui.ipc.messages import (
    CloseLoop,
    Command,
    FilterHistory,
    FitRun,
    JoinRuns,
    ListMethods,
    LookAt,
    TryCause,
    WriteDraft,
)
from labcal.gui.ipc.wire import BROKEN, Fault
from labcal.gui.viewmodels.studied import OfTheRunShown, Studied
from labcal.gui.viewmodels.trace_pace import TracePace

R = TypeVar("R")
MOST_KEPT = 12  # runs at rest whose fits and loop are kept


class StudyViewModel(QObject):
    """One run is shown; what was computed of another is kept, and what is being computed of it goes on.

    `changed` after everything that is learned.
    """

    changed = Signal()
    progressed = Signal()  # how far it is
    traced = Signal(str)  # the run whose residual was traced to its end
    drafted = Signal(str)  # path of a calibration file
    added = Signal()  # a run of all rows is new in the store

    wanted, measured = OfTheRunShown[str](), OfTheRunShown[list[str]]()
    look, loop = OfTheRunShown[Look | None](), OfTheRunShown[Loop | None]()
    fits, causes = OfTheRunShown[dict[str, Fitted]](), OfTheRunShown[dict[str, Change]]()
    growth, fault = OfTheRunShown[dict[str, Growth]](), OfTheRunShown[Fault | None]()
    waiting, message = OfTheRunShown[list[str]](), OfTheRunShown[str]()
    pace = OfTheRunShown[TracePace]()

    def __init__(self, *workers: Worker) -> None:
        """Each of `workers` computes for one run at a time; a run more waits for the last of them."""
        super().__init__()
        self._workers = workers
        for worker in workers:
            worker.progress.connect(partial(self._progress, worker))
        self.methods: tuple[str, ...] = ()
        self.forget("")

    def forget(self, run: str) -> None:
        """Know nothing but that `run` is under study."""
        self.shown = Studied(run)
        self._kept = {run: self.shown} if run else {}

    @property
    def run(self) -> str:
        """The run that is shown; "" where there is none."""
        return self.shown.run

    @property
    def busy(self) -> bool:
        """Whether anything is being computed of the run that is shown."""
        return self.shown.busy

    @property
    def traces(self) -> bool:
        """Whether it is the loop that is worked at."""
        return self.shown.traces

    def of(self, run: str) -> Studied | None:
        """What is known of `run`, shown or not; None where it was not studied."""
        return self._kept.get(run)

    def elsewhere(self) -> list[Studied]:
        """The runs that something is computed of, and that are not shown."""
        return [one for one in self._kept.values() if one.computes and one is not self.shown]

    @property
    def no_fit(self) -> bool:
        """Whether what was tried has come to nothing."""
        return self.shown.no_fit

    @property
    def untried(self) -> tuple[str, ...]:
        """The methods that are left where others came to nothing; none where not even one could begin."""
        return self.shown.untried(self.methods)

    def prepare(self) -> None:
        """Have the worker loaded before a run is opened: what it computes with takes a second to import."""
        self._workers[0].request(ListMethods(), self._methods_known, lambda _: None)  # opening a run asks again

    def open(self, run: str) -> None:
        """Show `run`, as it was left; what is being computed of another goes on."""
        if run == self.run and (self.look is not None or self.busy):
            return
        kept = self._kept.get(run)
        self.shown = kept if kept is not None and (kept.look or kept.loop or kept.busy) else self._new(run)
        if self.look is None and not self.busy:
            self._ask("look", LookAt(run), self.shown.take_look)
            if not self.methods:
                self._ask("methods", ListMethods(), self._methods_known)
        self.changed.emit()

    def let_go(self) -> None:
        """Show no run."""
        self.shown = Studied("")
        self.changed.emit()

    def _new(self, run: str) -> Studied:
        """A run of which nothing is known; of those that are kept and at rest the oldest may go for it."""
        at_rest = [one for one, studied in self._kept.items() if not studied.busy and studied is not self.shown]
        for one in at_rest[:-MOST_KEPT]:
            del self._kept[one]
        self._kept.pop(run, None)
        self._kept[run] = Studied(run)
        return self._kept[run]

    def fit(self, *methods: str) -> None:
        """Estimate by each of `methods` that was not asked for yet, in order."""
        for method in [one for one in methods if one not in self.fits and one not in self.waiting]:
            self._ask(method, FitRun(self.run, method), partial(self.fits.__setitem__, method))

    def fit_all(self) -> None:
        """Estimate by every method that was not tried yet."""
        self.fit(*self.methods)

    def begin(self, page: str) -> None:
        """What the page Fit or Loop is for, where it is not done yet."""
        if page == "Fit":
            self.fit("ml")
        elif page == "Loop" and self.loop is None:
            self.close_loop()

    def close_loop(self) -> None:
        """Trace the residual to its cause."""
        self._trace(self.shown)

    def _trace(self, studied: Studied) -> None:
        if not studied.traces:
            studied.loop, studied.pace = None, TracePace()
            self._ask("loop", CloseLoop(studied.run), partial(self._looped, studied), studied)

    def want(self, procedure: str) -> None:
        """Add the next finished run of `procedure` to the run under study, and decide again."""
        self.wanted = procedure

    def add(self, procedure: str, run_id: str, to: str) -> bool:
        """Add the rows of a run that has finished to `to`, and trace all of them; says whether `to` is shown."""
        if (studied := self.of(to)) is not None:
            studied.wanted = ""
            together = partial(self._together, studied, f"{procedure} ({run_id})")
            self._ask("all rows", JoinRuns(to, run_id), together, studied)
        return studied is not None and studied is self.shown

    def _together(self, studied: Studied, words: str, run: str) -> None:
        self.added.emit()
        if self.shown is studied:
            self.open(run)
        joined = self.of(run) or self._new(run)
        joined.measured = [*studied.measured, words]
        self._trace(joined)

    def look_at(self, effect: str, channels: tuple[str, ...]) -> None:
        """See what one cause alone would change, whether the loop named it or not."""
        if (name := cause_name(effect, channels)) not in self.causes and name not in self.waiting:
            self._ask(name, TryCause(self.run, effect, channels), partial(self.causes.__setitem__, name))

    def follow(self, method: str) -> None:
        """See how the estimate of a filter grew."""
        name = self.tr("history of {0}").format(method)
        if method not in self.growth and name not in self.waiting and name not in self.shown.followed:
            self.shown.followed.add(name)  # asked once: what was refused is refused again
            self._ask(name, FilterHistory(self.run, method), partial(self.growth.__setitem__, method))

    def draft(self, method: str) -> None:
        """Write the draft calibration of a method."""
        self._ask("draft", WriteDraft(self.run, method), self.drafted.emit)

    def cancel(self) -> None:
        """Give up what is under way of the run that is shown."""
        if self.busy:
            worker, self.waiting, self.message = self._worker_for(self.shown), [], self.tr("given up")
            worker.kill()
            self.changed.emit()

    def best(self) -> str | None:
        """Of the methods that came to a result, the first one in their own order."""
        return self.shown.best(self.methods)

    def _ask(self, name: str, command: Command[R], then: Callable[[R], object], studied: Studied | None = None) -> None:
        """Of the run that is shown, or of another; its answer is of that run, whichever is shown by then."""
        of = studied or self.shown

        def known(said: R) -> None:
            of.waiting = [one for one in of.waiting if one != name]
            then(said)
            self.changed.emit()

        def failed(fault: Fault) -> None:
            if name in of.waiting:
                of.waiting = [] if fault.kind in BROKEN else [one for one in of.waiting if one != name]
                of.fault = fault
                self.changed.emit()

        of.fault, of.message, of.worker = None, "", self._worker_for(of)
        of.waiting.append(name)
        of.worker.request(command, known, failed)
        self.changed.emit()

    def _worker_for(self, studied: Studied) -> Worker:
        """The one that works for it already, else one at rest, else the last: it does one thing after another."""
        if studied.busy and studied.worker is not None:
            return studied.worker
        taken = [one.worker for one in self._kept.values() if one.computes]
        return next((worker for worker in self._workers if worker not in taken), self._workers[-1])

    def _methods_known(self, said: tuple[str, ...]) -> None:
        self.methods = said

    def _looped(self, studied: Studied, said: Loop) -> None:
        studied.loop, studied.message = said, ""
        self.drafted.emit(said.draft)
        self.traced.emit(studied.run)

    def _progress(self, worker: Worker, text: str) -> None:
        for one in [one for one in self._kept.values() if one.busy and one.worker is worker][:1]:
            one.message = text
            one.pace.hear(text)
        self.progressed.emit()


def cause_name(effect: str, channels: tuple[str, ...]) -> str:
    """An effect and its channels: "offset-current (i_radio)"."""
    return f"{effect} ({', '.join(channels)})" if channels else effect
