"""Readings that are not proportional to the field along their own axis: powers two to five.

A saturating characteristic (tanh) shows as a negative third power; an uneven bridge as the second.
"""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Family, Form, Scene
from labcal.model.effects.regressors import AXES
from labcal.record import Run

ORDERS = ((3,), (2,), (2, 3), (3, 5), (2, 3, 4, 5))


def kernel(form: Form, scene: Scene) -> Array:
    """E = Σ_k c_k s_i^k along sensor axis i, s the field along it."""
    s = scene.along_axes_nT
    orders = dict.fromkeys(int(name[1]) for name, _ in form.parameters)
    return np.concatenate([(s**k)[:, None, :] * scene.axes for k in orders], axis=2)


def candidates(run: Run) -> list[Form]:
    """The orders worth trying."""
    return [
        Form(kernel, tuple((f"c{k}_{a}", "1/nT" if k == 2 else f"1/nT^{k - 1}") for k in orders for a in AXES))
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
