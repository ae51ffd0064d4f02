"""Sensor offset that drifts smoothly in time: a polynomial, a wave of fewer than three cycles, or a settling."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.offset_temperature import RISES
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import AXES, on_each_axis, per_axis
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import GIVEN, TIME_CONSTANT, Shape
from labcal.model.effects.term import Term
from labcal.record import Run

DEGREES = (1, 2, 3, 5)  # the last follows a slow wave once through the run
HALF_WAVES = (4, 6)  # through the run: two cycles, and three, from which on a wave is a line
ENDS = 2  # degree of the polynomial beside them: whatever the slopes at the two ends are
FROM = Shape("t_ref_s", 0.0, "s", kind=GIVEN)
OVER = Shape("over_s", 0.0, "s", kind=GIVEN)
SETTLES = Shape("tau_s", 0.0, "s", kind=TIME_CONSTANT)


def kernel(term: Term, scene: Scene) -> Array:
    """E = Σ c_k (t − t_ref)^k, or c exp(−(t − t_ref)/tau) where the form has a tau.

    With half waves E = Σ c_k (t − t_ref)^k + Σ w_h cos(h π (t − t_ref) / over), the run being that long.
    """
    t = scene.t_s - term.at(FROM.name)
    if (settles := term.of(TIME_CONSTANT)) is not None:
        return on_each_axis(np.exp(-t / settles.value))
    count = len(term.parameters) // 3
    if not any(shape.name == OVER.name for shape in term.shape):
        return np.concatenate([on_each_axis(t**k) for k in range(1, count + 1)], axis=2)
    through = np.pi * t / term.at(OVER.name)
    waves = [np.cos(h * through) for h in range(1, count - ENDS + 1)]
    return np.concatenate([on_each_axis(drive) for drive in (*(t**k for k in range(1, ENDS + 1)), *waves)], axis=2)


def candidates(run: Run) -> list[Term]:
    """Polynomials about the middle of the run, half waves and a settling from its start."""
    first, last = float(run.t_s[0]), float(run.t_s[-1])
    span = last - first
    if span <= 0:
        return []
    centre = (replace(FROM, value=(first + last) / 2),)
    found = [Term(kernel, _polynomial(degree), shape=centre) for degree in DEGREES]
    whole = (replace(FROM, value=first), replace(OVER, value=span))
    found += [Term(kernel, (*_polynomial(ENDS), *_half_waves(most)), shape=whole) for most in HALF_WAVES]
    grid = tuple(span * f for f in (0.05, 0.15, 0.4))
    settling = (replace(FROM, value=first), replace(SETTLES, value=grid[1], grid=grid))
    return [*found, Term(kernel, tuple((f"c_{a}", "nT") for a in AXES), shape=settling)]


def _polynomial(degree: int) -> tuple[tuple[str, str], ...]:
    return tuple((f"c{k}_{a}", f"nT/s^{k}" if k > 1 else "nT/s") for k in range(1, degree + 1) for a in AXES)


def _half_waves(most: int) -> tuple[tuple[str, str], ...]:
    return tuple(p for h in range(1, most + 1) for p in per_axis(f"w{h}", "nT"))


FAMILY = Family(
    "offset-drift",
    "sensor",
    kernel,
    candidates,
    phrase="the offset drifts with time",
    shapes=(FROM, OVER, SETTLES),
    experiment="repeat the first segment at the end, and again after a pause",
    responds={"heat": 1.0},
    confounded=(RISES,),
    bound_to_run=True,
)
