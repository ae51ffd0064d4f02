"""Sensor offset that follows a housekeeping channel of no special kind (voltage, power, pressure …)."""

from __future__ import annotations

from labcal.model.effects.protocol import Array, Family, Form, Scene
from labcal.model.effects.regressors import middle, moving, on_each_axis, per_axis
from labcal.record import Run

QUANTITIES = ("voltage", "power", "rate", "pressure", "humidity", "count", "other")


def kernel(form: Form, scene: Scene) -> Array:
    """E = c (q − q_ref), one c per body axis."""
    return on_each_axis(form.drive(scene))


def candidates(run: Run) -> list[Form]:
    """One form for each channel that moves."""
    return [
        Form(kernel, per_axis("c", f"nT/{c.unit}"), (c.name,), {c.name: middle(c)}) for c in moving(run, QUANTITIES)
    ]


FAMILY = Family(
    "offset-channel",
    "sensor",
    kernel,
    candidates,
    experiment="hold the attitude and step the quantity that the channel measures",
)
