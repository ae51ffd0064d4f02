"""`ml` against the Cramér-Rao bound, and its intervals against the truth: short here, in full with the slow tests.

The runs are those of the bench in conftest.py: three axes, two magnitudes. Seeds count up from 0.
"""

from __future__ import annotations

import numpy as np
import pytest
from cramer_rao import cramer_rao

from labcal.fit.vector.ml import ml
from labcal.fit.vector.system import Noise

SYMMETRIC = np.array([[1.05, 0.02, -0.01], [0.02, 0.95, 0.03], [-0.01, 0.03, 1.02]])
INDEPENDENT = {9: [0, 1, 2, 4, 5, 8, 9, 10, 11], 12: list(range(12))}
KINDS = ["vector", "axis", "scalar"]


def campaign(bench, offers: str, seeds: int, **options) -> tuple[np.ndarray, np.ndarray]:
    """Squared error over bound, and whether the 95 % interval holds the truth: (seeds, 9 or 12) each."""
    ratios, holds = [], []
    for seed in range(seeds):
        run, true, b = bench(offers=offers, seed=seed, K=SYMMETRIC, **options)
        if seed == 0:  # the bound does not depend on the starting phases
            bound = np.diag(cramer_rao(run, true, b, Noise(25.0), phases(run, true, b)))
        found = ml(run)
        assert found.ok
        keep = INDEPENDENT[12 if found.frame_known else 9]
        error = (found.affine.parameters - true.parameters)[keep]
        ratios.append(error**2 / bound[keep])
        holds.append(np.abs(error) < 1.96 * np.sqrt(np.diag(found.covariance)[keep]))
    return np.array(ratios), np.array(holds)


def phases(run, true, b) -> np.ndarray:
    """The starting phases that lay the reference on the true field."""
    from dataclasses import replace

    clean = replace(run, reading=np.linalg.solve(true.K, (b + true.k_nT).T).T, dut=replace(run.dut, noise_nT=1.0))
    return ml(clean).phase_rad


@pytest.mark.parametrize("offers", ["axis", *(pytest.param(k, marks=pytest.mark.slow) for k in KINDS if k != "axis")])
def test_squared_error_is_at_the_bound_and_intervals_hold(bench, offers: str) -> None:
    seeds = 40
    ratios, holds = campaign(bench, offers, seeds, rows=60)
    spread = 4 * np.sqrt(2 / seeds / 4)  # four standard deviations; the parameters are a few independent groups
    assert 1 - spread < ratios.mean() < 1 + spread
    assert 0.95 - 0.06 < holds.mean() < 0.95 + 0.035


@pytest.mark.slow
@pytest.mark.parametrize("offers", KINDS)
def test_squared_error_is_within_five_percent_of_the_bound(bench, offers: str) -> None:
    ratios, holds = campaign(bench, offers, 500)
    print(offers, "error/bound", ratios.mean(), "coverage", holds.mean(), holds.mean(axis=0).round(3))
    assert 0.95 < ratios.mean() < 1.05
    assert 0.93 < holds.mean() < 0.97
    assert holds.mean(axis=0).min() > 0.916
    assert holds.mean(axis=0).max() < 0.978


@pytest.mark.slow
def test_magnitudes_of_noisy_readings_hardly_bias_the_answer(bench) -> None:
    """Noise makes a reading longer by σ²/|b|; uncorrected, at 2000 nT that is two uncertainties of the scale."""
    seeds, errors, squares = 60, {}, {}
    for noise in (25.0, 2000.0):
        run, true, b = bench(offers="scalar", K=SYMMETRIC, noise_nT=noise)
        keep = INDEPENDENT[9]
        size = np.sqrt(np.diag(cramer_rao(run, true, b, Noise(noise))))[keep]
        runs = [bench(offers="scalar", seed=seed, K=SYMMETRIC, noise_nT=noise)[0] for seed in range(seeds)]
        z = np.array([(ml(one).affine.parameters - true.parameters)[keep] / size for one in runs])
        errors[noise], squares[noise] = z.mean(axis=0), np.mean(z**2)
    uncorrected = 2000.0 * np.sqrt(len(b) * np.mean(1 / np.sum(b**2, axis=1)))
    print("shift", np.abs(errors[2000.0] - errors[25.0]).max(), "uncorrected", uncorrected, "error/bound", squares)
    assert uncorrected > 2
    assert np.abs(errors[2000.0] - errors[25.0]).max() < 0.3  # the same draws
    assert squares[2000.0] < squares[25.0] + 0.1
