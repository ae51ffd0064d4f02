"""A reading that belongs to an earlier field: the sensor's delay, or a clock that is off."""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Family, Scene, Shape, Term
from labcal.model.effects.regressors import shifted
from labcal.record import Run


def kernel(term: Term, scene: Scene) -> Array:
    """The secant of e = a(t) − a(t + lag) over the shape `secant_s`; against a reference e = p(t − lag) − p(t)."""
    step = term.at("secant_s")
    if scene.rig is not None:
        p = scene.rig.prediction_nT
        return np.asarray((shifted(scene.t_s, scene.segment, p, -step) - p)[:, :, None] / step)
    a = scene.driving_field_nT
    return np.asarray((a - shifted(scene.t_s, scene.segment, a, step))[:, :, None] / step)


def candidates(run: Run) -> list[Term]:
    """One lag for the whole run."""
    return [Term(kernel, (("lag_s", "s"),), shape=(Shape("secant_s", 0.05, "s"),))]


FAMILY = Family(
    "lag",
    "sensor",
    kernel,
    candidates,
    shapes=("secant_s",),
    experiment="turn faster, and backwards: a lag grows with the rate and changes sign with it",
    from_vectors=True,
    in_pieces=True,
)
