from __future__ import annotations

import numpy as np
import pytest

from labcal.geometry import rotation_vector
from labcal.model import AffineMap
from labcal.study.accuracy import direction_U_deg, directions, errors, sensitivities

TRUTH = AffineMap(np.array([[4.0, 0.1, 0.0], [-0.1, 4.1, 0.05], [0.0, 0.1, 3.9]]), np.array([1800.0, -2400.0, 900.0]))
FIELD = 50_000.0


def test_the_directions_are_those_of_a_cube() -> None:
    ways = directions()
    assert len(ways) == 26
    np.testing.assert_allclose(np.linalg.norm(ways, axis=1), 1.0)
    assert len(np.unique(np.round(ways, 9), axis=0)) == 26


def test_a_turn_and_a_gain_are_told_apart() -> None:
    turn = rotation_vector(np.radians(0.3) * np.array([0.0, 0.0, 1.0]))
    turned, longer = errors(AffineMap(turn @ TRUTH.K, turn @ TRUTH.k_nT), TRUTH, FIELD)
    assert turned == pytest.approx(0.3, rel=1e-6)
    assert longer == pytest.approx(0.0, abs=1e-6)
    turned, longer = errors(AffineMap(1.001 * TRUTH.K, 1.001 * TRUTH.k_nT), TRUTH, FIELD)
    assert turned == pytest.approx(0.0, abs=1e-6)
    assert longer == pytest.approx(50.0, rel=1e-6)


def test_an_offset_turns_the_field_by_its_part_across() -> None:
    moved = AffineMap(TRUTH.K, TRUTH.k_nT + np.array([100.0, 0.0, 0.0]))
    assert errors(moved, TRUTH, FIELD)[0] == pytest.approx(np.degrees(100 / FIELD), rel=1e-3)


def test_U_is_twice_the_scatter_of_the_direction_across_the_worst_way() -> None:
    draw = np.random.default_rng(3)
    root = draw.normal(size=(12, 12)) * np.r_[np.full(9, 2e-4), np.full(3, 8.0)][:, None]
    [U] = direction_U_deg(sensitivities(TRUTH, FIELD), (root @ root.T)[None])
    ways = directions()
    reading = np.linalg.solve(TRUTH.K, (FIELD * ways + TRUTH.k_nT).T).T
    shifts = draw.normal(size=(4_000, 12)) @ root.T
    moved = np.einsum("sij,nj->nsi", shifts[:, :9].reshape(-1, 3, 3), reading) - shifts[None, :, 9:]
    across = moved - np.einsum("nsi,ni->ns", moved, ways)[..., None] * ways[:, None]
    spread = np.einsum("nsi,nsj->nij", across, across) / len(shifts)
    worst = np.degrees(np.sqrt(np.linalg.eigvalsh(spread)[:, -1].max()) / FIELD)
    assert pytest.approx(2 * worst, rel=0.06) == U
