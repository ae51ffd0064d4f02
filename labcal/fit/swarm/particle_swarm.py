"""Particle swarm optimisation: every particle knows the best place of all, and the pull of it comes in cycles.

Riwanto et al. 2017, sections III-A and III-B; the defaults are the values of their Table I.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Objective = Callable[[Array], Array]  # positions (particles, dimensions) -> values (particles,)


@dataclass(frozen=True, slots=True)
class SwarmSettings:
    """Table I. Each coefficient goes from its start to its final value in every cycle, and ends at its end value.

    `w_period` and `c_period` are fractions of `iterations`; `cycles` of both are run, the rest is spent at the end
    values. `speed_limit` is v_lim of (6).
    """

    iterations: int = 500
    particles: int = 35
    w: tuple[float, float, float] = (5.0, 0.5, 0.382)  # start, final, end
    c1: tuple[float, float, float] = (4.0, 2.0, 2.5)
    c2: tuple[float, float, float] = (0.0, 2.0, 2.5)
    w_period: float = 0.1
    c_period: float = 0.1
    cycles: int = 4
    speed_limit: float = 50.0


@dataclass(frozen=True, slots=True, eq=False)
class Best:
    """The best position (dimensions,) that any particle visited, and its value."""

    position: Array
    value: float
    evaluations: int


def coefficients(settings: SwarmSettings) -> Array:
    """Inertia, cognitive and social rate (iterations, 3) along the run (Fig. 2): first w falls, then c1 and c2 meet."""
    n_w, n_c = (max(1, round(f * settings.iterations)) for f in (settings.w_period, settings.c_period))
    fall, meet = np.linspace(0, 1, n_w), np.linspace(0, 1, n_c)
    course = (np.concatenate([fall, np.ones(n_c)]), *2 * (np.concatenate([np.zeros(n_w), meet]),))
    ranges = (settings.w, settings.c1, settings.c2)
    cycle = np.stack([start + (final - start) * x for x, (start, final, _) in zip(course, ranges, strict=True)], axis=1)
    out = np.tile([end for *_, end in ranges], (settings.iterations, 1))
    varied = np.tile(cycle, (settings.cycles, 1))[: settings.iterations]
    out[: len(varied)] = varied
    return np.asarray(out, dtype=float)


def minimise(
    objective: Objective,
    low: ArrayLike,
    high: ArrayLike,
    rng: np.random.Generator,
    settings: SwarmSettings | None = None,
    start: Array | None = None,
) -> Best:
    """Search from positions drawn between `low` and `high` (dimensions,); the swarm may leave that range.

    Equations (3) to (6) and Algorithm 1. One particle begins at `start` where it is given. A position whose value is
    not a number is never a best one.
    """
    settings = settings or SwarmSettings()
    low, high = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
    shape = (settings.particles, len(low))
    fastest = (high - low) / settings.speed_limit  # (6)
    position = low + rng.random(shape) * (high - low)  # (5a)
    velocity = (2 * rng.random(shape) - 1) * fastest  # (5b)
    if start is not None:
        position[rng.integers(settings.particles)] = start
    own, own_value = position.copy(), np.nan_to_num(objective(position), nan=np.inf)
    leader = int(np.argmin(own_value))
    for w, c1, c2 in coefficients(settings):
        draws = rng.random((2, *shape))
        velocity *= w
        velocity += c1 * draws[0] * (own - position) + c2 * draws[1] * (own[leader] - position)  # (3a)
        np.minimum(np.maximum(velocity, -fastest, out=velocity), fastest, out=velocity)  # Algorithm 1
        position += velocity  # (3b)
        value = objective(position)
        better = value < own_value  # (4a)
        own[better], own_value[better] = position[better], value[better]
        leader = int(np.argmin(own_value))  # (4b)
    return Best(own[leader].copy(), float(own_value[leader]), settings.particles * (settings.iterations + 1))


def refine(
    objective: Objective,
    best: Best,
    reach: ArrayLike,
    rng: np.random.Generator,
    settings: SwarmSettings | None = None,
) -> Best:
    """Shake the swarm: search again within `reach` (dimensions,) of `best`, which one particle keeps (Algorithm 2)."""
    reach = np.asarray(reach, dtype=float)
    again = minimise(objective, best.position - reach, best.position + reach, rng, settings, start=best.position)
    return Best(again.position, again.value, best.evaluations + again.evaluations)
