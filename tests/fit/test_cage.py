"""The cage's matrix with its uncertainty, held to account from both sides."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.fit.cage import fit_cage

MATRIX = np.array([[50_000.0, 200.0, -150.0], [300.0, 49_800.0, 90.0], [-120.0, 60.0, 50_100.0]])
OFFSET = np.array([20_400.0, 1_150.0, -43_700.0])
LADDER = np.vstack([np.outer(np.linspace(-1, 1, 7), axis) for axis in np.eye(3)])


def measured(seed: int, sigma_nT: float = 20.0) -> np.ndarray:
    noise = np.random.default_rng(seed).normal(0, sigma_nT, LADDER.shape)
    return LADDER @ MATRIX.T + OFFSET + noise


def test_without_noise_the_matrix_and_offset_are_exact() -> None:
    fit = fit_cage(LADDER, measured(0, 0.0))
    assert fit.matrix_nT_per_A == pytest.approx(MATRIX, rel=1e-9)
    assert fit.offset_nT == pytest.approx(OFFSET, rel=1e-9)


def test_the_stated_uncertainty_is_the_scatter_over_two_hundred_seeds() -> None:
    fits = [fit_cage(LADDER, measured(seed)) for seed in range(200)]
    scatter = np.std([f.matrix_nT_per_A for f in fits], axis=0, ddof=1)
    stated = np.sqrt(np.mean([f.u_matrix_nT_per_A**2 for f in fits], axis=0))
    assert scatter / stated == pytest.approx(np.ones((3, 3)), abs=0.2)
    offsets = np.std([f.offset_nT for f in fits], axis=0, ddof=1)
    assert offsets / np.sqrt(np.mean([f.u_offset_nT**2 for f in fits], axis=0)) == pytest.approx(np.ones(3), abs=0.2)
    z = np.array([(f.matrix_nT_per_A - MATRIX) / f.u_matrix_nT_per_A for f in fits])
    assert 0.9 < z.std() < 1.1


def test_the_uncertainty_of_a_field_is_the_scatter_of_its_prediction() -> None:
    currents = np.array([[0.3, -0.7, 0.9]])
    fits = [fit_cage(LADDER, measured(seed)) for seed in range(200)]
    scatter = np.std([f.field_nT(currents)[0] for f in fits], axis=0, ddof=1)
    stated = np.sqrt(np.mean([f.u_field_nT(currents)[0] ** 2 for f in fits], axis=0))
    assert scatter / stated == pytest.approx(np.ones(3), abs=0.2)


def test_currents_that_do_not_span_the_coils_are_refused() -> None:
    only_x = np.outer(np.linspace(-1, 1, 9), [1.0, 0.0, 0.0])
    with pytest.raises(ValueError, match="do not span all three coils"):
        fit_cage(only_x, np.zeros((9, 3)))
