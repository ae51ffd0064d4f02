"""The cage's matrix with its uncertainty, held to account from both sides."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.fit.cage import CageFit, fit_cage

MATRIX = np.array([[50_000.0, 200.0, -150.0], [300.0, 49_800.0, 90.0], [-120.0, 60.0, 50_100.0]])
OFFSET = np.array([20_400.0, 1_150.0, -43_700.0])
DRIFT = np.array([0.2, -0.1, 0.3])
STEPS = [0.5, 1.0, 0.5, 0.0, 0.5, 1.0, -0.5, -1.0, -0.5, 0.0, -0.5, -1.0]
LADDER = np.vstack([np.outer(STEPS, axis) for axis in np.eye(3)])
COIL = np.repeat([0, 1, 2], len(STEPS))
TIME = 3.0 * np.arange(len(LADDER))


def found(seed: int, sigma_nT: float = 4.0, sigma_A: float = 3e-4) -> CageFit:
    """A sweep with noise of the field and, larger, of the current that is read."""
    rng = np.random.default_rng(seed)
    read = LADDER + rng.normal(0, sigma_A, LADDER.shape) * (np.arange(3) == COIL[:, None])
    drift = np.outer(TIME - TIME.mean(), DRIFT)
    fields = LADDER @ MATRIX.T + OFFSET + drift + rng.normal(0, sigma_nT, LADDER.shape)
    return fit_cage(read, fields, COIL, TIME)


def test_without_noise_matrix_offset_and_drift_are_exact() -> None:
    fit = found(0, 0.0, 0.0)
    assert fit.matrix_nT_per_A == pytest.approx(MATRIX, rel=1e-9)
    assert fit.offset_nT == pytest.approx(OFFSET, rel=1e-9)
    assert fit.drift_nT_per_s == pytest.approx(DRIFT, rel=1e-6)


def test_the_stated_covariance_is_the_scatter_over_five_hundred_seeds() -> None:
    fits = [found(seed) for seed in range(500)]
    values = np.array([[*f.matrix_nT_per_A.ravel(), *f.offset_nT] for f in fits])
    stated = np.mean([f.covariance for f in fits], axis=0)
    size = np.sqrt(np.diag(stated))
    assert values.std(axis=0, ddof=1) / size == pytest.approx(np.ones(12), abs=0.15)
    assert np.corrcoef(values.T) == pytest.approx(stated / np.outer(size, size), abs=0.2)
    z = (values - [*MATRIX.ravel(), *OFFSET]) / size
    assert np.abs(z.mean(axis=0)).max() < 4 / np.sqrt(500)


@pytest.mark.parametrize("rows", [COIL < 2, np.arange(36) < 28])
def test_a_coil_that_was_not_stepped_enough_is_refused(rows: np.ndarray) -> None:
    with pytest.raises(ValueError, match="do not span all three coils"):
        fit_cage(LADDER[rows], np.zeros((rows.sum(), 3)), COIL[rows], TIME[rows])
