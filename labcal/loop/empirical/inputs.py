"""What the smooth function of a run may depend on: one recorded thing, or two together; never time alone."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop.data.linear_problem import LinearProblem
from labcal.model.effects.inputs import ATTITUDE, CHANNEL, FIELD, RATE, value
from labcal.model.effects.regressors import AXES, moving
from labcal.record import Run

Array = NDArray[np.float64]
Inputs = tuple[str, ...]
QUANTITIES = ("temperature", "current", "voltage", "power", "rate", "pressure", "humidity", "count", "other")
MOST_CHANNELS = 8  # in pairs


def sets_of_inputs(problem: LinearProblem) -> list[Inputs]:
    """Every input alone, then pairs: of channels, of one with field or rate, of two components of the field."""
    channels = [CHANNEL + c.name for c in moving(problem.run, QUANTITIES)]
    field = [f"{FIELD}_{axis}" for axis in AXES]
    of_motion = [*field, FIELD, *(f"{ATTITUDE}_{axis}" for axis in AXES), RATE] if _shows_fields(problem) else []
    alone = [name for name in (*channels, *of_motion) if _moves(problem, name)]
    inside = [name for name in alone if name in (*field, RATE)]
    first = _in_pairs(problem, [name for name in alone if name in channels], inside)
    pairs = [*itertools.combinations(first, 2), *itertools.product(first, inside), *itertools.combinations(inside, 2)]
    return [*((name,) for name in alone), *pairs]


def middle_of(run: Run, names: Sequence[str]) -> dict[str, float]:
    """The median of each channel among the inputs."""
    channels = (name.removeprefix(CHANNEL) for name in names if name.startswith(CHANNEL))
    return {name: float(np.nanmedian(run.channel(name).values)) for name in channels}


def _in_pairs(problem: LinearProblem, channels: Sequence[str], inside: Sequence[str]) -> list[str]:
    """At most MOST_CHANNELS of the channels: those that, times another input, correlate most with the residual."""
    if len(channels) <= MOST_CHANNELS:
        return list(channels)
    whole = problem.whole or problem
    x = _standardised(np.column_stack([value(name, whole.scene) for name in (*channels, *inside)]))
    y = _standardised(whole.y)
    products = (_standardised(x[:, [i]] * np.delete(x, i, axis=1)) for i in range(len(channels)))
    shared = np.array([np.abs(product.T @ y).max() for product in products])
    likely = np.argsort(-shared)[:MOST_CHANNELS]
    return [channels[i] for i in sorted(likely.tolist())]


def _standardised(x: Array) -> Array:
    x = x - x.mean(axis=0)
    return np.asarray(x / np.maximum(np.sqrt(np.sum(x**2, axis=0)), 1e-300))


def _shows_fields(problem: LinearProblem) -> bool:
    """A function of the field needs a base that knows the gains, and vectors: magnitudes would show it their noise."""
    return problem.base == "affine" and problem.kind == "vector"


def _moves(problem: LinearProblem, name: str) -> bool:
    x = value(name, (problem.whole or problem).scene)
    return bool(np.isfinite(x).all() and np.ptp(x) > 1e-6 * float(np.max(np.abs(x))))
