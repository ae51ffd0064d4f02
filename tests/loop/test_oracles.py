"""The loop's linear algebra against the plain dense computation, on small problems that hypothesis draws."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.fft import dct

from labcal.loop.noise.autocorrelation import ljung_box, serially_correlated
from labcal.loop.noise.bands import bands_of, cosine_transform
from labcal.loop.noise.coloured import Grams, NullModel
from labcal.loop.noise.column_sets import ColumnSets
from labcal.loop.noise.nuisance import (
    Reduced,
    explained_squares,
    gram_pinv,
    inverse_gram,
    ols_with_nuisance,
    orthogonal_complement,
    orthonormal,
    principal_span,
    span_of_combinations,
)
from labcal.loop.noise.whitening import WhitenedNull

Array = NDArray[np.float64]
small = settings(max_examples=25, deadline=None)
seeds = st.integers(0, 2**32 - 1)
rows, components, nuisances, sizes = st.integers(24, 60), st.integers(1, 3), st.integers(1, 4), st.integers(1, 3)


def _drawn(seed: int, n: int, q: int, b: int, p: int) -> tuple[Array, Array, Array]:
    """Nuisance columns (n, q, b), columns (n, q, p) of unlike lengths, partly alike, and y (n, q)."""
    rng = np.random.default_rng(seed)
    N, own = rng.normal(size=(n, q, b)), rng.normal(size=(n, q, p))
    X = (own + N @ rng.normal(size=(b, p))) * 10.0 ** rng.uniform(-3, 3, p)
    return N, X, np.asarray(np.cumsum(rng.normal(size=(n, q)), axis=0))


def _flat(columns: Array) -> Array:
    return columns.reshape(columns.shape[0] * columns.shape[1], columns.shape[2])


def _dense(N: Array, X: Array, y: Array, spectrum: Array, least: float) -> tuple[float, float]:
    """Log-likelihood without its constant, and rss, by dense generalised least squares in time."""
    n, q = y.shape
    D = dct(np.eye(n), axis=0, norm="ortho")
    C = np.kron(D.T @ np.diag(spectrum) @ D, np.eye(q))
    A, inverse = np.hstack([_flat(N), _flat(X)]), np.linalg.inv(C)
    x = np.linalg.solve(A.T @ inverse @ A, A.T @ inverse @ y.ravel())
    left = y.ravel() - A @ x
    rss = float(left @ inverse @ left)
    variance = max(rss / y.size, least**2)
    _, logdet = np.linalg.slogdet(variance * C)
    return -0.5 * (logdet + rss / variance), rss


@small
@given(seeds, rows, components, nuisances, sizes)
def test_the_likelihood_is_the_dense_gaussian_one(seed: int, n: int, q: int, b: int, p: int) -> None:
    N, X, y = _drawn(seed, n, q, b, p)
    bands = bands_of(n)
    null_model = NullModel.of(cosine_transform(N), cosine_transform(y)[:, :, None], bands, 0.1)
    spectra = np.repeat(bands.spectra, np.diff(bands.edges), axis=1)
    for found, columns in (
        (null_model.null, X[:, :, :0]),
        (null_model.with_columns(cosine_transform(X))[0], X),
    ):
        each = [_dense(N, columns, y, spectrum, 0.1)[0] for spectrum in spectra]
        assert found.log == pytest.approx(max(each), rel=1e-9, abs=1e-9 * y.size)
        assert found.spectrum == int(np.argmax(each))
        assert found.rss == pytest.approx(_dense(N, columns, y, spectra[0], 0.1)[1], rel=1e-9)


@small
@given(seeds, rows, components)
def test_candidates_side_by_side_score_as_one_by_one(seed: int, n: int, q: int) -> None:
    N, X, y = _drawn(seed, n, q, 3, 6)
    X[:, :, 3] = N[:, :, 0]  # a column that is not new
    base, moved = orthonormal(cosine_transform(N)), cosine_transform(X).reshape(n, q, 3, 2)
    bands, transformed = bands_of(n), cosine_transform(y)[:, :, None]
    null_model = NullModel.of(base, transformed, bands, 0.1)
    right = np.concatenate([base, transformed], axis=2).reshape(n * q, -1)
    together = null_model.with_each(Grams.of(ColumnSets(moved.reshape(n, q, -1), 3), right, bands))
    assert [rank for _, rank in together] == [2, 1, 2]
    for place, (found, rank) in enumerate(together):
        alone, alone_rank = null_model.with_columns(moved[:, :, place])
        assert (found.spectrum, rank) == (alone.spectrum, alone_rank)
        assert found.log == pytest.approx(alone.log, rel=1e-9)


@small
@given(seeds, rows, components, nuisances, sizes)
def test_least_squares_beside_nuisance_is_least_squares(seed: int, n: int, q: int, b: int, p: int) -> None:
    N, X, y = _drawn(seed, n, q, b, p)
    A = np.concatenate([N, X], axis=2)
    expected = np.linalg.lstsq(_flat(A) / np.linalg.norm(_flat(A), axis=0), y.ravel(), rcond=None)[0]
    assert np.allclose(ols_with_nuisance(A, y, b, 1e-12) * np.linalg.norm(_flat(A), axis=0), expected, rtol=1e-7)
    length = np.linalg.norm(_flat(A), axis=0)
    inverse = inverse_gram(_flat(A).T @ _flat(A), b, 1e-12) * np.outer(length, length)
    gram = _flat(A).T @ _flat(A) / np.outer(length, length)
    assert np.allclose(inverse @ gram, np.eye(b + p), atol=1e-6)
    assert np.allclose(gram_pinv(_flat(X)), np.linalg.inv(_flat(X).T @ _flat(X)), rtol=1e-6)


def test_a_column_that_is_hardly_new_stays_at_zero() -> None:
    N, X, y = _drawn(5, 40, 2, 3, 2)
    X[:, :, 1] = N[:, :, 1] + 1e-3 * X[:, :, 0] / np.linalg.norm(X[:, :, 0]) * np.linalg.norm(N[:, :, 1])
    found = ols_with_nuisance(np.concatenate([N, X[:, :, 1:]], axis=2), y, 3)
    assert found[3] == 0.0
    assert np.allclose(found[:3], np.linalg.lstsq(_flat(N), y.ravel(), rcond=None)[0])
    assert Reduced.of(_flat(N).T @ _flat(N), 1).inverted.all()


@small
@given(seeds, rows, components, nuisances, sizes)
def test_what_columns_explain_is_the_fall_of_the_sum_of_squares(seed: int, n: int, q: int, b: int, p: int) -> None:
    N, X, y = _drawn(seed, n, q, b, p)

    def rss(*parts: Array) -> float:
        A = np.hstack([_flat(part) / np.linalg.norm(_flat(part), axis=0) for part in parts])
        return float(np.sum((y.ravel() - A @ np.linalg.lstsq(A, y.ravel(), rcond=None)[0]) ** 2))

    basis = _flat(orthonormal(N))
    new = orthogonal_complement(basis.reshape(n, q, b), X)
    both = np.hstack([basis, _flat(new)])
    assert np.allclose(both.T @ both, np.eye(both.shape[1]), atol=1e-6)
    if both.shape[1] < b + p:
        return  # a direction of X is nearly the nuisance's
    assert float(np.sum((y.ravel() @ _flat(new)) ** 2)) == pytest.approx(rss(N) - rss(N, X), rel=1e-6, abs=1e-9)
    left = _flat(X) - basis @ (basis.T @ _flat(X))
    length = np.linalg.norm(_flat(X), axis=0)
    schur, xty = left.T @ left / np.outer(length, length), (left.T @ y.ravel() / length)[:, None]
    assert explained_squares(schur, xty, 1e-14)[0][0] == pytest.approx(rss(N) - rss(N, X), rel=1e-6, abs=1e-9)


@small
@given(seeds, rows, components, nuisances, sizes)
def test_a_gain_under_one_spectrum_is_half_the_fall_of_its_weighted_squares(
    seed: int, n: int, q: int, b: int, p: int
) -> None:
    N, X, y = _drawn(seed, n, q, b, p)
    bands = bands_of(n)
    null_model = NullModel.of(cosine_transform(N), cosine_transform(y)[:, :, None], bands, 0.1)
    noise = WhitenedNull.of(null_model)
    if noise.gains(ColumnSets.alone(cosine_transform(X)), noise.residual)[1][0] < p:
        return  # a direction of X is nearly the nuisance's
    spectrum = np.repeat(bands.spectra[null_model.null.spectrum], np.diff(bands.edges))
    fall = _dense(N, X[:, :, :0], y, spectrum, 0.1)[1] - _dense(N, X, y, spectrum, 0.1)[1]
    assert noise.gain(cosine_transform(X)) == pytest.approx(0.5 * fall / null_model.null.level**2, rel=1e-6, abs=1e-9)


def test_a_few_columns_span_many_that_repeat() -> None:
    many = np.random.default_rng(0).normal(size=(50, 3, 4)) @ np.random.default_rng(1).normal(size=(4, 30))
    few = principal_span(many)
    assert few.shape == (50, 3, 4)
    left = _flat(many) - _flat(few) @ (_flat(few).T @ _flat(many))
    assert np.linalg.norm(left) < 1e-9 * np.linalg.norm(many)


def test_of_many_columns_a_few_that_are_as_long_as_they_are_common() -> None:
    draw = np.random.default_rng(2)
    made_of, mix, times = draw.normal(size=(40, 3, 6)), draw.normal(size=(6, 30)), draw.integers(1, 9, 30).astype(float)
    many = _flat(made_of @ mix)
    unit = many / np.linalg.norm(many, axis=0) * np.sqrt(times)
    for few in (
        principal_span(made_of @ mix, times, common=True),
        span_of_combinations(made_of, mix, times, common=True),
    ):
        assert few.shape == (40, 3, 6)
        assert _flat(few) @ _flat(few).T == pytest.approx(unit @ unit.T, abs=1e-9)


def test_ljung_box_is_the_textbook_sum() -> None:
    y = np.random.default_rng(3).normal(size=(80, 1))
    x = y[:, 0] - y.mean()
    rho: Any = [np.sum(x[k:] * x[:-k]) / np.sum(x**2) for k in range(1, 11)]
    assert ljung_box(y) == pytest.approx(sum(80 * 82 * r**2 / (80 - k) for k, r in enumerate(rho, start=1)))
    walk = np.cumsum(y, axis=0)
    assert serially_correlated(walk, np.zeros(80, dtype=np.intp))
    assert not serially_correlated(walk, np.arange(80, dtype=np.intp))  # no pair of rows is of one segment
