"""Readings that are not proportional to the field along their own axis: powers two to five.

A saturating characteristic (tanh) shows as a negative third power; an uneven bridge as the second.
"""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Family, Form, Scene
from labcal.model.effects.regressors import BODY, driving, per_axis, powered
from labcal.record import Run

ORDERS = ((3,), (2,), (2, 3), (3, 5), (2, 3, 4, 5))


def kernel(form: Form, scene: Scene) -> Array:
    """E = Σ_k c_k s_i^k along sensor axis i, s the field along it (`body_…`: along the body's axis)."""
    s = driving(form, scene)
    orders = dict.fromkeys(int(name.removeprefix(BODY)[1]) for name, _ in form.parameters)
    return np.concatenate([(s**k)[:, None, :] * scene.axes for k in orders], axis=2)


def candidates(run: Run) -> list[Form]:
    """The orders worth trying."""
    return [
        Form(kernel, tuple(p for k in orders for p in per_axis(f"{drive}c{k}", powered(k))))
        for drive in ("", BODY)
        for orders in ORDERS
    ]


FAMILY = Family(
    "nonlinearity",
    "sensor",
    kernel,
    candidates,
    experiment="step the field along each axis through its whole range",
    of_field=True,
)
