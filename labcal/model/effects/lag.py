"""A reading that belongs to an earlier field: the sensor's delay, or a clock that is off."""

from __future__ import annotations

import numpy as np

from labcal.model.effects.axis_tilt import LAG_OR_TILT
from labcal.model.effects.c_form import CForm
from labcal.model.effects.protocol import Array, Confounded, Family, Scene, Term
from labcal.model.effects.regressors import shifted
from labcal.model.effects.shape import SECANT, Shape
from labcal.record import Run

OVER = Shape("secant_s", 0.05, "s", kind=SECANT)
BACKWARD_IN_C = """\
const double step_s = now->t_s - state->t_s;
for (int j = 0; j < 3; ++j) {
    if (state->begun && state->segment == now->segment && step_s > 0)
        e[0][j] = (labcal_real)((double)(state->field[j] - now->field[j]) / step_s);
    state->field[j] = now->field[j];
}
state->t_s = now->t_s;
state->segment = now->segment;
state->begun = 1;"""
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


def in_c(term: Term) -> CForm:
    """The field belongs to t - lag; its column is minus the slope of a between the last two readings."""
    formula = "the reading stamped t is of the field at t - lag_s; what follows channels takes them at that time"
    return CForm(
        formula, BACKWARD_IN_C, state="double t_s; labcal_real field[3]; long segment; int begun;", stamps=True
    )


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
    in_c=in_c,
    drawn_against="angle",
)
