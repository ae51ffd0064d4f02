"""A reading that belongs to an earlier field: the sensor's delay, or a clock that is off."""

from __future__ import annotations

import numpy as np

from labcal.model.effects.axis_tilt import LAG_OR_TILT
from labcal.model.effects.protocol import Array, Confounded, Family, Scene, Term
from labcal.model.effects.regressors import shifted
from labcal.model.effects.shape import SECANT, Shape
from labcal.record import Run

OVER = Shape("secant_s", 0.05, "s", kind=SECANT)
LAG_OR_EDDIES = Confounded(
    "a lag", "eddy currents in the device's housing", "change the field at rest: eddy currents decay, a lag only shifts"
)


def kernel(term: Term, scene: Scene) -> Array:
    """The secant of e = a(t) − a(t + lag) over the shape `secant_s`; against a reference e = p(t − lag) − p(t)."""
    step = term.at(OVER.name)
    if scene.rig is not None:
        p = scene.rig.prediction_nT
        return np.asarray((shifted(scene.t_s, scene.segment, p, -step) - p)[:, :, None] / step)
    a = scene.driving_field_nT
    return np.asarray((a - shifted(scene.t_s, scene.segment, a, step))[:, :, None] / step)


def candidates(run: Run) -> list[Term]:
    """One lag for the whole run."""
    return [Term(kernel, (("lag_s", "s"),), shape=(OVER,))]


FAMILY = Family(
    "lag",
    "sensor",
    kernel,
    candidates,
    shapes=(OVER,),
    from_vectors=True,
    experiment="turn faster, and backwards: a lag grows with the rate and changes sign with it",
    confounded=(LAG_OR_TILT, LAG_OR_EDDIES),
    in_pieces=True,
    drawn_against="angle",
)
