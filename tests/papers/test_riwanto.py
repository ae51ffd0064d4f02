"""Table II of Riwanto et al. 2017; 50 seeds of every model in the slow set, a few seeds of two models here."""

from dataclasses import replace

import numpy as np
import pytest
import riwanto
from riwanto import (
    MODELS,
    TRUTH,
    bound,
    bound_of_planes,
    campaign,
    errors,
    magnitudes_of,
    on_planes,
    over_bound,
    rms,
    simulate,
    table_ii,
)

from labcal.fit import fit
from labcal.fit.swarm.particle_swarm import SwarmSettings
from labcal.fit.swarm.pso_axis import Options, pso_axis
from labcal.fit.vector.ml import estimate

MODEL_1, MODEL_5 = MODELS[0], MODELS[4]


def test_the_truth_is_the_papers_reference_column():
    assert table_ii(TRUTH)[:6] == pytest.approx([12600, -200, 1800, 0.749, 1.122, 2.433])
    assert np.linalg.norm(riwanto.OFFSET_NT) == pytest.approx(12_727, abs=3)


def test_the_noise_stands_inside_the_bracket():
    """Corrected by the truth, the residual of the field is white with the model's standard deviation."""
    run = simulate(MODEL_1, 0, samples=30_000)
    b = run.reading @ TRUTH[:9].reshape(3, 3).T - TRUTH[9:]
    noise = b - riwanto.true_field(MODEL_1, run.segment_index)
    assert np.cov(noise.T) == pytest.approx(2000.0**2 * np.eye(3), abs=0.03 * 2000.0**2)


def test_few_seeds_of_two_models():
    first, arcs = campaign(MODEL_1, range(4)), campaign(MODEL_5, range(4))
    assert np.max(np.abs(first.printed_in_sigma())) < 8  # of four seeds
    assert first.value.mean() == pytest.approx(194, abs=25)  # √88 · 2000 / 100 = 188 and a little for the planes
    assert errors(arcs.polished)[0] < 0.7 * errors(arcs.published)[0]
    assert errors(arcs.ml)[0] < 0.7 * errors(arcs.published)[0]
    assert over_bound(first.polished, MODEL_1) < 2
    assert over_bound(first.ml, MODEL_1) < 2
    assert first.ml_refused == arcs.ml_refused == 0


EACH = [MODELS[0], *(pytest.param(model, marks=pytest.mark.slow) for model in MODELS[1:])]


@pytest.mark.parametrize("model", EACH, ids=lambda m: f"model-{m.number}")
def test_the_kind_of_noise_matters_and_is_honestly_propagated(model):
    seeds = 12
    runs = [simulate(model, seed) for seed in range(seeds)]
    told, default = [estimate(run, white_in="field") for run in runs], [estimate(run) for run in runs]
    ratio = over_bound(np.array([one.affine.parameters for one in told]), model)
    assert ratio == pytest.approx(1, abs=4 * np.sqrt(2 / (seeds * 6)))  # as if half the parameters were independent
    assert ratio < over_bound(np.array([one.affine.parameters for one in default]), model)
    assert all(one.identified.why_not is None for one in told)


@pytest.mark.parametrize("model", EACH, ids=lambda m: f"model-{m.number}")
def test_with_a_scalar_reference_maximum_likelihood_knows_the_frame_and_is_at_the_bound(model):
    found = on_planes(model, range(10))
    assert found.refused == 0
    assert rms(found.over_bound) == pytest.approx(1, abs=4 / np.sqrt(2 * 6 * 10))  # half the parameters independent
    assert rms(found.over_u) == pytest.approx(1, abs=4 / np.sqrt(2 * 6 * 10))


def test_the_two_bounds_agree_on_the_gains_and_an_unknown_height_costs_offset():
    """Eliminated by hand or all numerical; on whole circles across the axis a height moves no gain."""
    known, unknown = bound(MODEL_1), bound_of_planes(MODEL_1)
    assert unknown[:9] == pytest.approx(known[:9], rel=0.02)
    assert np.all((unknown[9:] > 1.2 * known[9:]) & (unknown[9:] < 1.45 * known[9:]))  # below √2: half of what is known


@pytest.mark.parametrize("reference", [magnitudes_of, lambda run: run], ids=["scalar", "vector"])
def test_the_swarm_answers_at_the_noise_of_model_2_and_ends_at_the_likely_map(reference):
    """5500 nT a reading: a locus' points scatter, its plane and its sense of turning are known all the same."""
    for seed in range(2):
        run = reference(simulate(MODELS[1], seed))
        found = pso_axis(run, seed=seed, options=Options(SwarmSettings(iterations=100)))
        assert found.ok, found.why_not
        likely = fit(run, "ml", holdout=False, white_in="field")
        u = np.sqrt(np.diag(likely.covariance))
        assert np.max(np.abs(found.affine.parameters - likely.affine.parameters) / u) < 1


def test_the_swarm_refuses_an_axis_that_the_readings_contradict_at_that_noise():
    run = magnitudes_of(simulate(MODELS[1], 0))
    first, *others = run.segments
    backwards = replace(run, segments=(replace(first, axis_body=(-1.0, 0.0, 0.0)), *others))
    found = pso_axis(backwards, options=Options(SwarmSettings(iterations=100)))
    assert not found.ok
    assert "does not turn about its declared axis_body" in found.why_not


@pytest.mark.slow
@pytest.mark.parametrize("model", MODELS, ids=lambda m: f"model-{m.number}")
def test_table_ii(model):
    found = campaign(model, range(50))
    assert np.max(np.abs(found.printed_in_sigma())) < 3
    assert 0.8 < over_bound(found.polished, model) < 1.25  # fifty seeds
    assert 0.85 < over_bound(found.ml, model) < 1.15
    assert 0.8 < over_bound(found.ml_white_reading, model, "reading") < 1.2
    assert 0.92 < found.ml_holds.mean() < 0.98
    assert found.ml_refused == 0
    for closer in (found.ml, found.polished):
        assert errors(closer)[0] < 0.85 * errors(found.published)[0]
        assert errors(closer)[1] < 0.65 * errors(found.published)[1]
    if model is MODEL_5:
        assert errors(found.ml)[0] < 0.5 * errors(found.published)[0]
        assert errors(found.ml)[1] < 0.5 * errors(found.published)[1]


@pytest.mark.slow
@pytest.mark.parametrize("model", MODELS, ids=lambda m: f"model-{m.number}")
def test_maximum_likelihood_is_at_the_bound_and_its_intervals_hold_over_500_seeds(model):
    found = [estimate(simulate(model, seed), white_in="field") for seed in range(500)]
    error = np.array([one.affine.parameters for one in found]) - TRUTH
    assert np.mean((error / bound(model)) ** 2) == pytest.approx(1, abs=0.05)
    holds = np.abs(error) < 1.96 * np.sqrt([np.diag(one.covariance) for one in found])
    assert 0.93 < holds.mean() < 0.97
    assert holds.mean(axis=0).min() >= 0.916
    assert holds.mean(axis=0).max() <= 0.978


@pytest.mark.slow
@pytest.mark.parametrize("white_in", riwanto.WHITE_IN)
@pytest.mark.parametrize("model", MODELS, ids=lambda m: f"model-{m.number}")
def test_with_a_scalar_reference_error_over_bound_is_one_over_200_seeds(model, white_in):
    found = on_planes(model, range(200), white_in)
    assert found.refused <= 2
    assert rms(found.over_bound) == pytest.approx(1, abs=0.08)
    assert 0.93 < np.mean(np.abs(found.over_u) < 1.96) < 0.985  # model 5: u some 15 % larger than the scatter
