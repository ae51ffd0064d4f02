"""A reading that belongs to an earlier field: the sensor's delay, or a clock that is off, or that is off and drifts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.axis_tilt import LAG_OR_TILT
from labcal.model.effects.c_form import CForm
from labcal.model.effects.displaced import displaced
from labcal.model.effects.protocol import Array, Confounded, Family
from labcal.model.effects.regressors import shifted, shifted_and_unsure
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import GIVEN, SECANT, Shape
from labcal.model.effects.term import Term
from labcal.record import Run

OVER = Shape("secant_s", 0.05, "s", kind=SECANT)
DRIFTS = Shape("secant_ppm", 0.0, "ppm", kind=SECANT)
FROM = Shape("t_ref_s", 0.0, "s", kind=GIVEN)
EITHER_WAY = Shape("half_span_s", 0.0, "s", kind=GIVEN)
LEAST_s = 1e-3  # over less the secant of a lag that passes through zero is taken over this
LEAST_OF_A_ROW = 0.4  # the search begins with the slope at each row: between two rows a part of a secant averages both
PPM = 1e-6
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
    """The secant of e = a(t) − a(t + lag) over `secant_s`; against a reference e = p(t − lag) − p(t).

    A lag that drifts is lag_s + drift_ppm (t − t_ref_s) / 10⁶, its secant in each row over as much there.
    """
    step = _step_s(term, scene)
    if scene.rig is not None:
        p = scene.rig.prediction_nT
        secant = (displaced(scene.t_s, scene.segment, p, -step) - p) / step[:, None]
    else:
        a = scene.driving_field_nT
        secant = (a - shifted(scene.t_s, scene.segment, a, step)) / step[:, None]
    return _by_each(term, scene, secant)


def unsure(term: Term, scene: Scene) -> Array:
    """How far the secant may be off: the field lies between two rows, and may have turned far from one to the next."""
    step = _step_s(term, scene)
    _, off = shifted_and_unsure(scene.t_s, scene.segment, scene.driving_field_nT, step)
    return _by_each(term, scene, off / step[:, None])


def _step_s(term: Term, scene: Scene) -> Array:
    step = secant_s(term, scene.t_s)
    return np.where(np.abs(step) < LEAST_s, LEAST_s, step) if drifts(term) else step


def _by_each(term: Term, scene: Scene, secant: Array) -> Array:
    """The columns by lag_s and, where it drifts, by drift_ppm."""
    grows = [(scene.t_s - term.at(FROM.name)) * PPM] if drifts(term) else []
    return np.stack([secant, *(secant * one[:, None] for one in grows)], axis=2)


def drifts(term: Term) -> bool:
    """Whether it grows with time: on the run's own clock only."""
    return any(shape.name == DRIFTS.name for shape in term.shape)


def secant_s(term: Term, t_s: Array) -> Array:
    """Over which interval the secant of each row is taken (n,)."""
    grown = term.at(DRIFTS.name) * PPM * (t_s - term.at(FROM.name)) if drifts(term) else 0.0
    return np.asarray(term.at(OVER.name) + grown + np.zeros(len(t_s)))


def reach_s(term: Term) -> float:
    """How far ahead it looks, at most."""
    grown = term.at(DRIFTS.name) * PPM * term.at(EITHER_WAY.name) if drifts(term) else 0.0
    return abs(term.at(OVER.name)) + abs(grown)


def in_c(term: Term) -> CForm:
    """The field belongs to t - lag; its column is minus the slope of a between the last two readings."""
    formula = "the reading stamped t is of the field at t - lag_s; what follows channels takes them at that time"
    return CForm(
        formula, BACKWARD_IN_C, state="double t_s; labcal_real field[3]; long segment; int begun;", stamps=True
    )


def candidates(run: Run) -> list[Term]:
    """One lag for the whole run; one that drifts."""
    of_the_run = replace(FROM, value=float(run.t_s[0] + run.t_s[-1]) / 2)
    over = replace(OVER, value=min(OVER.value, LEAST_OF_A_ROW * float(np.median(np.diff(run.t_s)))))
    shape = (over, DRIFTS, of_the_run, replace(EITHER_WAY, value=float(run.t_s[-1] - run.t_s[0]) / 2))
    return [
        Term(kernel, (("lag_s", "s"),), shape=(over,)),
        Term(kernel, (("lag_s", "s"), ("drift_ppm", "ppm")), shape=shape),
    ]


FAMILY = Family(
    "lag",
    "sensor",
    kernel,
    candidates,
    phrase="the readings come later than the field",
    shapes=(OVER, DRIFTS, FROM, EITHER_WAY),
    from_vectors=True,
    experiment="turn faster, and backwards: a lag grows with the rate and changes sign with it",
    confounded=(LAG_OR_TILT, LAG_OR_EDDIES),
    bound_form=drifts,
    reach_s=reach_s,
    secant_s=secant_s,
    unsure=unsure,
    in_pieces=True,
    in_c=in_c,
    drawn_against="angle",
)
