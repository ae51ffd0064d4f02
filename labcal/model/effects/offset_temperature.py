"""Sensor offset that follows temperature, straight or curved: at once, behind it by thermal time constants, or ahead.

It is ahead (a negative time constant) where the thermometer is the slower of the two.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.c_form import CForm
from labcal.model.effects.c_responses import Driven, filtered, responses_in_c
from labcal.model.effects.following import (
    BEHIND,
    LATE,
    delayed_terms,
    first_order,
    instantaneous,
    multi_tau,
    reach_s,
    responses,
    time_constants,
)
from labcal.model.effects.protocol import Array, Confounded, Family, Scene, Term
from labcal.model.effects.regressors import low_passed, moving, on_each_axis, per_axis
from labcal.record import Run

LEADS_S = (-100.0, -30.0, -10.0, -3.0)  # of a thermometer that is slower than the sensor
TAU_S = (10.0, 30.0, 100.0, 300.0)
SEVERAL_S = (0, 60, 300)  # a housing and what is inside it
RISES = Confounded("a temperature that only rises", "a drift", "warm the device and let it cool again")


def kernel(term: Term, scene: Scene) -> Array:
    """E = c (T − T_ref) + d (T − T_ref)², T through a first-order response of time constant tau_s, or of several."""
    if not any(name.startswith("d_") for name, _ in term.parameters):
        return responses(term, scene)
    tau_s = term.at(BEHIND.name) if term.shape else 0.0
    T = low_passed(scene.t_s, scene.segment, term.drive(scene), tau_s, scene.past)
    return np.concatenate([on_each_axis(T), on_each_axis(T**2)], axis=2)


def in_c(term: Term) -> CForm:
    """The same in C."""
    formula = "E = c (T - T_ref) + d (T - T_ref)^2, c [nT/degC], d [nT/degC^2] for each axis of B; T as its inputs say"
    if not any(name.startswith("d_") for name, _ in term.parameters):
        return responses_in_c(term, formula, time_constants(term))
    lines, inputs, state, helpers = filtered(Driven(term))
    body = f"{lines}\non_each_axis(e, warm);\non_each_axis(e + 3, warm * warm);"
    return CForm(formula, body, inputs, state, (*helpers, "on_each_axis"))


def candidates(run: Run) -> list[Term]:
    """Each temperature that moves: prompt, behind, with several time constants, curved, and delayed."""
    tau, either = replace(BEHIND, grid=TAU_S), replace(BEHIND, grid=(*LEADS_S, *TAU_S))
    found = []
    for c in moving(run, ("temperature",)):
        straight = (instantaneous(c, kernel), first_order(c, kernel, tau))
        found += [straight[0], first_order(c, kernel, either), multi_tau(c, kernel, SEVERAL_S), *map(_curved, straight)]
        found += delayed_terms(c, kernel, run)
    return found


def _curved(term: Term) -> Term:
    unit = term.parameters[0][1].removeprefix("nT/")
    return replace(term, parameters=(*term.parameters, *per_axis("d", f"nT/{unit}^2")))


FAMILY = Family(
    "offset-temperature",
    "sensor",
    kernel,
    candidates,
    shapes=(BEHIND, LATE),
    adds_up=True,
    time_constants=time_constants,
    experiment="hold the attitude and warm the sensor, then let it cool",
    responds={"heat": 1.0},
    confounded=(RISES,),
    of_temperature=True,
    reach_s=reach_s,
    in_pieces=True,
    in_c=in_c,
)
