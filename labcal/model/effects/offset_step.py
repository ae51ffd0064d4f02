"""Sensor offset that changes at one moment: a shock, a magnetised part, a load nobody recorded."""

from __future__ import annotations

from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import STEP, on_each_axis, per_axis, some_moment
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run


def kernel(term: Term, scene: Scene) -> Array:
    """E = c from t_step on."""
    return on_each_axis((scene.t_s >= term.at(STEP.name)).astype(float))


def candidates(run: Run) -> list[Term]:
    """One step, anywhere but at the ends."""
    return [Term(kernel, per_axis("c", "nT"), shape=(some_moment(run),))] if len(run) > 2 else []


FAMILY = Family(
    "offset-step",
    "sensor",
    kernel,
    candidates,
    phrase="the offset jumps at one moment",
    shapes=(STEP,),
    repeats=True,
    experiment="repeat the segments before and after the step",
    bound_to_run=True,
)
