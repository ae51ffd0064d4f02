"""Sensor offset in proportion to the square of a current: heating by the load, or a rectified ripple."""

from __future__ import annotations

from dataclasses import replace

from labcal.model.effects.c_form import CForm
from labcal.model.effects.c_responses import Driven, filtered, late
from labcal.model.effects.following import BEHIND, LATE, delayed_terms
from labcal.model.effects.offset_current import LOCKED
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import delayed, is_its_own_square, low_passed, moving, on_each_axis, per_axis
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import DELAY
from labcal.model.effects.term import Term
from labcal.record import Run

TAU_S = (10.0, 30.0, 100.0)  # of what the load heats
DELAYS = 4  # either way: a second apart, and refined from there


def kernel(term: Term, scene: Scene) -> Array:
    """E = c ((i − i_ref)² * h)(t), h a first-order response of tau_s, or c (i(t − delay_s) − i_ref)²; i_ref = 0."""
    if (behind := term.of(DELAY)) is not None:
        return on_each_axis(delayed(scene.t_s, scene.segment, term.drive(scene), behind.value) ** 2)
    squared = term.drive(scene) ** 2
    tau_s = term.at(BEHIND.name) if term.shape else 0.0
    ends = term.ends_of_drive(scene)
    if ends is not None:
        largest = max(end**2 for end in ends)
        ends = (0.0 if ends[0] < 0 < ends[1] else min(end**2 for end in ends)), largest
    return on_each_axis(low_passed(scene.t_s, scene.segment, squared, tau_s, scene.past, ends))


def in_c(term: Term) -> CForm:
    """The same in C."""
    if (behind := term.of(DELAY)) is not None:
        body, inputs, state, helpers = late(Driven(term), behind.value)
        formula = "E = c (i(t - delay_s) - i_ref)^2, c [nT/A^2] for each axis of B"
        return CForm(formula, f"{body}\non_each_axis(e, late * late);", inputs, state, (*helpers, "on_each_axis"))
    lines, inputs, state, helpers = filtered(Driven(term, squared=True))
    formula = (
        "E = c ((i - i_ref)^2 * h)(t), c [nT/A^2] for each axis of B, h a response of first order of tau_s, if any"
    )
    return CForm(formula, f"{lines}\non_each_axis(e, followed);", inputs, state, (*helpers, "on_each_axis"))


def candidates(run: Run) -> list[Term]:
    """Each current that moves: at once, as the heat of it comes and goes, and seen early or late.

    The last not of a load that is on or off: it has no square of its own.
    """
    return [
        Term(kernel, per_axis("c", f"nT/{c.unit}^2"), (c.name,), {c.name: 0.0}, shape)
        for c in moving(run, ("current",))
        for shape in (
            (),
            (replace(BEHIND, value=30.0, grid=TAU_S),),
            *(term.shape for term in delayed_terms(c, kernel, run, DELAYS) if not is_its_own_square(c)),
        )
    ]


FAMILY = Family(
    "offset-current-squared",
    "sensor",
    kernel,
    candidates,
    phrase="the offset changes with the square of a current",
    shapes=(BEHIND, LATE),
    second_order=True,
    related=("offset-current",),
    experiment="hold the attitude and draw three or more levels of this current",
    responds={"load": 1.0, "heat": 1.0},
    confounded=(LOCKED,),
    in_pieces=True,
    in_c=in_c,
)
