"""Scale factors that follow a channel which is no temperature: a supply, a current, a pressure; straight or curved."""

from __future__ import annotations

from labcal.model.effects.c_form import CForm
from labcal.model.effects.gains import followed_by_gains, gains, gains_in_c, whole_matrix
from labcal.model.effects.offset_channel import QUANTITIES
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import moving
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run


def kernel(term: Term, scene: Scene) -> Array:
    """E = Σ g_i s_i (q − q_ref) along sensor axis i; with nine parameters along every axis j.

    A curved one has Σ h_i s_i (q − q_ref)² beside it.
    """
    return followed_by_gains(term, scene)


def in_c(term: Term) -> CForm:
    """The same in C."""
    return gains_in_c(term)


def candidates(run: Run) -> list[Term]:
    """Each such channel that moves: gains alone, straight and curved, and the whole matrix."""
    channels = moving(run, (*QUANTITIES, "current"))
    return [t for c in channels for t in (gains(c, kernel), whole_matrix(c, kernel), gains(c, kernel, curved=True))]


FAMILY = Family(
    "gain-channel",
    "sensor",
    kernel,
    candidates,
    phrase="the gain changes with a recorded channel",
    of_field=True,
    generic=True,
    experiment="step the quantity that the channel measures in a large field and again in a small one",
    responds={"load": 1.0},
    in_pieces=True,
    in_c=in_c,
)
