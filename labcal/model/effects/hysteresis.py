"""Readings that remember where the field came from: Dahl's and the stop operator, each segment starting at rest.

A stop of threshold r follows the field until it is r away from where it turned, several of them make a rounded loop
(Prandtl-Ishlinskii; Visintin, Differential Models of Hysteresis, 1994, ch. III). Dahl's loop (ASME J. Dyn. Syst. 98,
1976) approaches its branch exponentially over a field w.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from labcal.model.effects.protocol import Array, Family, Form, Scene, Shape
from labcal.model.effects.regressors import AXES, per_axis, stretches
from labcal.record import Run

THRESHOLDS_nT = (500.0, 1500.0, 4000.0, 10000.0, 25000.0)
SEVERAL_nT = (1000.0, 5000.0, 20000.0)


def stop(drive: Array, threshold: float) -> Array:
    """The stop operator along rows of drive (n, k) [nT]: within ± threshold, starting at rest."""
    state, out = np.zeros(drive.shape[1]), np.empty_like(drive)
    out[0] = state
    for row, step in enumerate(np.diff(drive, axis=0), start=1):
        state = np.minimum(np.maximum(state + step, -threshold), threshold)
        out[row] = state
    return out


def dahl(drive: Array, width: float) -> Array:
    """Dahl's loop along rows of drive (n, k), within ± 1: dz = (sign(dx) − z) |dx| / width, starting at rest."""
    steps = np.diff(drive, axis=0)
    keeps, toward = np.exp(-np.abs(steps) / width), np.sign(steps)
    state, out = np.zeros(drive.shape[1]), np.empty_like(drive)
    out[0] = state
    for row, (keep, sign) in enumerate(zip(keeps, toward, strict=True), start=1):
        state = sign + (state - sign) * keep
        out[row] = state
    return out


def kernel(form: Form, scene: Scene) -> Array:
    """The loops z(s_i) along each sensor axis: Dahl's where the form has a width, else stops of its thresholds.

    Against a vector reference s is the reference's: the reading's own noise would drive the loop, and in a field that
    stands still be taken off by it.
    """
    s = scene.along_axes_nT
    if scene.rig is not None:
        s = np.asarray(np.linalg.solve(scene.axes, scene.rig.prediction_nT.T).T)
    if any(shape.name == "w_nT" for shape in form.shape):
        loops = [_by_segment(scene, s, partial(dahl, width=form.at("w_nT")))]
    else:
        loops = [_by_segment(scene, s, partial(stop, threshold=r)) for r in _thresholds(form)]
    return np.concatenate([loop[:, None, :] * scene.axes for loop in loops], axis=2)


def _by_segment(scene: Scene, s: Array, loop: Callable[[Array], Array]) -> Array:
    return np.concatenate([loop(s[rows]) for rows in stretches(scene.segment)])


def _thresholds(form: Form) -> list[float]:
    if form.shape:
        return [form.at("r_nT")]
    return [float(name[1:].split("_")[0]) for name, _ in form.parameters[::3]]


def candidates(run: Run) -> list[Form]:
    """Dahl's loop, one stop, and three."""
    round_loop = Form(kernel, per_axis("c", "nT"), shape=(Shape("w_nT", THRESHOLDS_nT[1], "nT", THRESHOLDS_nT),))
    one = Form(kernel, per_axis("c", "1"), shape=(Shape("r_nT", THRESHOLDS_nT[1], "nT", THRESHOLDS_nT),))
    several = tuple((f"c{r:.0f}_{a}", "1") for r in SEVERAL_nT for a in AXES)
    return [round_loop, one, Form(kernel, several)]


FAMILY = Family(
    "hysteresis",
    "sensor",
    kernel,
    candidates,
    shapes=("r_nT", "w_nT"),
    experiment="step the field up and down through the same values, or turn backwards",
    of_field=True,
)
