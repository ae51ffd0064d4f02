from dataclasses import replace

import numpy as np
import pytest

from labcal.fit.autocorrelation import variance_inflation
from labcal.fit.vector.ml import ml
from labcal.testing.made_up_runs import made_up_run


def test_white_residuals_are_not_widened() -> None:
    for seed in range(50):
        white = np.random.default_rng(seed).normal(size=(600, 3))
        assert variance_inflation(white, np.zeros(600, dtype=np.intp)) == 1.0


def test_correlated_residuals_widen_as_the_mean_does() -> None:
    rho, n = 0.8, 20_000
    noise = np.random.default_rng(0).normal(size=(n, 3))
    x = np.zeros((n, 3))
    for i in range(1, n):
        x[i] = rho * x[i - 1] + noise[i]
    assert variance_inflation(x, np.zeros(n, dtype=np.intp)) == pytest.approx((1 + rho) / (1 - rho), rel=0.1)
    assert variance_inflation(x, np.arange(n)) == 1.0


def test_declared_errors_that_leave_nearly_the_same_take_no_noise_for_theirs() -> None:
    run = made_up_run(fields_nT=[(38e3, 0.0, 32e3)], rows=150).run
    declared = replace(run, reference=replace(run.reference, noise_nT=3.0, u_offset_nT=3.0))
    alone, beside = (ml(one).sources for one in (run, declared))
    assert alone is not None
    assert beside is not None
    ratio = np.sqrt(np.diag(beside.noise.covariance) / np.diag(alone.noise.covariance))
    assert np.all((ratio > 0.9) & (ratio < 1.1)), ratio
