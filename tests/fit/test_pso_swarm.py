"""The swarm: its course, its limits, and that a seed repeats it."""

import numpy as np
import pytest

from labcal.fit.swarm.particle_swarm import SwarmSettings, coefficients, minimise, refine

LOW, HIGH = -np.array([1.0, 1.0, 5000.0]), np.array([1.0, 1.0, 5000.0])
MINIMUM = np.array([0.3, -0.7, 8000.0])  # its last component lies outside the starting range


def bowl(positions):
    return np.sum(((positions - MINIMUM) / HIGH) ** 2, axis=1)


def test_coefficients_start_fall_and_end_as_in_table_i():
    course = coefficients(SwarmSettings(iterations=100, w_period=0.1, c_period=0.2, cycles=2))
    assert course.shape == (100, 3)
    assert course[0] == pytest.approx([5.0, 4.0, 0.0])
    assert course[9] == pytest.approx([0.5, 4.0, 0.0])  # w has fallen, c1 and c2 have not yet moved
    assert course[29] == pytest.approx([0.5, 2.0, 2.0])
    assert course[30] == pytest.approx(course[0])  # the second cycle
    assert course[60] == pytest.approx([0.382, 2.5, 2.5])
    assert course[-1] == pytest.approx([0.382, 2.5, 2.5])


def test_a_minimum_outside_the_starting_range_is_found():
    best = minimise(bowl, LOW, HIGH, np.random.default_rng(0))
    assert best.value < 1e-4
    assert best.evaluations == 35 * 501


def test_a_seed_repeats_the_run_and_another_does_not():
    first, again, other = (minimise(bowl, LOW, HIGH, np.random.default_rng(seed)) for seed in (3, 3, 4))
    assert np.array_equal(first.position, again.position)
    assert not np.array_equal(first.position, other.position)


def test_no_particle_moves_faster_than_the_limit():
    seen = []

    def watched(positions):
        seen.append(positions.copy())
        return bowl(positions)

    minimise(watched, LOW, HIGH, np.random.default_rng(1), SwarmSettings(iterations=50))
    fastest = np.max(np.abs(np.diff(seen, axis=0)), axis=(0, 1))
    limit = (HIGH - LOW) / 50
    assert np.all(fastest <= limit * (1 + 1e-9))
    assert np.all(fastest > 0.99 * limit)  # the limit is what holds them


def test_refinement_begins_at_the_best_place_and_never_loses_it():
    rough = minimise(bowl, LOW, HIGH, np.random.default_rng(2), SwarmSettings(iterations=20))
    fine = refine(bowl, rough, HIGH / 20, np.random.default_rng(2))
    assert fine.value <= rough.value
    assert fine.value < 1e-6
    assert refine(bowl, rough, HIGH / 20, np.random.default_rng(2), SwarmSettings(iterations=0)).value <= rough.value


def test_a_place_without_a_number_is_never_the_best():
    def half_blind(positions):
        return np.where(positions[:, 0] < 0, np.nan, bowl(positions))

    best = minimise(half_blind, LOW, HIGH, np.random.default_rng(5))
    assert best.position[0] >= 0
    assert np.isfinite(best.value)
