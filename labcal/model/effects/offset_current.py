"""Sensor offset in proportion to a housekeeping current, at once, after a delay or through a first-order lag.

Springmann & Cutler 2011, (7): the bias varies as S i(t). Eddy currents and filters in the supply make it follow late.
"""

from __future__ import annotations

from dataclasses import replace

from labcal.model.effects.c_form import CForm
from labcal.model.effects.c_responses import responses_in_c
from labcal.model.effects.following import (
    BEHIND,
    LATE,
    OFF,
    WITHIN,
    begun_anew,
    begun_elsewhere,
    delayed_terms,
    first_order,
    instantaneous,
    multi_tau,
    reach_s,
    responses,
    time_constants,
)
from labcal.model.effects.protocol import Array, Confounded, Family
from labcal.model.effects.regressors import moving
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run

TAU_S = (1.0, 3.0, 10.0, 30.0)
SEVERAL_S = (0, 3, 12, 50)  # a response that no single time constant describes
LOCKED = Confounded(
    "currents locked to the attitude (panels, torquers)", "soft iron", "switch the loads at one attitude"
)


def kernel(term: Term, scene: Scene) -> Array:
    """E = c (i * h)(t), h a delay, a first-order response of tau_s, or a sum of several (`c12s_x`: of 12 s)."""
    return responses(term, scene)


FORMULA = "E = c (i * h)(t), c [nT/A] for each axis of B; h at once, a delay, or responses of first order"


def in_c(term: Term) -> CForm:
    """The same in C."""
    return responses_in_c(term, FORMULA, time_constants(term))


def candidates(run: Run) -> list[Term]:
    """Each current that moves: prompt, filtered, with several time constants, and delayed."""
    tau = replace(BEHIND, value=3.0, grid=TAU_S)
    return [
        term
        for c in moving(run, ("current",))
        for term in (
            instantaneous(c, kernel),
            first_order(c, kernel, tau),
            begun_elsewhere(first_order(c, kernel, tau), c),
            *begun_anew(first_order(c, kernel, tau), c, run),
            *multi_tau(c, kernel, run, SEVERAL_S),
            *delayed_terms(c, kernel, run),
        )
    ]


FAMILY = Family(
    "offset-current",
    "sensor",
    kernel,
    candidates,
    phrase="the offset changes with a current",
    shapes=(BEHIND, LATE, OFF, WITHIN),
    adds_up=True,
    related=("offset-current-squared",),
    time_constants=time_constants,
    experiment="hold the attitude and switch the load that draws this current on and off",
    responds={"load": 1.0},
    confounded=(LOCKED,),
    reach_s=reach_s,
    in_pieces=True,
    in_c=in_c,
)
