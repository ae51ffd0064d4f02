"""Readings that remember where the field came from: the stop operator, and several of them (Prandtl-Ishlinskii).

Visintin 1994, ch. III: a stop of threshold r follows the field until it is r away from where it turned.
"""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Family, Form, Scene, Shape
from labcal.model.effects.regressors import AXES, per_axis, stretches
from labcal.record import Run

THRESHOLDS_nT = (500.0, 1500.0, 4000.0, 10000.0, 25000.0)
SEVERAL_nT = (1000.0, 5000.0, 20000.0)


def stop(drive: Array, threshold: float) -> Array:
    """The stop operator along rows (n, 3): within ± threshold, moving with the drive, starting at rest."""
    out, state = np.empty_like(drive), np.zeros(drive.shape[1])
    out[0] = state
    for row, step in enumerate(np.diff(drive, axis=0), start=1):
        state = np.minimum(np.maximum(state + step, -threshold), threshold)
        out[row] = state
    return out


def kernel(form: Form, scene: Scene) -> Array:
    """E = Σ c stop_r(s_i) along sensor axis i; each segment starts where its own loop would have left it."""
    s = scene.along_axes_nT
    thresholds = [form.at("r_nT")] if form.shape else [float(n[1:].split("_")[0]) for n, _ in form.parameters[::3]]
    return np.concatenate([_remembered(s, scene, r)[:, None, :] * scene.axes for r in thresholds], axis=2)


def _remembered(s: Array, scene: Scene, threshold: float) -> Array:
    out = np.empty_like(s)
    for rows in stretches(scene.segment):
        out[rows] = stop(s[rows], threshold)
    return out


def candidates(run: Run) -> list[Form]:
    """One threshold, searched for, and three fixed ones."""
    one = Form(kernel, per_axis("c", "1"), shape=(Shape("r_nT", THRESHOLDS_nT[1], "nT", THRESHOLDS_nT),))
    several = tuple((f"c{r:.0f}_{a}", "1") for r in SEVERAL_nT for a in AXES)
    return [one, Form(kernel, several)]


FAMILY = Family(
    "hysteresis",
    "sensor",
    kernel,
    candidates,
    shapes=("r_nT",),
    experiment="step the field up and down through the same values, or turn backwards",
    of_field=True,
)
