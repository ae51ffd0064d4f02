"""A turn about another axis than asked is told from its first stretch; no disturbance of a right one looks like it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from labcal.bench.axis_up import CALM, EARLIEST_DEG, FARTHEST_EARLY_DEG, THIN, turned_about_early
from labcal.geometry import rotate

Array = NDArray[np.float64]
NOISE_nT, ACROSS_nT, TRIES, N = 15.0, 15_000.0, 300, 120
Z = np.array([0.0, 0.0, 1.0])
ARCS_DEG = (EARLIEST_DEG, 90.0, 150.0)


def arc(rng: np.random.Generator, up: Array, arc_deg: float, tilt_deg: float, soft_iron: float) -> Array:
    """Readings (n, 3) [nT] of a stretch of a turn about `up`, from any phase on, by a poor sensor in any field."""
    tilted = rotate(np.roll(up, 1), np.radians([tilt_deg]), up)[0]
    tilted = rotate(up, rng.uniform(0, 2 * np.pi, 1), tilted)[0]
    across = np.linalg.svd(tilted[None, :])[2][1]
    field = ACROSS_nT * (across + rng.uniform(-1.5, 1.5) * tilted)
    phase = rng.uniform(0, 2 * np.pi)
    seen = rotate(tilted, phase + np.radians(np.linspace(0, arc_deg, N)), field)
    sensitivities = np.eye(3) + soft_iron * rng.uniform(-1, 1, (3, 3))
    return np.asarray(seen @ sensitivities.T + rng.uniform(-3e4, 3e4, 3) + NOISE_nT * rng.standard_normal((N, 3)))


def alarmed(values: Array, wander_nT: float = 3.0) -> bool:
    found = turned_about_early(values, NOISE_nT, wander_nT)
    return found is not None and bool(abs(found @ Z) < np.cos(np.radians(FARTHEST_EARLY_DEG)))


def spike(rng: np.random.Generator) -> Array:
    return np.asarray(np.eye(N)[rng.integers(N)] * rng.uniform(-2e5, 2e5))


def step(rng: np.random.Generator) -> Array:
    return np.asarray(np.heaviside(np.arange(N) - rng.uniform(0, N), 1) * rng.uniform(-5e4, 5e4))


def pulse(rng: np.random.Generator) -> Array:
    begun, length = rng.uniform(0, N), rng.uniform(1, N)
    return np.asarray(((np.arange(N) - begun) % N < length) * rng.uniform(-5e3, 5e3))


def drift(rng: np.random.Generator) -> Array:
    return np.asarray(np.linspace(0, rng.uniform(-3e3, 3e3), N))


@pytest.mark.parametrize("arc_deg", ARCS_DEG)
@pytest.mark.parametrize("disturbed", [None, spike, step, pulse, drift])
def test_a_right_axis_alarms_nobody(disturbed: Callable[[np.random.Generator], Array] | None, arc_deg: float) -> None:
    """Tilted by 8°, sensitivities that differ by a fifth, any hard iron, and what comes along the axis meanwhile."""
    rng = np.random.default_rng(1)
    for _ in range(TRIES):
        values = arc(rng, Z, arc_deg, 8.0, 0.2)
        if disturbed is not None:
            values[:, rng.integers(3)] += disturbed(rng)
        assert not alarmed(values)


def test_of_a_field_that_is_little_more_than_noise_or_wanders_itself_nothing_is_said() -> None:
    rng = np.random.default_rng(2)
    for _ in range(TRIES):
        assert not alarmed(arc(rng, Z, EARLIEST_DEG, 8.0, 0.2) / 10)
        assert turned_about_early(arc(rng, Z, EARLIEST_DEG, 8.0, 0.0), NOISE_nT, ACROSS_nT * CALM) is None
        dead = arc(rng, Z, 180.0, 8.0, 0.0)
        dead[:, 0] = 7.0
        assert not alarmed(dead)


@pytest.mark.parametrize("arc_deg", ARCS_DEG)
@pytest.mark.parametrize("up", np.eye(3)[:2], ids=["x", "y"])
def test_another_axis_is_told_wherever_the_stretch_begins(up: Array, arc_deg: float) -> None:
    rng = np.random.default_rng(3)
    told = [alarmed(arc(rng, up, arc_deg, 8.0, 0.05)) for _ in range(TRIES)]
    assert np.mean(told) > 0.99


def test_an_arc_is_higher_than_an_alarm_has_it_thick() -> None:
    """Seen from above: its smaller scatter over its larger, with a fifth of soft iron to spare."""
    theta = np.radians(np.linspace(0, EARLIEST_DEG, 1000))
    small, large = np.sqrt(np.linalg.eigvalsh(np.cov(np.cos(theta), np.sin(theta))))
    assert 0.12 < small / large < 0.14
    assert small / large * (0.8 / 1.2) > THIN
