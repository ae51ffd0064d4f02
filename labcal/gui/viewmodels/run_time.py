"""How far a run is by the bench's clock: what is left of its steps, and which share of the whole is over. No Qt."""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Iterable
from statistics import fmean

from labcal.gui.viewmodels.pace import Pace
from labcal.gui.viewmodels.promised import Promised
from labcal.gui.viewmodels.run_steps import kind_of
from labcal.record.stream import Step


class RunTime:
    """`seen_s`: the stamp of what came last. The time that a person takes is in no plan, and counts for nothing."""

    def __init__(self) -> None:
        self.seen_s = 0.0
        self.pace = Pace()
        self._promised = defaultdict[str, Promised](Promised)  # by what is to come
        self._step: Step | None = None
        self._waited_s = 0.0  # of this step, for a person
        self._waits_since_s: float | None = None
        self._longer_s = defaultdict[str, list[float]](list)  # by kind of step
        self.failed = False  # this step: until it is tried again nothing counts down

    def see(self, t_s: float) -> None:
        """Something came with this stamp."""
        self.seen_s = max(self.seen_s, t_s)
        if self._waits_since_s is None:
            self.pace.see(self.seen_s, time.monotonic())

    def begin(self, step: Step) -> None:
        """Another step, or the same anew: how much longer than its plan the one before took, those like it will."""
        before, took_s = self._step, step.t_s - (self._step.t_s if self._step else 0.0) - self._waited_s
        if before is not None and before.step_s and step.number == before.number + 1 and not self.failed:
            self._longer_s[kind_of(before.name)].append(took_s - before.step_s)
        self._step, self._waited_s, self._waits_since_s = step, 0.0, None
        self.failed = False

    def again(self, t_s: float) -> None:
        """The step is tried again: the whole of it is left."""
        self.failed = False
        if self._step is not None:
            self._waited_s = t_s - self._step.t_s

    def fails(self, t_s: float) -> None:
        """The step broke off: what is left is the whole of it, and waits for a person."""
        self.again(t_s)
        self.waits(t_s)
        self.failed = True

    def waits(self, since_s: float) -> None:
        """For a person, from now on."""
        self.pace.waits()
        for one in self._promised.values():
            one.waits(time.monotonic())
        if self._waits_since_s is None:
            self._waits_since_s = since_s

    def waits_no_more(self, t_s: float) -> None:
        """Somebody answered, or it goes on."""
        if self._waits_since_s is not None:
            self._waited_s += t_s - self._waits_since_s
            self._waits_since_s = None
            for one in self._promised.values():
                one.goes_on(time.monotonic())

    def promised_s(self, what: str, in_s: float) -> float:
        """In how long it comes by the clock on the wall, which is `in_s` by what is known now, as it was promised."""
        return self._promised[what].in_s(time.monotonic(), in_s)

    def left_s(self, at_its_begin_s: float) -> float:
        """What is left now of so much at the begin of the step."""
        if self._step is None:
            return at_its_begin_s
        now_s = self.seen_s if self._waits_since_s is None else self._waits_since_s
        return max(0.0, at_its_begin_s - max(0.0, now_s - self._step.t_s - self._waited_s))

    def longer_s(self, names: Iterable[str]) -> float:
        """How much longer than their plan these steps will take, by those like them that are over."""
        seen = (self._longer_s.get(kind_of(name)) for name in names)
        return sum(fmean(one) for one in seen if one)

    def share(self) -> float | None:
        """Of the lab time of the whole, 0 to 1, what is over; None where that is stated by no plan."""
        if self._step is None or not self._step.whole_s:
            return None
        within = self._step.left_s - (self._step.step_s or 0.0)  # a step that takes longer is not the one after it
        return 1.0 - min(1.0, max(within, self.left_s(self._step.left_s)) / self._step.whole_s)
