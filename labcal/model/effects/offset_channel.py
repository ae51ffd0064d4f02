"""Sensor offset that follows a housekeeping channel of no special kind (voltage, power, pressure …)."""

from __future__ import annotations

from labcal.model.effects.c_form import CForm
from labcal.model.effects.c_responses import responses_in_c
from labcal.model.effects.following import LATE, delayed_terms, instantaneous, responses, time_constants
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import moving
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run

QUANTITIES = ("voltage", "power", "rate", "pressure", "humidity", "count", "other")


def kernel(term: Term, scene: Scene) -> Array:
    """E = c (q − q_ref), one c per body axis; q at once or after a delay."""
    return responses(term, scene)


FORMULA = "E = c (q - q_ref), one c [nT per unit] for each axis of B; q at once or after delay_s"


def in_c(term: Term) -> CForm:
    """The same in C."""
    return responses_in_c(term, FORMULA, time_constants(term))


def candidates(run: Run) -> list[Term]:
    """Each channel that moves: prompt, and delayed."""
    channels = moving(run, QUANTITIES)
    return [term for c in channels for term in (instantaneous(c, kernel), *delayed_terms(c, kernel, run))]


FAMILY = Family(
    "offset-channel",
    "sensor",
    kernel,
    candidates,
    phrase="the offset changes with a recorded channel",
    shapes=(LATE,),
    generic=True,
    experiment="hold the attitude and step the quantity that the channel measures",
    responds={"load": 1.0},
    in_pieces=True,
    in_c=in_c,
)
