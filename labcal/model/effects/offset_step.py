"""Sensor offset that changes at one moment: a shock, a magnetised part, a load nobody recorded."""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Family, Form, Scene, Shape
from labcal.model.effects.regressors import on_each_axis, per_axis
from labcal.record import Run

TIMES = 60  # moments that the search tries
EDGE = 0.03  # of the rows at either end cannot show a step


def kernel(form: Form, scene: Scene) -> Array:
    """E = c from t_step on."""
    return on_each_axis((scene.t_s >= form.at("t_step_s")).astype(float))


def candidates(run: Run) -> list[Form]:
    """One step, anywhere but at the ends."""
    rows = np.unique(np.linspace(EDGE, 1 - EDGE, TIMES) * (len(run) - 1)).astype(int)
    grid = tuple(dict.fromkeys((run.t_s[rows] + run.t_s[rows + 1]).tolist())) if len(run) > 2 else ()
    times = tuple(t / 2 for t in grid)
    return [Form(kernel, per_axis("c", "nT"), shape=(Shape("t_step_s", times[0], "s", times),))] if times else []


FAMILY = Family(
    "offset-step",
    "sensor",
    kernel,
    candidates,
    shapes=("t_step_s",),
    experiment="repeat the segments before and after the step",
    bound_to_run=True,
    sought="moments",
)
