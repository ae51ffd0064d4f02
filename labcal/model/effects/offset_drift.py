"""Sensor offset that drifts smoothly in time: a polynomial, or a settling after switch-on."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.offset_temperature import RISES
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import AXES, on_each_axis
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import GIVEN, TIME_CONSTANT, Shape
from labcal.model.effects.term import Term
from labcal.record import Run

DEGREES = (1, 2, 3, 5)  # the last follows a slow wave once through the run
FROM = Shape("t_ref_s", 0.0, "s", kind=GIVEN)
SETTLES = Shape("tau_s", 0.0, "s", kind=TIME_CONSTANT)


def kernel(term: Term, scene: Scene) -> Array:
    """E = Σ c_k (t − t_ref)^k, or c exp(−(t − t_ref)/tau) where the form has a tau."""
    t = scene.t_s - term.at(FROM.name)
    if (settles := term.of(TIME_CONSTANT)) is not None:
        return on_each_axis(np.exp(-t / settles.value))
    powers = range(1, len(term.parameters) // 3 + 1)
    return np.concatenate([on_each_axis(t**k) for k in powers], axis=2)


def candidates(run: Run) -> list[Term]:
    """Polynomials about the middle of the run, and a settling from its start."""
    first, last = float(run.t_s[0]), float(run.t_s[-1])
    span = last - first
    if span <= 0:
        return []
    centre = (replace(FROM, value=(first + last) / 2),)
    found = [Term(kernel, _polynomial(degree), shape=centre) for degree in DEGREES]
    grid = tuple(span * f for f in (0.05, 0.15, 0.4))
    settling = (replace(FROM, value=first), replace(SETTLES, value=grid[1], grid=grid))
    return [*found, Term(kernel, tuple((f"c_{a}", "nT") for a in AXES), shape=settling)]


def _polynomial(degree: int) -> tuple[tuple[str, str], ...]:
    return tuple((f"c{k}_{a}", f"nT/s^{k}" if k > 1 else "nT/s") for k in range(1, degree + 1) for a in AXES)


FAMILY = Family(
    "offset-drift",
    "sensor",
    kernel,
    candidates,
    shapes=(FROM, SETTLES),
    experiment="repeat the first segment at the end, and again after a pause",
    responds={"heat": 1.0},
    confounded=(RISES,),
    bound_to_run=True,
)
