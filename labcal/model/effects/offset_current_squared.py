"""Sensor offset in proportion to the square of a current: heating by the load, or a rectified ripple."""

from __future__ import annotations

from labcal.model.effects.protocol import Array, Family, Scene, Shape, Term
from labcal.model.effects.regressors import low_passed, moving, on_each_axis, per_axis
from labcal.record import Run

TAU_S = (10.0, 30.0, 100.0)  # of what the load heats


def kernel(term: Term, scene: Scene) -> Array:
    """E = c ((i − i_ref)² * h)(t), with i_ref = 0, h a first-order response of tau_s."""
    squared = term.drive(scene) ** 2
    tau_s = term.at("tau_s") if term.shape else 0.0
    return on_each_axis(low_passed(scene.t_s, scene.segment, squared, tau_s, scene.past))


def candidates(run: Run) -> list[Term]:
    """Each current that moves: at once, and as the heat of it comes and goes."""
    return [
        Term(kernel, per_axis("c", f"nT/{c.unit}^2"), (c.name,), {c.name: 0.0}, shape)
        for c in moving(run, ("current",))
        for shape in ((), (Shape("tau_s", 30.0, "s", TAU_S),))
    ]


FAMILY = Family(
    "offset-current-squared",
    "sensor",
    kernel,
    candidates,
    shapes=("tau_s",),
    experiment="hold the attitude and draw three or more levels of this current",
    related=("offset-current",),
    second_order=True,
    in_pieces=True,
)
