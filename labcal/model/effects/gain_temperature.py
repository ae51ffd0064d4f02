"""Scale factors, and with them the cross terms, that follow temperature: at once or behind it, straight or curved."""

from __future__ import annotations

from dataclasses import replace

from labcal.model.effects.c_form import CForm
from labcal.model.effects.following import BEHIND, WITHIN, begun_anew
from labcal.model.effects.gains import followed_by_gains, gains, gains_in_c, whole_matrix
from labcal.model.effects.offset_temperature import RISES
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import moving
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run

TAU = replace(BEHIND, grid=(10.0, 30.0, 100.0, 300.0))


def kernel(term: Term, scene: Scene) -> Array:
    """E = Σ g_i s_i (T − T_ref) along sensor axis i; with nine parameters along every axis j; T behind by tau_s.

    A curved one has Σ h_i s_i (T − T_ref)² beside it.
    """
    return followed_by_gains(term, scene)


def in_c(term: Term) -> CForm:
    """The same in C."""
    return gains_in_c(term)


def candidates(run: Run) -> list[Term]:
    """Each temperature that moves: gains alone, at once and behind, straight and curved, and the whole matrix.

    What is behind may have begun anywhere in each segment.
    """
    return [
        term
        for c in moving(run, ("temperature",))
        for term in (
            gains(c, kernel),
            gains(c, kernel, TAU),
            *begun_anew(gains(c, kernel, TAU), c, run),
            whole_matrix(c, kernel),
            gains(c, kernel, curved=True),
            gains(c, kernel, TAU, curved=True),
        )
    ]


FAMILY = Family(
    "gain-temperature",
    "sensor",
    kernel,
    candidates,
    phrase="the gain changes with temperature",
    shapes=(BEHIND, WITHIN),
    of_field=True,
    experiment="warm the sensor in a large field and again in a small one",
    responds={"heat": 1.0},
    confounded=(RISES,),
    of_temperature=True,
    in_pieces=True,
    in_c=in_c,
)
