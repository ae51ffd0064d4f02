"""A run under study: its fits, method by method, and its loop. No widgets."""

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
from labcal.gui.viewmodels.trace_pace import TracePace

R = TypeVar("R")


class StudyViewModel(QObject):
    """One run at a time; asking for another forgets the first. `changed` after everything that is learned."""

    changed = Signal()
    progressed = Signal()  # how far it is
    traced = Signal(str)  # the run whose residual was traced to its end
    drafted = Signal(str)  # path of a calibration file
    added = Signal()  # a run of all rows is new in the store

    def __init__(self, worker: Worker) -> None:
        super().__init__()
        self._worker = worker
        worker.progress.connect(self._progress)
        self.methods: tuple[str, ...] = ()
        self.forget("")

    def forget(self, run: str) -> None:
        """Know nothing but that `run` is under study."""
        self.run = run
        self.wanted = ""  # the procedure that would tell causes apart: its next run is added to this one
        self.measured: list[str] = []  # what was added, in words
        self.look: Look | None = None
        self.fits: dict[str, Fitted] = {}
        self.loop: Loop | None = None
        self.causes: dict[str, Change] = {}  # by name and channels: what one cause alone changes
        self.growth: dict[str, Growth] = {}  # by filter: its estimate as readings came
        self.fault: Fault | None = None
        self.waiting: list[str] = []
        self._followed: set[str] = set()
        self.message = ""
        self.pace = TracePace()

    @property
    def busy(self) -> bool:
        """Whether the worker has something to do."""
        return bool(self.waiting)

    @property
    def traces(self) -> bool:
        """Whether it is the loop that is worked at."""
        return "loop" in self.waiting

    @property
    def no_fit(self) -> bool:
        """Whether what was tried has come to nothing."""
        return not self.busy and bool(self.fits or self.fault) and self.best() is None

    @property
    def untried(self) -> tuple[str, ...]:
        """The methods that are left where others came to nothing; none where not even one could begin."""
        return tuple(one for one in self.methods if one not in self.fits) if self.fits else ()

    def prepare(self) -> None:
        """Have the worker loaded before a run is opened: what it computes with takes a second to import."""
        self._worker.request(ListMethods(), self._methods_known, lambda _: None)  # opening a run asks again

    def open(self, run: str) -> None:
        """Take `run` as the run under study."""
        if run == self.run and (self.look is not None or self.busy):
            return
        self.cancel()
        self.forget(run)
        self._ask("look", LookAt(run), self._looked)
        if not self.methods:
            self._ask("methods", ListMethods(), self._methods_known)

    def fit(self, *methods: str) -> None:
        """Estimate by each of `methods` that was not asked for yet, in order."""
        for method in [one for one in methods if one not in self.fits and one not in self.waiting]:
            self._ask(method, FitRun(self.run, method), partial(self.fits.__setitem__, method))

    def fit_all(self) -> None:
        """Estimate by every method that was not tried yet."""
        self.fit(*self.methods)

    def close_loop(self) -> None:
        """Trace the residual to its cause."""
        if "loop" not in self.waiting:
            self.loop, self.pace = None, TracePace()
            self._ask("loop", CloseLoop(self.run), self._looped)

    def want(self, procedure: str) -> None:
        """Add the next finished run of `procedure` to the run under study, and decide again."""
        self.wanted = procedure

    def add(self, procedure: str, run_id: str) -> None:
        """Add the rows of a run that has finished, and trace the residual of all of them."""
        self.wanted = ""
        self._ask("all rows", JoinRuns(self.run, run_id), partial(self._together, f"{procedure} ({run_id})"))

    def _together(self, words: str, run: str) -> None:
        measured = [*self.measured, words]
        self.added.emit()
        self.open(run)
        self.measured = measured
        self.close_loop()

    def look_at(self, effect: str, channels: tuple[str, ...]) -> None:
        """See what one cause alone would change, whether the loop named it or not."""
        if (name := cause_name(effect, channels)) not in self.causes and name not in self.waiting:
            self._ask(name, TryCause(self.run, effect, channels), partial(self.causes.__setitem__, name))

    def follow(self, method: str) -> None:
        """See how the estimate of a filter grew."""
        name = self.tr("history of {0}").format(method)
        if method not in self.growth and name not in self.waiting and name not in self._followed:
            self._followed.add(name)  # asked once: what was refused is refused again
            self._ask(name, FilterHistory(self.run, method), partial(self.growth.__setitem__, method))

    def draft(self, method: str) -> None:
        """Write the draft calibration of a method."""
        self._ask("draft", WriteDraft(self.run, method), self.drafted.emit)

    def cancel(self) -> None:
        """Give up what is under way."""
        if self.busy:
            self.waiting, self.message = [], self.tr("given up")
            self._worker.kill()
            self.changed.emit()

    def best(self) -> str | None:
        """Of the methods that came to a result, the first one in their own order."""
        done = [m for m in self.methods or tuple(self.fits) if m in self.fits and self.fits[m].fit.ok]
        return done[0] if done else None

    def _ask(self, name: str, command: Command[R], then: Callable[[R], object]) -> None:
        run = self.run

        def known(said: R) -> None:
            if run == self.run:
                self.waiting = [one for one in self.waiting if one != name]
                then(said)
                self.changed.emit()

        def failed(fault: Fault) -> None:
            if run == self.run and name in self.waiting:
                self.waiting = [] if fault.kind in BROKEN else [one for one in self.waiting if one != name]
                self.fault = fault
                self.changed.emit()

        self.fault, self.message = None, ""
        self.waiting.append(name)
        self._worker.request(command, known, failed)
        self.changed.emit()

    def _looked(self, said: Look) -> None:
        self.look = said

    def _methods_known(self, said: tuple[str, ...]) -> None:
        self.methods = said

    def _looped(self, said: Loop) -> None:
        self.loop, self.message = said, ""
        self.drafted.emit(said.draft)
        self.traced.emit(self.run)

    def _progress(self, text: str) -> None:
        self.message = text
        self.pace.hear(text)
        self.progressed.emit()


def cause_name(effect: str, channels: tuple[str, ...]) -> str:
    """An effect and its channels: "offset-current (i_radio)"."""
    return f"{effect} ({', '.join(channels)})" if channels else effect
