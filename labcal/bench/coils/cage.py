"""The coils as one thing: limits, ramps, read-back, and the way to zero. Refuses, never clips."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.bench.clock import Clock
from labcal.bench.coils.advice import as_if, by_hand
from labcal.bench.coils.agreement import FieldCheck
from labcal.bench.coils.current_history import CurrentHistory
from labcal.bench.coils.doubt import Doubt, StoredDoubt
from labcal.bench.coils.sign import SignCheck, SignProbe
from labcal.bench.coils.state import NOT_BY_REFERENCE, CoilReading, Witness
from labcal.bench.coils.windings import Windings
from labcal.bench.coils.zero import RAMP_STEP_S, AtZero, to_zero
from labcal.bench.config import AXES, CageConfig, CageLimits, DutLimits
from labcal.bench.driver_kit.roles import CoilSupply
from labcal.errors import InstrumentError, LimitError

Array = NDArray[np.float64]
LONGEST_RAMP_DOWN_S = 1.5
LOOK_AGAIN_S = (0.5, 2.0)
FOLLOWS = 0.01  # of the set-point, between what was set and what flows
SAMPLE_S = 0.05  # after a zero the reference is looked at so often


class Cage:
    """Three coil axes with a measured current-to-field matrix.

    `ambient_nT` (3,) is the field in C with the coils at zero, as last measured by whoever measured it; `set_field`
    aims at the total field. `wait` is how time passes during ramps: the bench keeps its streams read meanwhile.
    `guardian` brings real coils to zero in its own process, with the reason. `contacts` are the axes behind reversing
    contacts, whose sign is confirmed by what `see` sees: the reference's field (3,) in C, None where there is none.
    `check` hears what the reference sends and compares it with what ought to flow; where it does not see a zero that
    the supplies state, `latch` keeps everything from being energised. `where` tells a person which supply a name means.
    """

    def __init__(
        self,
        config: CageConfig,
        supplies: Mapping[str, CoilSupply],
        clock: Clock,
        *,
        dut_limits: DutLimits | None = None,
        wait: Callable[[float], None] | None = None,
        guardian: Callable[[str], list[AtZero]] | None = None,
        contacts: Collection[str] = (),
        see: Callable[[], Array | None] = lambda: None,
        blind: str = "no reference is there to see it",
        latch: StoredDoubt | None = None,
        where: Callable[[str], str] = str,
    ) -> None:
        self.limits: CageLimits = config.limits
        self.matrix_nT_per_A: Array = config.matrix
        self.ambient_nT: Array = np.zeros(3)
        self._settle_s = config.settle_s
        self._dut_field_nT = dut_limits.field_nT if dut_limits else None
        self.supplies: Mapping[str, CoilSupply] = {axis: supplies[axis] for axis in AXES}
        self._clock = clock
        self._wait = wait or clock.wait_until
        self._guardian, self._where = guardian, where
        self.flown = CurrentHistory()
        self.abrupt: set[str] = set()  # axes that have come to zero without a ramp
        self.on = False  # outputs closed
        self.over: Exception | None = None  # why no current is set any more, whoever asks for it
        self.asked_nT: Array | None = None  # the field (3,) that the coils are held at; None where none was asked for
        self.settled_s = -math.inf  # on the bench's clock: what a reference saw earlier belongs to other currents
        self.to_zero_since_s: float | None = None  # when zero was wanted (monotonic clock), until that has ended
        self._held_A: Array | None = None  # what ought to flow; None on the way there, and with the outputs open
        floor_A = {axis: 2 * supply.zero_current_A for axis, supply in self.supplies.items()}
        self._signs = SignCheck(self.matrix_nT_per_A, contacts, floor_A, see)
        self.check = FieldCheck(self.matrix_nT_per_A, np.asarray(config.limits.current_A, dtype=float), blind)
        self.latch = latch or StoredDoubt(())
        self._read = {axis: CoilReading(axis) for axis in AXES}
        limits = config.limits
        self._windings = Windings(limits.rms_current_A or (math.inf,) * 3, limits.rms_window_s)
        self._refuse_slow_supplies()

    def set_field(self, b_nT: ArrayLike, *, confirm_signs: bool = True) -> None:
        """Bring the total field at the centre to `b_nT` (3,) in C, as `set_currents` does."""
        b = np.asarray(b_nT, dtype=float)
        self.set_currents(np.linalg.solve(self.matrix_nT_per_A, b - self.ambient_nT), confirm_signs=confirm_signs)
        self.asked_nT = b

    def refuse_beyond_limits(self, b_nT: ArrayLike) -> None:
        """Raise LimitError where `set_field` would for `b_nT` (3,); nothing is sent."""
        b = np.asarray(b_nT, dtype=float)
        self._refuse_beyond_limits(np.asarray(np.linalg.solve(self.matrix_nT_per_A, b - self.ambient_nT)))

    def set_currents(self, i_A: ArrayLike, *, confirm_signs: bool = True) -> None:
        """Ramp the coils to `i_A` (3,), read every step back, then wait until they are settled.

        Behind reversing contacts the sign is confirmed on the reference, unless that is what the caller measures.
        Raises LimitError (nothing was sent), InstrumentError where a supply or a reversing contact does not follow, and
        `over` where the end was ordered.
        """
        target = np.asarray(i_A, dtype=float)
        self._refuse_when_over()
        self._refuse_beyond_limits(target)
        if (doubt := self.latch.doubt) is not None:
            raise doubt.error()
        self._held_A, self.asked_nT, now = None, None, self._clock.now()
        self.check.leaves_zero(now)
        self.check.expect(None, now, now)
        self._close_outputs()
        if confirm_signs:
            self._confirm_signs(target)
        self._ramp(target)
        self._wait(self._clock.now() + self._settle_s)
        self._held_A, self.settled_s = target, self._clock.now()
        if confirm_signs:  # else they are what the caller measures
            self.check.expect(target, self._clock.now(), self._clock.now())
        self.currents_A()

    def field_nT(self) -> Array:
        """The field (3,) in C that the measured currents make, ambient included."""
        return np.asarray(self.matrix_nT_per_A @ self.currents_A() + self.ambient_nT)

    def currents_A(self) -> Array:
        """Measured signed currents (3,).

        Raises InstrumentError: "limit reached" where a winding has had enough, "tripped" or "wrong mode" where another
        current flows than is held.
        """
        begun = self._clock.now()
        currents = np.array([self.read(axis) for axis in AXES])
        self._windings.see(currents, self._clock.now())
        self.flown.see(begun, currents)
        if self._held_A is not None:
            self._confirm(self._held_A, currents)
        return currents

    def set_points_A(self) -> Array:
        """Signed set-points (3,), read back."""
        return np.array([supply.set_point() for supply in self.supplies.values()])

    @property
    def changing(self) -> bool:
        """Whether the currents are on their way, up or to zero."""
        return self.to_zero_since_s is not None or (self.on and self._held_A is None)

    @property
    def flowing_A(self) -> Array:
        """Signed currents (3,), as last read."""
        return self.flown.last_A

    @property
    def way_down_s(self) -> float:
        """How long the ramp to zero takes from the set-points that were read last; 0 with the outputs open."""
        last_A = {axis: abs(self._read[axis].set_A or 0.0) for axis in AXES}
        return max(last_A[axis] / rate for axis, rate in self._rates().items()) if self.on else 0.0

    def way_s(self, change_nT: ArrayLike) -> float:
        """How long the currents take for a change (3,) of the field, and until that is believed."""
        change_A = np.abs(np.linalg.solve(self.matrix_nT_per_A, np.asarray(change_nT, dtype=float)))
        return float(np.max(change_A / list(self._rates().values()))) + self._settle_s

    def coils(self) -> tuple[CoilReading, ...]:
        """Each axis as it was last read, on the bench's clock."""
        return tuple(self._read.values())

    def zero(self) -> None:
        """Ramp every coil to zero, see it below its `zero_current_A`, open its output where it can open.

        A failure of one axis does not skip the others; the first failure is raised at the end. Where the supplies have
        none, and a reference beside the DUT sees the field of a current all the same, InstrumentError (not zero).
        """
        begun, was_on = self._clock.now(), self.on
        self.on, self._held_A, self.asked_nT = False, None, None
        self._signs.forget()
        if was_on:
            self.check.expect(None, begun, begun)
        ended = self._all_to_zero()
        if was_on:
            self.settled_s = self._clock.now() + self._settle_s
        self.abrupt |= {end.axis for end in ended if end.abrupt}
        self._note(ended, begun)
        self._ask_the_reference(begun, was_on)
        doubt = self._not_zero() if self.check.witness.verdict == "disagrees" else None
        if faults := [end.fault for end in ended if end.fault is not None]:
            raise faults[0]
        if doubt is not None:
            raise doubt

    def refuse_what_is_not_seen(self) -> None:
        """Raise InstrumentError where the reference has long seen another field than the coils are said to make."""
        if (found := self.check.witness).verdict != "disagrees":
            return
        if self.check.zero_expected:
            raise self._not_zero()
        said = " ".join(f"{i:+.4g}" for i in self.flowing_A)
        raise InstrumentError(
            f"the supplies state {said} A, and the reference does not see that: {found.words}.",
            fault="not seen",
            remedy="Does every supply obey, are signs and constants right, was something magnetic moved? axes-check "
            "tells which coil it is.",
        )

    def _not_zero(self) -> InstrumentError:
        """What the reference saw against the supplies' word; from here on nothing is energised."""
        found = self.witness
        if self.latch.doubt is None:
            utc = f"{self._clock.utc():%Y-%m-%d %H:%M} UTC"
            self.latch.set(Doubt(utc, found.words, found.seen_nT, found.expected_nT, advice=found.advice))
        return InstrumentError(f"{NOT_BY_REFERENCE}: {found.words}.", fault="not zero", remedy=f"{found.advice}.")

    @property
    def witness(self) -> Witness:
        """What the reference says of the coils; where it sees no zero, with what a person can do about it."""
        found = self.check.witness
        if found.verdict != "disagrees" or not self.check.zero_expected:
            return found
        apart = np.subtract(found.seen_nT or 0.0, found.expected_nT or 0.0)
        supplies = {axis: (self._where(supply.name), supply.can_open) for axis, supply in self.supplies.items()}
        return replace(found, advice=by_hand(as_if(apart, self.matrix_nT_per_A, found.limit_nT), supplies))

    def read(self, axis: str) -> float:
        """The measured signed current of one axis [A], noted with its time. Raises InstrumentError."""
        supply = self.supplies[axis]
        try:
            current = supply.measure_current()
        except InstrumentError as fault:
            self._known(axis, current_A=None, zero=False, read_s=None, fault=str(fault))
            raise
        zero = abs(current) < supply.zero_current_A
        self._known(axis, current_A=current, zero=zero, read_s=self._clock.now(), fault="")
        return current

    def _known(self, axis: str, **what: Any) -> None:
        self._read[axis] = replace(self._read[axis], **what)

    def _note(self, ended: Sequence[AtZero], begun_s: float) -> None:
        """How each axis ended; the guardian reads by the computer's clock."""
        for end in ended:
            read_s, known = self._clock.now(), end.current_A is not None
            if self._guardian is not None:
                read_s = begun_s if end.read_s is None else read_s - (time.monotonic() - end.read_s)
            self._read[end.axis] = CoilReading(
                end.axis, 0.0 if known else None, end.current_A, known, end.opened, read_s if known else None,
                "" if end.fault is None else str(end.fault),
            )  # fmt: skip

    def _ask_the_reference(self, begun_s: float, was_on: bool) -> None:
        """Wait until it has seen the zero, or seen that it is none; that is remembered beyond this session."""
        settled_s = self._clock.now() + self._settle_s
        if not self.check.zero_expected:
            self.check.expect(np.zeros(3), begun_s, settled_s)
        self._wait_whatever_fails(self._clock.now())  # no time passes: what has come is taken in
        while was_on and self.check.waits_for_more(self._clock.now() - settled_s):
            self._wait_whatever_fails(self._clock.now() + SAMPLE_S)
        found = self.check.witness
        if found.verdict == "agrees" and self.latch.doubt is not None and all(coil.zero for coil in self.coils()):
            utc = f"{self._clock.utc():%Y-%m-%d %H:%M} UTC"
            self.latch.lift(f"supplies and reference agree again, {utc}: {found.words}")

    def _all_to_zero(self) -> list[AtZero]:
        self.to_zero_since_s = time.monotonic()
        try:
            return self._guardian(f"session {os.getpid()} orders it") if self._guardian else self._to_zero()
        except InstrumentError as fault:  # the guardian is lost: nobody knows what flows
            for axis in AXES:
                self._known(axis, current_A=None, zero=False, read_s=None, fault=str(fault))
            raise
        finally:
            self.to_zero_since_s = None

    def _to_zero(self) -> list[AtZero]:
        return list(to_zero(self.supplies, self._rates(), self._clock, self._wait_whatever_fails).values())

    def _wait_whatever_fails(self, t_s: float) -> None:
        """A stream that has died is reported elsewhere; it does not keep the coils from zero."""
        with suppress(InstrumentError):
            self._wait(t_s)
        self._clock.wait_until(t_s)

    def _rates(self) -> dict[str, float]:
        limits = zip(AXES, self.limits.ramp_A_per_s, strict=True)
        return {axis: min(limit, self.supplies[axis].ramp_A_per_s) for axis, limit in limits}

    def _close_outputs(self) -> None:
        for supply in self.supplies.values() if not self.on else ():
            supply.set_current(0.0)
            supply.output(True)
        for axis in AXES if not self.on else ():
            self._known(axis, open=False, set_A=0.0)
        self.on = True

    def _confirm_signs(self, target: Array) -> None:
        """Stop on the way where an axis has left zero behind its contacts, and see that its field has the sign."""
        for probe in self._signs.probes(self.set_points_A(), target):
            if (before := self._seen_at(probe.before)) is None or (after := self._seen_at(probe.after)) is None:
                return
            if not probe.before.any() and self.check.ambient_nT is None:
                self.check.take_ambient(before, self._clock.now())  # this one was measured since the mounting
            try:
                self._judge(probe, before, after)
            except InstrumentError:
                self.zero()
                raise

    def _judge(self, probe: SignProbe, before: Array, after: Array) -> None:
        """Look again, and later, where the step is not seen: readings may come late, contacts do not."""
        for later_s in LOOK_AGAIN_S:
            with suppress(InstrumentError):
                self._signs.judge(probe, before, after)
                return
            self._wait(self._clock.now() + later_s)
            if (late := self._signs.see()) is not None:
                after = late
        self._signs.judge(probe, before, after)

    def _seen_at(self, i_A: Array) -> Array | None:
        self._ramp(i_A)
        self._wait(self._clock.now() + self._settle_s)
        return self._signs.see()

    def _confirm(self, held: Array, currents: Array) -> None:
        for axis, supply, wanted, flows in zip(AXES, self.supplies.values(), held, currents, strict=True):
            if abs(flows - wanted) <= max(supply.zero_current_A, FOLLOWS * abs(wanted)):
                continue
            if abs(flows) < supply.zero_current_A:
                raise InstrumentError(
                    f"coil {axis}: {wanted:.4g} A was set and nothing flows.",
                    fault="tripped",
                    remedy="Has its output gone off by itself, is the winding open? Set the coils off, look at its "
                    "panel, and find out why before it is cleared.",
                )
            raise InstrumentError(
                f"coil {axis}: {wanted:.4g} A was set and {flows:.4g} A flows.",
                fault="wrong mode",
                remedy="Is the winding whole, does the voltage suffice? Set the coils off.",
            )

    def _ramp(self, target: Array) -> None:
        start = self.set_points_A()
        duration = float(np.max(np.abs(target - start) / list(self._rates().values())))
        steps = max(1, math.ceil(duration / RAMP_STEP_S))
        for step in range(1, steps + 1):
            self._refuse_when_over()
            begun = self._clock.now()  # of this step: time lost in reversing contacts is not caught up
            for axis, value in zip(AXES, (start + (target - start) * step / steps).tolist(), strict=True):
                self.supplies[axis].set_current(value)
                self._known(axis, set_A=value)
            self._wait(begun + duration / steps)

    def _refuse_when_over(self) -> None:
        if self.over is not None:
            raise self.over

    def _refuse_beyond_limits(self, target: Array) -> None:
        for axis, value, limit in zip(AXES, target, self.limits.current_A, strict=True):
            if not abs(value) <= limit:
                raise LimitError(f"coil {axis}: {value:.4g} A is beyond its limit of {limit:g} A; nothing was set.")
        self._windings.refuse(target)
        field = float(np.linalg.norm(self.matrix_nT_per_A @ target + self.ambient_nT))
        for owner, limit_nT in (("the cage", self.limits.field_nT), ("the DUT", self._dut_field_nT)):
            if limit_nT is not None and field > limit_nT:
                raise LimitError(
                    f"a field of {field:.0f} nT is beyond the limit of {owner}, {limit_nT:.0f} nT; nothing was set."
                )

    def _refuse_slow_supplies(self) -> None:
        for (axis, rate), limit in zip(self._rates().items(), self.limits.current_A, strict=True):
            needed = limit / rate
            if needed > LONGEST_RAMP_DOWN_S:
                raise LimitError(
                    f"coil {axis}: {limit:g} A would take {needed:.2f} s to ramp down, more than "
                    f"{LONGEST_RAMP_DOWN_S:g} s; lower current_A or raise ramp_A_per_s."
                )
