"""Readings that are not proportional to the field along their own axis: powers two to five, and the odd square.

A saturating characteristic (tanh) shows as a negative third power, an uneven bridge as the second, a weak magnet in
Rayleigh's range as s |s|.
"""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Family, Form, Scene
from labcal.model.effects.regressors import BODY, driving, per_axis, powered
from labcal.record import Run

TERMS = (("c3",), ("c2",), ("c2", "c3"), ("c3", "c5"), ("c2", "c3", "c4", "c5"), ("o2",), ("o2", "c3"))


def kernel(form: Form, scene: Scene) -> Array:
    """E = Σ_k c_k s_i^k + o2 s_i |s_i| along sensor axis i, s the field along it (`body_…`: along the body's axis)."""
    s = driving(form, scene)
    terms = dict.fromkeys(name.removeprefix(BODY)[:2] for name, _ in form.parameters)
    powers = [s * np.abs(s) if term == "o2" else s ** int(term[1]) for term in terms]
    return np.concatenate([power[:, None, :] * scene.axes for power in powers], axis=2)


def candidates(run: Run) -> list[Form]:
    """The sums of powers worth trying."""
    return [
        Form(kernel, tuple(p for term in terms for p in per_axis(f"{drive}{term}", powered(int(term[1])))))
        for drive in ("", BODY)
        for terms in TERMS
    ]


FAMILY = Family(
    "nonlinearity",
    "sensor",
    kernel,
    candidates,
    experiment="step the field along each axis through its whole range",
    of_field=True,
)
