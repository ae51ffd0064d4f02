"""Sensor offset that follows temperature, at once or behind it by a thermal time constant."""

from __future__ import annotations

from labcal.model.effects.protocol import Array, Family, Form, Scene, Shape
from labcal.model.effects.regressors import low_passed, middle, moving, on_each_axis, per_axis
from labcal.record import Run

TAU_S = (30.0, 100.0, 300.0)


def kernel(form: Form, scene: Scene) -> Array:
    """E = c (T − T_ref), T through a first-order response of time constant tau_s."""
    drive = form.drive(scene)
    return on_each_axis(low_passed(scene.t_s, scene.segment, drive, form.at("tau_s")) if form.shape else drive)


def candidates(run: Run) -> list[Form]:
    """Each temperature that moves, prompt and behind."""
    found = []
    for c in moving(run, ("temperature",)):
        prompt = Form(kernel, per_axis("c", f"nT/{c.unit}"), (c.name,), {c.name: middle(c)})
        behind = Form(
            kernel, prompt.parameters, prompt.channels, prompt.reference_value, (Shape("tau_s", 100.0, "s", TAU_S),)
        )
        found += [prompt, behind]
    return found


FAMILY = Family(
    "offset-temperature",
    "sensor",
    kernel,
    candidates,
    shapes=("tau_s",),
    experiment="hold the attitude and warm the sensor, then let it cool",
)
