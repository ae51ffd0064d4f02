"""A near reference sees the device's own magnetic moment, which turns with it."""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Family, Form, Scene, Shape
from labcal.model.effects.regressors import AXES
from labcal.record import Run, offers

MU0_OVER_4PI_nT = 100.0  # nT m³ / (A m²)
AT = ("at_x_m", "at_y_m", "at_z_m")


def kernel(form: Form, scene: Scene) -> Array:
    """E = −R B(Rᵀ m): what the reference reads too much, for a moment m [A m²] fixed in the body.

    B(m) = (μ0/4π)(3 r̂ (r̂·m) − m)/r³ at the reference's place (Jackson, 5.56).
    """
    assert scene.rig is not None
    place = np.array([form.at(name) for name in AT])
    distance = float(np.linalg.norm(place))
    along = place / distance
    dipole = MU0_OVER_4PI_nT * (3 * np.outer(along, along) - np.eye(3)) / distance**3
    turn = scene.rig.to_body
    return np.asarray(-np.einsum("nij,jk,nlk->nil", turn, dipole, turn))


def candidates(run: Run) -> list[Form]:
    """One moment, where the reference's place is stated."""
    near = run.reference.position_m
    turning = any(offers(run, s) == "vector" and s.kind == "rotation" for s in run.segments)
    if near is None or not turning or not 0.01 < float(np.linalg.norm(near)) < 3.0:
        return []
    place = tuple(Shape(name, float(x), "m") for name, x in zip(AT, near, strict=True))
    return [Form(kernel, tuple((f"m_{a}", "A m^2") for a in AXES), shape=place)]


FAMILY = Family(
    "dut-dipole-at-reference",
    "rig",
    kernel,
    candidates,
    shapes=AT,
    experiment="repeat with the reference at twice the distance",
)
