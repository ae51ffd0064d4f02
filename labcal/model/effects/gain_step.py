"""Scale factors that change at one moment: a power cycle that finds another reference voltage, a range that changes."""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Confounded, Family
from labcal.model.effects.regressors import STEP, per_axis, some_moment
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run

STEP_OR_WARMTH = Confounded(
    "a gain that steps", "a gain that follows a temperature", "repeat a segment at the temperature that it had before"
)


def kernel(term: Term, scene: Scene) -> Array:
    """E = g_i s_i along sensor axis i, from t_step on."""
    after = (scene.t_s >= term.at(STEP.name)).astype(float)[:, None]
    return np.asarray((after * scene.along_axes_nT)[:, None, :] * scene.axes)


def candidates(run: Run) -> list[Term]:
    """One step, anywhere but at the ends."""
    return [Term(kernel, per_axis("g", "1"), shape=(some_moment(run),))] if len(run) > 2 else []


FAMILY = Family(
    "gain-step",
    "sensor",
    kernel,
    candidates,
    phrase="the gain jumps at one moment",
    shapes=(STEP,),
    of_field=True,
    experiment="switch the device off and on, and repeat the segments before and after in the same field",
    confounded=(STEP_OR_WARMTH,),
    bound_to_run=True,
)
