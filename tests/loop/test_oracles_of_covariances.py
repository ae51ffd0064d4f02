"""Declared errors, priors and the noise of uncertainties against dense covariances, as hypothesis draws them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.fft import dct

from labcal.loop.noise.bands import bands_of, cosine_transform
from labcal.loop.noise.bounded import tried_spectra, weighted_spectra
from labcal.loop.noise.coloured import NullModel
from labcal.loop.noise.declared_directions import DeclaredDirections
from labcal.loop.noise.marginal import RATIOS, NullEliminated

Array = NDArray[np.float64]
few = settings(max_examples=5, deadline=None)
seeds, rows, components, sizes = st.integers(0, 2**32 - 1), st.integers(20, 30), st.integers(1, 2), st.integers(1, 3)


def drawn(seed: int, n: int, q: int, b: int, p: int) -> tuple[Array, Array, Array]:
    """Nuisance columns (n, q, b), columns (n, q, p), and y (n, q) that wanders and has a part of the columns in it."""
    rng = np.random.default_rng(seed)
    N, X = rng.normal(size=(n, q, b)), rng.normal(size=(n, q, p))
    y = np.cumsum(rng.normal(size=(n, q)), axis=0) + X @ rng.normal(0, 3, p)
    return N, X, np.asarray(y)


def flat(columns: Array) -> Array:
    return columns.reshape(columns.shape[0] * columns.shape[1], -1)


def in_time(spectrum: Array, q: int) -> Array:
    """The covariance (n q, n q) of noise with this spectrum (n,) in the cosine transform."""
    D = dct(np.eye(len(spectrum)), axis=0, norm="ortho")
    return np.kron(D.T @ np.diag(spectrum) @ D, np.eye(q))


def restricted(N: Array, y: Array, covariance: Array) -> tuple[float, float]:
    """Sum of squares that generalised least squares with N leaves, and log |Σ| + log |Nᵀ Σ⁻¹ N|."""
    inverse, A = np.linalg.inv(covariance), flat(N)
    information = A.T @ inverse @ A
    left = y.ravel() - A @ np.linalg.solve(information, A.T @ inverse @ y.ravel())
    return float(left @ inverse @ left), float(np.linalg.slogdet(covariance)[1] + np.linalg.slogdet(information)[1])


def each_prior(N: Array, X: Array, y: Array, spectra: Array, least: float) -> Iterator[float]:
    """The log-likelihood with coefficients of X drawn from N(0, g v), for each spectrum (tried, n) and each g."""
    for spectrum in spectra:
        noise = in_time(spectrum, y.shape[1])
        of_null = np.linalg.slogdet(flat(N).T @ np.linalg.inv(noise) @ flat(N))[1]
        for g in RATIOS:
            rss, logdets = restricted(N, y, noise + g * flat(X) @ flat(X).T)
            v = max(rss / y.size, least**2)
            yield -0.5 * (y.size * np.log(v) + rss / v + logdets - of_null)


@few
@given(seeds, rows, sizes)
def test_a_coefficient_that_is_integrated_over_its_prior_is_a_part_of_the_covariance(seed: int, n: int, p: int) -> None:
    N, X, y = drawn(seed, n, 1, 2, p)
    bands = bands_of(n)
    null = NullModel.of(cosine_transform(N), cosine_transform(y)[:, :, None], bands, 0.1)
    found = NullEliminated.of(null, cosine_transform(X), range(len(bands.spectra))).best()
    spectra = np.repeat(bands.spectra, np.diff(bands.edges), axis=1)
    assert found.log == pytest.approx(max(each_prior(N, X, y, spectra, 0.1)), rel=1e-9, abs=1e-9 * y.size)


@few
@given(seeds, rows, components, sizes)
def test_least_squares_beside_declared_errors_is_that_of_their_covariance(seed: int, n: int, q: int, e: int) -> None:
    N, X, y = drawn(seed, n, q, 2, e)
    D = X * 10.0 ** np.random.default_rng(seed).uniform(-2, 2, e)
    declared = DeclaredDirections.of(D)
    A, r = flat(declared.whitened(N)), declared.whitened(y[:, :, None]).ravel()
    x = np.linalg.lstsq(A, r, rcond=None)[0]
    covariance = np.eye(n * q) + flat(D) @ flat(D).T
    rss, _ = restricted(N, y, covariance)
    assert float(np.sum((r - A @ x) ** 2)) == pytest.approx(rss, rel=1e-9)
    likeliest = flat(D).T @ np.linalg.solve(covariance, y.ravel())
    np.testing.assert_allclose(declared.likeliest(y, np.inf), likeliest, rtol=1e-9, atol=1e-9)


@few
@given(seeds, rows, components, sizes)
def test_noise_is_weighted_by_the_dense_restricted_likelihood(seed: int, n: int, q: int, b: int) -> None:
    N, _, y = drawn(seed, n, q, b, 1)
    found = weighted_spectra(cosine_transform(N), cosine_transform(y))
    tried, width = tried_spectra(n), np.diff(bands_of(n).edges)
    free = y.size - b
    logs, levels = [], []
    for spectrum in np.repeat(tried, width, axis=1):
        rss, logdets = restricted(N, y, in_time(spectrum, q))
        logs.append(-0.5 * (free * np.log(rss / free) + logdets))
        levels.append(rss / free)
    assert found.dof == free
    np.testing.assert_allclose(found.spectra, np.array(levels)[:, None] * tried, rtol=1e-9)
    likely = found.weight[1:] > 1e-9 * found.weight[1:].max()  # beside white noise, whose odds are stated
    own = np.log(found.weight[1:][likely])
    dense = np.array(logs[1:])[likely]
    np.testing.assert_allclose(own - own.max(), dense - dense.max(), atol=1e-9 * y.size)
