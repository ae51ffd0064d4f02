"""The objectives of a whole swarm against the paper's formulas written out for one particle."""

from dataclasses import replace

import numpy as np
import pytest
from riwanto import MODELS, TRUTH, simulate
from swarm_by_loop import rotation_axis_fitness

from labcal.fit.swarm.loci import loci_of
from labcal.fit.swarm.objectives import MagnitudeObjective, Planes, RotationAxisObjective
from labcal.fit.swarm.search import Options, axis_weight_nT, objective_of, repaired


def particles(seed, count=35):
    rng = np.random.default_rng(seed)
    anywhere = np.hstack([rng.uniform(-1, 1, (count, 9)), rng.uniform(-5000, 5000, (count, 3))])
    near = TRUTH * (1 + 0.01 * rng.normal(size=(count, 12)))
    return np.vstack([anywhere, near])


def parts(run):
    loci = loci_of(run)
    return [loci.reading[loci.rows(i)] for i in range(len(loci.axes))], loci.axes, loci.magnitude


@pytest.mark.parametrize("sign", ["two-samples", "sequence"])
@pytest.mark.parametrize("model", MODELS, ids=lambda m: f"model-{m.number}")
def test_values_equal_an_svd_for_each_particle(model, sign):
    loci, axes, magnitude = parts(simulate(model, seed=1, samples=300))
    swarm = RotationAxisObjective(MagnitudeObjective.of(np.vstack(loci), magnitude), Planes.of(loci, axes, sign))
    where = particles(model.number)
    by_loop = [rotation_axis_fitness(p, loci, axes, magnitude, sign) for p in where]
    assert swarm(where) == pytest.approx(np.array(by_loop), rel=1e-9, abs=0)


def test_many_samples_are_summed_in_blocks():
    loci, axes, magnitude = parts(simulate(MODELS[0], seed=1, samples=10_000))
    swarm = RotationAxisObjective(
        MagnitudeObjective.of(np.vstack(loci), magnitude), Planes.of(loci, axes, "two-samples")
    )
    where = particles(9)
    by_loop = [rotation_axis_fitness(p, loci, axes, magnitude, "two-samples") for p in where]
    assert swarm(where) == pytest.approx(np.array(by_loop), rel=1e-9, abs=0)


def test_the_objective_is_blind_to_the_sign_of_the_map_and_the_repair_flips_k_too():
    objective = objective_of(loci_of(simulate(MODELS[0], seed=2)), 2000.0, Options())
    assert objective(np.stack([TRUTH, -TRUTH])) == pytest.approx(objective(TRUTH[None])[0], rel=1e-12)
    assert repaired(-TRUTH) == pytest.approx(TRUTH)
    assert repaired(TRUTH) == pytest.approx(TRUTH)


def test_turning_backwards_counts_backwards():
    run = simulate(replace(MODELS[0], noise_nT=10.0), seed=3)
    loci = loci_of(run)
    rows = [loci.rows(i) for i in range(3)]
    forth_and_back = [np.concatenate([r, r[-2::-1]]) for r in rows]
    ways = [np.repeat([1.0, -1.0], len(r) - 1) for r in rows]
    with_ways = Planes.of([loci.reading[r] for r in forth_and_back], loci.axes, "sequence", ways)
    objective = RotationAxisObjective(MagnitudeObjective.of(loci.reading, loci.magnitude), with_ways)
    once = objective_of(loci, 10.0, Options(log_det=False))
    assert objective(TRUTH[None]) == pytest.approx(once(TRUTH[None]), rel=0.05)
    assert with_ways.turn == pytest.approx(2 * Planes.of([loci.reading[r] for r in rows], loci.axes).turn, rel=1e-2)


def test_two_samples_mislead_where_the_sequence_does_not():
    """A platform that turns three times: the sample a quarter on lies beyond half a turn, and the sense is reversed."""
    wrong = {"two-samples": 0, "sequence": 0}
    for seed in range(20):
        loci, axes, magnitude = parts(simulate(replace(MODELS[0], arc_deg=1080.0), seed=seed, samples=102))
        for sign in wrong:
            planes = Planes.of(loci, axes, sign)
            value = RotationAxisObjective(MagnitudeObjective.of(np.vstack(loci), magnitude), planes)(TRUTH[None])[0]
            wrong[sign] += value > 10_000
    assert wrong["sequence"] == 0
    assert wrong["two-samples"] == 20


def test_the_determinant_keeps_the_objective_from_a_map_that_gives_one_field_for_all_readings():
    """K → 0 with |k| = |b| fits a constant magnitude exactly: (8) prefers it to the truth."""
    loci = loci_of(simulate(MODELS[0], seed=0))
    trap = np.concatenate([1e-6 * TRUTH[:9], [35_000.0, 0.0, 0.0]])[None]
    bare = objective_of(loci, 2000.0, Options(log_det=False), axes=False)
    posed = objective_of(loci, 2000.0, Options(), axes=False)
    assert bare(trap)[0] < 0.01 * bare(TRUTH[None])[0]
    assert posed(trap)[0] > 5 * posed(TRUTH[None])[0]


def test_weight_from_the_noise_is_near_the_papers_by_hand():
    assert axis_weight_nT(2000.0, 100, 3, 35_000.0**2) == pytest.approx(4e4, rel=0.4)


def test_weight_from_the_noise_lets_the_objective_fall_with_the_likelihood():
    """A tilt and a stretch that cost the same log likelihood, ½ each, cost the same in (10)."""
    model = replace(MODELS[0], noise_nT=1.0)
    loci = loci_of(simulate(model, seed=0, samples=3000))
    n, sigma = 3000, 2000.0
    tilt = np.sqrt(2 * sigma**2 / n) / 35_000.0  # n r² θ² / 4 σ² = ½
    weight = axis_weight_nT(sigma, n, 3, 35_000.0**2)
    assert weight * np.sqrt(3 * (tilt**2 / 2) ** 2) / 3 == pytest.approx(sigma / np.sqrt(n) / (2 * n), rel=1e-9)
    turned = np.concatenate(
        [(rotation_about_111(tilt) @ TRUTH[:9].reshape(3, 3)).ravel(), rotation_about_111(tilt) @ TRUTH[9:]]
    )
    objective = objective_of(loci, sigma, Options(weights="noise", log_det=False, most_samples=n))
    assert objective.weight_axis_nT == pytest.approx(weight, rel=1e-6)
    each = tilt * np.sqrt(2 / 3)  # the tilt of every plane under a turn about (1, 1, 1)
    expected = weight * np.sqrt(3 * (each**2 / 2) ** 2) / 3
    assert objective(turned[None])[0] - objective(TRUTH[None])[0] == pytest.approx(expected, rel=0.1)


def rotation_about_111(angle):
    from labcal.geometry import rotation, unit

    return rotation(unit([1.0, 1.0, 1.0]), angle)
