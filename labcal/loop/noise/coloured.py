"""Gaussian likelihood of a residual with coloured noise, any columns fitted: generalised least squares by bands.

The noise is white plus a slow process with spectrum 1 + r / (λ + c), λ = 2 − 2 cos(π k / n). The cosine transform
along the rows makes it uncorrelated: exactly so for white noise and for a random walk (c = 0), nearly so for an
exponentially correlated process (the DCT-II holds the eigenvectors of a path's Laplacian; Strang, SIAM Review 41, 135,
1999). Generalised least squares is then a weighted sum of Gram matrices over bands of frequency, and the noise's own
parameters r and c cost no refit. An effect has to beat this process, not white noise: what any slow wandering would
explain as well is no evidence. Equal to the dense computation: `tests/loop/test_oracles.py`.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.noise.bands import Bands, bands_of, cosine_transform
from labcal.loop.noise.column_sets import ColumnSets
from labcal.loop.noise.nuisance import MIN_NEW_SHARE
from labcal.loop.parallel import parallel_map

Array = NDArray[np.float64]
RIDGE = 1e-12  # of the trace, on the diagonal: columns that accepted effects have in common stay factorable
PARALLEL_FROM = 500_000  # numbers in columns whose Gram matrices are worth two cores


def noise_spectrum(transformed: Array, y: Array) -> tuple[Bands, Array]:
    """The bands and the noise's variance in each, with transformed columns (n, q, b) fitted to y (n, q)."""
    bands = bands_of(len(y))
    null = NullModel.of(transformed, cosine_transform(y)[:, :, None], bands, 0.0).null
    return bands, null.level**2 * bands.spectra[null.spectrum]


def weighted_gram(transformed: Array, bands: Bands, weight: Array) -> Array:
    """Σ_k weight_k G_k (b, b) over the bands, for transformed columns (n, q, b)."""
    return np.asarray(np.tensordot(weight, grams_of_bands(transformed, bands), axes=1))


@dataclass(frozen=True, slots=True, eq=False)
class Likelihood:
    """The noise process of largest likelihood for one set of columns."""

    log: float  # log-likelihood, without its constant
    level: float  # standard deviation of the white part, in whitened units
    spectrum: int  # its number among those of the bands
    rss: float  # residual sum of squares of ordinary least squares


@dataclass(frozen=True, slots=True, eq=False)
class NullModel:
    """The model without a candidate: its transformed columns and y, factored once under every spectrum tried.

    The white level of the noise is kept at `min_noise_level` or above.
    """

    columns: Array  # (n, q, b)
    y: Array  # (n, q, 1)
    columns_and_y: Array  # (n q, b + 1)
    bands: Bands
    min_noise_level: float
    cholesky: Array  # (tried, b, b) lower L of the weighted Gram matrices L Lᵀ, columns at unit length
    projected_y: Array  # (tried, b) L⁻¹ times their products with y
    rss: Array  # (tried,)
    null: Likelihood

    @classmethod
    def of(cls, columns: Array, y: Array, bands: Bands, min_noise_level: float) -> NullModel:
        """Factor the Gram matrices of `columns` (n, q, b), whatever their lengths."""
        both = np.concatenate([columns, y], axis=2)
        columns = both[:, :, :-1]
        columns /= np.maximum(np.sqrt(np.einsum("nqb,nqb->b", columns, columns)), 1e-300)
        total = np.tensordot(1.0 / bands.spectra, grams_of_bands(both, bands), axes=1)
        A, b, yy = total[:, :-1, :-1], total[:, :-1, -1:], total[:, -1, -1]
        diagonal = np.einsum("tii->ti", A)
        diagonal += RIDGE * diagonal.sum(axis=1, keepdims=True)
        lower = np.asarray(np.linalg.cholesky(A), dtype=np.float64)
        projected = _forward_substituted(lower, b)[:, 0]
        rss = np.maximum(yy - np.sum(projected**2, axis=1), 1e-300)
        null = _best_spectra(rss[:, None], y.size, y.shape[1], bands, min_noise_level)[0]
        return cls(columns, y, both.reshape(-1, both.shape[2]), bands, min_noise_level, lower, projected, rss, null)

    def with_columns(self, X: Array) -> tuple[Likelihood, int]:
        """The likelihood with the transformed columns X (n, q, p) as well, and the rank that they add."""
        return self.with_each(Grams.of(ColumnSets.alone(X), self.columns_and_y, self.bands))[0]

    def with_each(self, grams: Grams) -> list[tuple[Likelihood, int]]:
        """The same for each of some sets of columns on its own, by their Gram matrices with the columns here and y.

        Which directions are new is decided under white noise, so that every spectrum is compared with equal rank.
        """
        gram, (tried, c, p, _) = grams.own, grams.own.shape
        cross, xty = grams.cross[:, :-1], grams.cross[:, -1].reshape(tried, c, p)
        projected = _forward_substituted(self.cholesky, cross).reshape(tried, c, p, -1)
        schur = gram - projected @ np.swapaxes(projected, 2, 3)
        xty = xty - (projected @ self.projected_y[:, None, :, None])[..., 0]
        values, vectors = np.linalg.eigh(schur[0])
        new = values > MIN_NEW_SHARE * np.trace(gram[0], axis1=1, axis2=2)[:, None] / p
        if not new.all():
            schur, xty = np.swapaxes(vectors, 1, 2) @ schur @ vectors, (xty[:, :, None, :] @ vectors)[:, :, 0]
        rss = np.maximum(self.rss[:, None] - _explained_within(schur, xty, new), 1e-300)
        found = _best_spectra(rss, self.y.size, self.y.shape[1], self.bands, self.min_noise_level)
        return list(zip(found, new.sum(axis=1).tolist(), strict=True))


