"""An interference of one frequency on the readings, as the sampling shows it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.protocol import Array, Family, Scene, Term
from labcal.model.effects.regressors import AXES, on_each_axis
from labcal.model.effects.shape import FREQUENCY, Shape
from labcal.record import Run, period_s

LINE = Shape("f_Hz", 0.0, "Hz", kind=FREQUENCY)


def kernel(term: Term, scene: Scene) -> Array:
    """E = c cos(2π f t) + s sin(2π f t), each per body axis."""
    phase = 2 * np.pi * term.at(LINE.name) * scene.t_s
    return np.concatenate([on_each_axis(np.cos(phase)), on_each_axis(np.sin(phase))], axis=2)


def candidates(run: Run) -> list[Term]:
    """One frequency between a few cycles a segment and the Nyquist frequency; the loop finds where to look."""
    if len(run) < 20:
        return []
    nyquist = 0.5 / period_s(run.t_s)
    parameters = tuple((f"{w}_{a}", "nT") for w in ("cos", "sin") for a in AXES)
    return [Term(kernel, parameters, shape=(replace(LINE, value=nyquist / 2),))] if np.isfinite(nyquist) else []


FAMILY = Family(
    "periodic",
    "sensor",
    kernel,
    candidates,
    shapes=(LINE,),
    repeats=True,
    harmonics=True,
    experiment="record at rest, and again at another sampling rate: an alias moves",
    bound_to_run=True,
)
