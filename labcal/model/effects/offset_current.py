"""Sensor offset in proportion to a housekeeping current, at once or through a first-order lag.

Springmann & Cutler 2011, (7): the bias varies as S i(t). Eddy currents and filters in the supply make it follow late.
"""

from __future__ import annotations

from labcal.model.effects.protocol import Array, Family, Form, Scene, Shape
from labcal.model.effects.regressors import low_passed, middle, moving, on_each_axis, per_axis
from labcal.record import Run

TAU_S = (1.0, 3.0, 10.0, 30.0)


def kernel(form: Form, scene: Scene) -> Array:
    """E = c (i * h)(t), h a first-order response of time constant tau_s."""
    drive = form.drive(scene)
    return on_each_axis(low_passed(scene.t_s, scene.segment, drive, form.at("tau_s")) if form.shape else drive)


def candidates(run: Run) -> list[Form]:
    """Each current that moves, prompt and filtered."""
    found = []
    for c in moving(run, ("current",)):
        prompt = Form(kernel, per_axis("c", f"nT/{c.unit}"), (c.name,), {c.name: middle(c)})
        late = Form(
            kernel,
            prompt.parameters,
            prompt.channels,
            prompt.reference_value,
            (Shape("tau_s", 3.0, "s", TAU_S),),
        )
        found += [prompt, late]
    return found


FAMILY = Family(
    "offset-current",
    "sensor",
    kernel,
    candidates,
    shapes=("tau_s",),
    experiment="hold the attitude and switch the load that draws this current on and off",
)
