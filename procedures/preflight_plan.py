"""The plan of a preflight: its turns in order, what an interruption has kept of them, and how long the rest takes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from labcal.bench.bench import Bench
from labcal.bench.mounting import AXES, inclined_field
from labcal.bench.rotation import Rotation, fastest_rate
from labcal.bench.steps import Plan, Resume, rate_between
from procedures.running_estimate import RunningEstimate

POSITIONS = ("DUT less reference, coils off", "DUT less reference, first position")
SYNC_S, AXES_S = 42.0, 44.0  # lab time of what is not a turn, for the time that is left
FIRST_S, MORE_S = (
    3.6,
    2.8,
)  # to the first field; of a turn beside its way: confirmed, both ends recorded


@dataclass(frozen=True, slots=True)
class PreflightPlan:
    """What a preflight does, resolved: every field in order, reversed ones negative, and the rate."""

    axes: tuple[str, ...]
    fields_nT: tuple[float, ...]
    modes: tuple[str, ...]
    inclination_deg: float
    rate_asked: bool
    rate_deg_per_s: float
    timing_nT: float
    u_time_s: float
    step_deg: float
    dwell_s: float
    zero_s: float
    closure_nT: float
    u_mounting_deg: float
    estimate: RunningEstimate
    finished: frozenset[str] = frozenset()  # steps done before an interruption, which are not repeated
    times: int = 0  # that it was gone on with: what is turned then has a mounting, thus a phase, of its own
    way_s: float = 0.0  # to the field of a turn from that of the one before, on average
    back_s: float = 0.0  # to where an axis began, after turns of which each goes on where the one before ended
    unclosed: frozenset[str] = frozenset()  # axes of which every turn is kept, and only the closure is to be made up

    def at_rate_of(self, bench: Bench) -> PreflightPlan:
        """The same at the fastest rate that is allowed, unless one was asked for; and how long its currents take."""
        fields = [inclined_field(bench, field_nT, self.inclination_deg) for field_nT in (*self.fields_nT, 0.0)]
        ways_s = [bench.cage.way_s(to - before) for before, to in zip(np.roll(fields, 1, axis=0), fields, strict=True)]
        there = len(self.fields_nT) * len(self.modes) % 2 and bench.by_hand is None
        back_s = 360.0 / rate_between(bench) if there else 0.0
        same = replace(self, way_s=float(np.mean(ways_s)), back_s=back_s)
        if self.rate_asked:
            return same
        strongest = max(abs(b) for b in self.fields_nT)
        return replace(
            same, rate_deg_per_s=fastest_rate(bench, strongest, self.inclination_deg, self.u_time_s, self.timing_nT)
        )

    def left(self, axis: str, done: frozenset[str]) -> list[tuple[str, str, float]]:
        """The turns about one body axis that are not done."""
        return [turn for turn in self.turns(axis) if turn[0] not in done]

    def to_mount(self, axis: str) -> bool:
        """Whether anything of one body axis is still to be measured."""
        return bool(self.left(axis, self.finished)) or axis in self.unclosed

    def without(self, axis: str) -> PreflightPlan:
        """The same where nothing that was turned about `axis` counts any more: all of it is left to do."""
        return replace(self, finished=self.finished - {name for name, _, _ in self.turns(axis)})

    def after(self, resume: Resume | None) -> PreflightPlan:
        """The same where what `resume` tells is kept: its turns, and of each axis the first position to close with."""
        if resume is None:
            return self
        kept = replace(self, finished=resume.done, times=resume.times)
        turned = [axis for axis in self.axes if not kept.left(axis, resume.done)]
        begun = {axis for axis in turned if first_of(axis) in resume.measured}
        return replace(kept, unclosed=frozenset(a for a in begun if f"closure {a}" not in resume.measured))

    def mounting(self, axis: str, done: frozenset[str]) -> str:
        """As what a turn about `axis` is mounted: nobody can prove that a DUT stands as before an interruption."""
        if not done or not self.times:
            return axis
        return f"{axis}.again" if self.times == 1 else f"{axis}.again{self.times}"

    def turned(self, done: frozenset[str]) -> bool:
        """Whether any turn is done."""
        return any(name in done for axis in self.axes for name, _, _ in self.turns(axis))

    def stood(self, done: frozenset[str]) -> str:
        """The body axis that was mounted when the run broke off after these steps; "" where none surely was."""
        mounted = [axis for axis in self.axes if f"mount-{axis}" in done]
        return mounted[-1] if mounted else self.axes[0] if "axes-check" in done else ""

    def turns(self, axis: str) -> Iterator[tuple[str, str, float]]:
        """Step name, mode and field of every turn about one body axis."""
        for mode in self.modes:
            for field_nT in self.fields_nT:
                yield f"{axis}{field_nT / 1000:+g}uT-{mode}", mode, field_nT

    def plan(self) -> Plan:
        """All steps with their lab time, those that are kept with none: theirs counts as done."""
        turn = Rotation("", AXES["x"], "", self.rate_deg_per_s, step_deg=self.step_deg, dwell_s=self.dwell_s)
        one, opening_s, kept_s = turn.seconds() + self.way_s + MORE_S, self.zero_s + self.dwell_s + FIRST_S, 0.0
        steps = [("zero", opening_s), ("axes-check", AXES_S), ("sync-check", SYNC_S)]
        both_s = self.dwell_s + FIRST_S, self.dwell_s + FIRST_S + self.back_s  # before its turns, after them
        for axis in self.axes:
            left = {name: one for name, _, _ in self.left(axis, self.finished)}
            turns = [(name, left.get(name, 0.0)) for name, _, _ in self.turns(axis)]
            mount_s, closure_s = both_s if self.to_mount(axis) else (0.0, 0.0)
            steps += [(f"mount-{axis}", mount_s), *turns, (f"closure-{axis}", closure_s)]
            kept_s += one * (len(turns) - len(left)) + sum(both_s) - mount_s - closure_s
        return Plan((*steps, ("closing", opening_s)), self.asks(), kept_s)

    def asks(self) -> frozenset[str]:
        """The steps that begin with mounting or switching; the first mounting is in the zero."""
        left = {axis: self.left(axis, self.finished) for axis in self.axes if self.to_mount(axis)}
        mounted = {f"mount-{axis}" for axis in list(left)[1:]}
        first = {axis: {mode: name for name, mode, _ in reversed(turns)} for axis, turns in left.items()}
        switched = {name for of in first.values() for mode, name in of.items() if mode != self.modes[0]}
        back = {f"closure-{axis}" for axis, of in first.items() if set(of) - {self.modes[0]}}
        return frozenset(mounted | back | switched | {"closing"})


def first_of(axis: str) -> str:
    """How the measurement is called that a closure which is made up needs: |DUT| − |reference| before its turns."""
    return f"mount-{axis}: {POSITIONS[1]}"