@dataclass(frozen=True, slots=True, eq=False)
class Grams:
    """Of c sets of p transformed columns, under each spectrum: with themselves, and with other columns."""

    own: Array  # (tried, c, p, p) the sets' columns at unit length
    cross: Array  # (tried, others, c p)
    length: Array  # (c p,) of the columns

    @classmethod
    def of(cls, sets: ColumnSets, right: Array, bands: Bands) -> Grams:
        """For transformed sets and other columns `right` (n q, others)."""
        own, cross = grams_by_band(sets, right, bands)
        length, weight = np.sqrt(np.maximum(np.einsum("kcpp->cp", own), 1e-300)), 1.0 / bands.spectra
        own = np.tensordot(weight, own, axes=1) / (length[:, :, None] * length[:, None, :])
        return cls(own, np.tensordot(weight, cross, axes=1) / length.ravel(), length.ravel())

    def with_columns(self, sets: ColumnSets, more: Array, bands: Bands) -> Grams:
        """These with other columns (n q, more) put before the last of those there are."""
        new = np.tensordot(1.0 / bands.spectra, _cross_grams(sets, more, bands), axes=1) / self.length
        return replace(self, cross=np.concatenate([self.cross[:, :-1], new, self.cross[:, -1:]], axis=1))


def grams_by_band(sets: ColumnSets, right: Array, bands: Bands) -> tuple[Array, Array]:
    """Gram matrices of transformed sets (bands, c, p, p), and with other columns `right` (n q, others)."""
    flat, edges = _by_band(sets, bands)
    own = np.stack([sets.squares(flat[a:b]) for a, b in itertools.pairwise(edges)])
    return own, _cross_grams(sets, right, bands)


def _by_band(sets: ColumnSets, bands: Bands) -> tuple[Array, list[int]]:
    """What the sets are made of (n q, m), and where each band begins in it."""
    n, q, m = sets.made_of.shape
    return sets.made_of.reshape(n * q, m), (bands.edges * q).tolist()


def _cross_grams(sets: ColumnSets, right: Array, bands: Bands) -> Array:
    """Gram matrices (bands, others, c p)."""
    flat, edges = _by_band(sets, bands)
    out = np.empty((len(edges) - 1, right.shape[1], flat.shape[1]))
    for k, (a, b) in enumerate(itertools.pairwise(edges)):
        np.matmul(right[a:b].T, flat[a:b], out=out[k])
    return sets.products(out)


def _forward_substituted(lower: Array, columns: Array) -> Array:
    """(L⁻¹ columns)ᵀ (tried, m, b) for each lower L (tried, b, b) and columns (tried, b, m)."""
    from scipy.linalg.blas import dtrsm

    return np.stack([dtrsm(1.0, one.T, right.T, side=1) for one, right in zip(lower, columns, strict=True)])


def _explained_within(schur: Array, xty: Array, new: NDArray[np.bool_]) -> Array:
    """What falls off the sums of squares (tried, c), in the coordinates that are `new` (c, p) alone."""
    inside = new[:, :, None] & new[:, None, :]
    system = np.where(inside, schur, 0.0) + np.eye(schur.shape[-1]) * ~new[:, :, None]
    xty = np.where(new, xty, 0.0)[..., None]
    return np.asarray(np.sum(xty * np.linalg.solve(system, xty), axis=(2, 3)))


def grams_of_bands(columns: Array, bands: Bands) -> Array:
    """Gram matrices (bands, p, p) of columns (n, q, p)."""
    parts = [columns[a:b].reshape(-1, columns.shape[2]) for a, b in itertools.pairwise(bands.edges)]
    return np.stack(
        parallel_map(lambda part: part.T @ part, parts)
        if columns.size > PARALLEL_FROM
        else [part.T @ part for part in parts]
    )


def _best_spectra(rss: Array, size: int, q: int, bands: Bands, min_noise_level: float) -> list[Likelihood]:
    """The spectrum of the largest likelihood (without its constant) for each of c residual sums (tried, c)."""
    variance = np.maximum(rss / size, min_noise_level**2)
    logs = -0.5 * (size * np.log(variance) + rss / variance + q * (np.log(bands.spectra) @ bands.count)[:, None])
    best = np.argmax(logs, axis=0)
    return [
        Likelihood(float(logs[t, k]), float(np.sqrt(variance[t, k])), int(t), float(rss[0, k]))
        for k, t in enumerate(best)
    ]
