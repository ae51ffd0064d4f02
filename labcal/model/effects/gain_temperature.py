"""Scale factors, and with them the cross terms, that follow temperature."""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Family, Form, Scene
from labcal.model.effects.regressors import AXES, middle, moving, per_axis
from labcal.record import Run


def kernel(form: Form, scene: Scene) -> Array:
    """E = Σ g_i s_i (T − T_ref) along sensor axis i; with nine parameters along every axis j."""
    s, warm = scene.along_axes_nT, form.drive(scene)[:, None]
    if len(form.parameters) == 3:
        return np.asarray((warm * s)[:, None, :] * scene.axes)
    return np.asarray(np.einsum("ji,nk->njik", scene.axes, warm * s).reshape(len(scene), 3, 9))


def candidates(run: Run) -> list[Form]:
    """Each temperature that moves: gains alone, and the whole matrix."""
    found = []
    for c in moving(run, ("temperature",)):
        unit = f"1/{c.unit}"
        whole = tuple((f"g_{i}{j}", unit) for i in AXES for j in AXES)
        found += [Form(kernel, p, (c.name,), {c.name: middle(c)}) for p in (per_axis("g", unit), whole)]
    return found


FAMILY = Family(
    "gain-temperature",
    "sensor",
    kernel,
    candidates,
    experiment="warm the sensor in a large field and again in a small one",
    of_field=True,
)
