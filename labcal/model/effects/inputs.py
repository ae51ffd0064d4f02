"""What a smooth function may depend on: a channel, the field in the body, its direction, the rate it turns at.

Never time alone. "channel:NAME", "field" [nT] and its components "field_x" …, "attitude_x" … (components of the field's
unit vector in B, which is all that readings tell of an attitude), "rate" [deg/s] (the field's turning in B).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from labcal.errors import InputError
from labcal.model.effects.regressors import AXES, slopes, stretches
from labcal.model.effects.scene import Array, Scene
from labcal.model.smooth import Domain

CHANNEL = "channel:"
FIELD, ATTITUDE, RATE = "field", "attitude", "rate"
WINDOW_S = 1.0  # either way, that the rate is a line's slope over
UNITS = {FIELD: "nT", ATTITUDE: "1", RATE: "deg/s"}


def value(name: str, scene: Scene) -> Array:
    """An input in each row (n,). Raises InputError for a name that is none."""
    if name.startswith(CHANNEL):
        return np.asarray(scene.channels[name.removeprefix(CHANNEL)], dtype=float)
    kind, _, axis = name.partition("_")
    field = scene.driving_field_nT
    if name == FIELD:
        return np.asarray(np.linalg.norm(field, axis=1))
    if name == RATE:
        return _rate(scene, _direction(field))
    if kind in (FIELD, ATTITUDE) and axis in AXES:
        return np.asarray((field if kind == FIELD else _direction(field))[:, AXES.index(axis)])
    raise InputError(f"an effect depends on {name!r}, which is no channel, field, attitude or rate")


def values(names: Sequence[str], scene: Scene) -> Array:
    """Inputs (n, k)."""
    return np.column_stack([value(name, scene) for name in names])


def outside(domains: Sequence[Domain], scene: Scene) -> np.ndarray:
    """Rows (n,) outside any of the domains."""
    out = np.zeros(len(scene), dtype=bool)
    for domain in domains:
        out |= domain.outside(values(domain.inputs, scene))
    return out


def channels_of(names: Sequence[str]) -> tuple[str, ...]:
    """Those of the inputs that are channels."""
    return tuple(name.removeprefix(CHANNEL) for name in names if name.startswith(CHANNEL))


def _direction(field: Array) -> Array:
    return np.asarray(field / np.maximum(np.linalg.norm(field, axis=1), 1e-9)[:, None])


def _rate(scene: Scene, direction: Array) -> Array:
    """How fast the direction (n, 3) turns [deg/s]."""
    turned = np.zeros((len(scene), 3))
    for rows in stretches(scene.segment) if len(scene) else []:
        for axis in range(3):
            turned[rows, axis] = slopes(scene.t_s[rows], direction[rows, axis], WINDOW_S)
    return np.asarray(np.degrees(np.linalg.norm(turned, axis=1)))
