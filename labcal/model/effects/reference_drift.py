"""The reference's zero drifts along the run."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.offset_drift import FROM
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import AXES
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run, offers

DEGREES = (1, 2, 5)


def kernel(term: Term, scene: Scene) -> Array:
    """E = R Σ c_k (t − t_ref)^k, fixed in the cage and seen from the body."""
    assert scene.rig is not None
    t = scene.t_s - term.at(FROM.name)
    powers = range(len(term.parameters) // 3)
    return np.concatenate([scene.rig.to_body * (t**k)[:, None, None] for k in powers], axis=2)


def candidates(run: Run) -> list[Term]:
    """A line, a parabola, and a polynomial that follows a slow wave once through the run."""
    if not any(offers(run, s) == "vector" and s.reference_frame == "cage" for s in run.segments):
        return []
    middle = (replace(FROM, value=float(run.t_s[0] + run.t_s[-1]) / 2),)
    units = ("nT", "nT/s", *(f"nT/s^{k}" for k in range(2, max(DEGREES) + 1)))
    return [
        Term(kernel, tuple((f"c{k}_{a}", units[k]) for k in range(degree + 1) for a in AXES), shape=middle)
        for degree in DEGREES
    ]


FAMILY = Family(
    "reference-drift",
    "rig",
    kernel,
    candidates,
    phrase="the reference drifts with time",
    shapes=(FROM,),
    extends=("cage-field",),
    experiment="compare the reference with a second one before and after",
    responds={"bare platform": 1.0, "turn reference": -1.0},
    bound_to_run=True,
)
