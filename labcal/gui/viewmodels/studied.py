"""What is known of one run under study, and what is still asked about it. No widgets."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Generic, TypeVar

from labcal.gui.ipc.answers import Change, Fitted, Growth, Look, Loop
from labcal.gui.ipc.client import Worker
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.trace_pace import TracePace

T = TypeVar("T")
QUICK = {"look", "methods"}


@dataclass(eq=False)
class Studied:
    """Of `run`; `worker`: who works for it, as long as it is `waiting` for anything."""

    run: str
    wanted: str = ""  # the procedure that would tell causes apart: its next run is added to this one
    measured: list[str] = field(default_factory=list)  # what was added, in words
    look: Look | None = None
    fits: dict[str, Fitted] = field(default_factory=dict)
    loop: Loop | None = None
    causes: dict[str, Change] = field(default_factory=dict)  # by name and channels: what one cause alone changes
    growth: dict[str, Growth] = field(default_factory=dict)  # by filter: its estimate as readings came
    fault: Fault | None = None
    waiting: list[str] = field(default_factory=list)
    followed: set[str] = field(default_factory=set)
    message: str = ""
    pace: TracePace = field(default_factory=TracePace)
    worker: Worker | None = None

    def take_look(self, look: Look) -> None:
        """The run as it was recorded, and what was worked out of it before and is not being worked out again."""
        self.look = look
        for method, fitted in look.fits.items():
            self.fits.setdefault(method, fitted)
        if self.loop is None and not self.traces:
            self.loop = look.loop

    @property
    def busy(self) -> bool:
        """Whether a worker has something to do for it."""
        return bool(self.waiting)

    @property
    def computes(self) -> bool:
        """Whether that takes long: a look, and the names of methods, keep no other run waiting."""
        return bool(set(self.waiting) - QUICK)

    @property
    def traces(self) -> bool:
        """Whether it is the loop that is worked at."""
        return "loop" in self.waiting

    @property
    def no_fit(self) -> bool:
        """Whether what was tried has come to nothing."""
        return not self.busy and bool(self.fits or self.fault) and self.best() is None

    def untried(self, methods: tuple[str, ...]) -> tuple[str, ...]:
        """Of `methods` those that are left where others came to nothing; none where not even one could begin."""
        return tuple(one for one in methods if one not in self.fits) if self.fits else ()

    def best(self, methods: tuple[str, ...] = ()) -> str | None:
        """Of the methods that came to a result, the first one in the order of `methods`, or as they were asked."""
        done = [m for m in methods or tuple(self.fits) if m in self.fits and self.fits[m].fit.ok]
        return done[0] if done else None


class OfTheRunShown(Generic[T]):
    """An attribute of a study that is that of the run it shows."""

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, study: object, owner: type) -> T:
        value: T = getattr(study.shown, self._name)  # type: ignore[attr-defined]
        return value

    def __set__(self, study: object, value: T) -> None:
        setattr(study.shown, self._name, value)  # type: ignore[attr-defined]
