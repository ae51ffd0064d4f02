"""Sensor offset in proportion to the square of a current: heating by the load, or a rectified ripple."""

from __future__ import annotations

from labcal.model.effects.protocol import Array, Family, Form, Scene
from labcal.model.effects.regressors import moving, on_each_axis, per_axis
from labcal.record import Run


def kernel(form: Form, scene: Scene) -> Array:
    """E = c (i − i_ref)², with i_ref = 0: the square of the current itself."""
    return on_each_axis(form.drive(scene) ** 2)


def candidates(run: Run) -> list[Form]:
    """Each current that moves."""
    return [Form(kernel, per_axis("c", f"nT/{c.unit}^2"), (c.name,), {c.name: 0.0}) for c in moving(run, ("current",))]


FAMILY = Family(
    "offset-current-squared",
    "sensor",
    kernel,
    candidates,
    experiment="hold the attitude and draw three or more levels of this current",
    akin=("offset-current",),
)
