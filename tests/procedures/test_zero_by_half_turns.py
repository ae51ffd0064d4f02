"""A zero by half turns is as uncertain as is said, from both sides: noise, missed attitudes, a room that wanders."""

from __future__ import annotations

import numpy as np
import pytest

from procedures.reference_check import HALF_TURNS, u_of_zero

RUNS = 2000
FIELD_nT = np.array([20_400.0, 1_150.0, -43_700.0])
ATTITUDES = [np.eye(3), *HALF_TURNS.values(), np.eye(3)]


def turned_by(w: np.ndarray) -> np.ndarray:
    """1 + [w]x: of a turn by a tenth of a thousandth no more is needed."""
    return np.eye(3) + np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


@pytest.mark.parametrize(
    ("walk_nT", "noise_nT", "turn_rad"),
    [
        pytest.param(0.0, 1.0, 0.0, marks=pytest.mark.slow),
        pytest.param(1.0, 1.0, 0.0, marks=pytest.mark.slow),
        pytest.param(0.5, 0.05, 0.0, marks=pytest.mark.slow),
        (1.0, 1.0, 1e-4),
    ],
)
def test_ninety_five_of_a_hundred_zeros_are_within_what_is_said(
    walk_nT: float, noise_nT: float, turn_rad: float
) -> None:
    draw, held, z = np.random.default_rng(5), [], []
    for _ in range(RUNS):
        zero = 3.0 * draw.normal(size=3)
        moved = np.vstack([np.zeros(3), np.cumsum(walk_nT * draw.normal(size=(4, 3)), axis=0)])
        missed = turn_rad * draw.normal(size=(5, 3)) * np.array([0, 1, 1, 1, 0])[:, None]
        means = np.array([
            half @ turned_by(w) @ (FIELD_nT + by) + zero + noise_nT * draw.normal(size=3)
            for half, w, by in zip(ATTITUDES, missed, moved, strict=True)
        ])  # fmt: skip
        u = u_of_zero(means, np.full((5, 3), noise_nT), turn_rad)
        held.append(np.abs(means[:4].mean(axis=0) - zero) <= 2 * u)
        z.append((means[:4].mean(axis=0) - zero) / u)
    for axis, share in zip("xyz", np.mean(held, axis=0), strict=True):
        assert 0.93 < share < 0.985, axis
    assert np.all(np.sqrt(np.mean(np.square(z), axis=0)) > 0.8)
