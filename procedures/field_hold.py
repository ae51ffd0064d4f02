"""A set-point held by feedback on the reference: the ambient field is tracked while it runs."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.steps import (
    Plan,
    Procedure,
    Work,
    coils_off,
    energise,
    energise_again,
    measure_ambient,
    measured,
    ready,
    rest,
)
from labcal.bench.streams.samples import samples
from labcal.errors import InputError, InstrumentError
from labcal.record.stream import Event
from procedures.tracking_error import rms_error

NEEDS, LASTS_MIN = "a vector reference", 3

Array = NDArray[np.float64]
STUCK_NT = 200.0
ZERO_S, STEP_S = 5.0, 0.65  # coils-off zero before; of lab time for a correction beside its period


def field_hold(
    bench: Bench,
    *,
    field_nT: Annotated[tuple[float, ...], Limits(-1e5, 1e5, unit="nT"), "total field x, y, z in C"] = (0.0, 0.0, 30e3),
    duration_s: Annotated[float, Limits(10, 86_400, unit="s"), "how long it is held"] = 120.0,
    period_s: Annotated[float, Limits(0.5, 60, unit="s"), "of the feedback"] = 2.0,
    gain: Annotated[float, Limits(0.01, 1), "part of the error taken back each time"] = 0.5,
    dead_nT: Annotated[float, Limits(0, 1e4, unit="nT"), "errors below this are left: the supplies' own step"] = 25.0,
    limit_nT: Annotated[float, Limits(0.1, 1e5, unit="nT"), "rms error that passes"] = 60.0,
) -> Procedure:
    """Hold a field by feedback on the reference, taken over from the open-loop set-point without a bump."""
    if bench.config.reference.kind != "vector" or len(field_nT) != 3:
        raise InputError("field-hold needs a vector reference and three numbers, --set field_nT=0,0,30000")
    target, rounds = np.array(field_nT), round(duration_s / period_s)
    held_s = rounds * (period_s + STEP_S)
    plan = Plan(
        (("ambient field", ZERO_S), ("open loop", 3 * period_s + 4), ("held", held_s)), frozenset({"open loop"})
    )
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, "ambient field")
        yield from measure_ambient(bench, ZERO_S)
        yield plan.begin(bench, "open loop")
        yield from ready(bench, f"The field goes to {np.linalg.norm(target) / 1000:g} µT and stays. Hands off?")
        yield from energise(bench, target)
        open_loop = yield from _error(bench, target, "open-loop", 3 * period_s)
        yield from measured(bench, "open-loop error", float(np.linalg.norm(open_loop)), 0.0, "nT")
        yield plan.begin(bench, "held")
        yield from energise_again(bench, target)
        yield from _held(bench, target, rounds, period_s, gain, dead_nT, limit_nT)
        yield from coils_off(bench)


def _held(
    bench: Bench, target: Array, rounds: int, period_s: float, gain: float, dead_nT: float, limit_nT: float
) -> Work[None]:
    """An integrator alone: it starts from the ambient field as it was assumed, so the hand-over moves nothing.

    It does not run after a reading that stands still while the coils move.
    """
    errors, frozen = list[Array](), Frozen(bench.reference.name)
    for number in range(rounds):
        readings = yield from _readings(bench, f"held-{number + 1}", period_s)
        frozen.see(readings)
        error = readings.mean(axis=0) - target
        errors.append(error)
        if np.linalg.norm(error) > dead_nT:
            bench.cage.ambient_nT = bench.cage.ambient_nT + gain * error
            yield from energise(bench, target)
            frozen.moved_nT += gain * float(np.linalg.norm(error))
    settled = np.array(errors[rounds // 4 :])
    yield from rms_error(bench, "rms error while held", settled + target, target, limit_nT)
    ambient = bench.cage.ambient_nT.tolist()
    yield Event(bench.clock.now(), "ambient", "the ambient field as tracked", {"ambient_nT": ambient})


@dataclass
class Frozen:
    """Notices a reference that shows the same while the coils have moved the field by `STUCK_NT`."""

    name: str
    moved_nT: float = 0.0  # since the reading changed last
    _last: Array | None = None

    def see(self, readings: Array) -> None:
        """Take in the readings (n, 3) of one round. Raises InstrumentError (stuck)."""
        if self._last is None or np.any(readings != self._last):
            self.moved_nT = 0.0
        if self.moved_nT > STUCK_NT:
            raise InstrumentError(
                f"{self.name}: the coils have moved the field by {self.moved_nT:.0f} nT and the reading not at all.",
                fault="stuck",
                remedy="Switch the sensor off and on, and look at its range.",
            )
        self._last = readings[-1]


def _error(bench: Bench, target: Array, name: str, seconds: float) -> Work[Array]:
    readings = yield from _readings(bench, name, seconds)
    return np.asarray(readings.mean(axis=0) - target)


def _readings(bench: Bench, name: str, seconds: float) -> Work[Array]:
    blocks = yield from rest(bench, name, seconds)
    return samples(blocks, "reference").values
