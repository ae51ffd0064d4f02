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
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.loop.noise.bands import Bands, bands_of, cosine_transform
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
        return self.with_each(X[:, :, None, :])[0]

    def with_each(self, X: Array, base_grams: Grams | None = None) -> list[tuple[Likelihood, int]]:
        """The same for each of c sets of as many columns, X (n, q, c, p), on its own.

        `base_grams` are their Gram matrices with the first of the columns here and with y, where they are known. Which
        directions are new is decided under white noise, so that every spectrum is compared with equal rank.
        """
        gram, cross, xty = self._normal_equations(X, base_grams)
        projected = _forward_substituted(self.cholesky, cross).reshape(*xty.shape, -1)
        schur = gram - projected @ np.swapaxes(projected, 2, 3)
        xty = xty - (projected @ self.projected_y[:, None, :, None])[..., 0]
        values, vectors = np.linalg.eigh(schur[0])
        new = values > MIN_NEW_SHARE * np.trace(gram[0], axis1=1, axis2=2)[:, None] / X.shape[3]
        if not new.all():
            schur, xty = np.swapaxes(vectors, 1, 2) @ schur @ vectors, (xty[:, :, None, :] @ vectors)[:, :, 0]
        rss = np.maximum(self.rss[:, None] - _explained_within(schur, xty, new), 1e-300)
        found = _best_spectra(rss, self.y.size, self.y.shape[1], self.bands, self.min_noise_level)
        return list(zip(found, new.sum(axis=1).tolist(), strict=True))

    def _normal_equations(self, X: Array, base_grams: Grams | None) -> tuple[Array, Array, Array]:
        """Products of X at unit length under every spectrum.

        With itself (tried, c, p, p), with the columns here (tried, b, c p), and with y (tried, c, p).
        """
        if base_grams is None:
            found = Grams.of(X, self.columns_and_y, self.bands)
        else:
            found = base_grams.with_columns(X, self.columns_and_y[:, base_grams.cross.shape[1] - 1 : -1], self.bands)
        length = np.sqrt(np.maximum(np.einsum("kcpp->cp", found.own), 1e-300))
        weight = 1.0 / self.bands.spectra
        gram = np.tensordot(weight, found.own, axes=1) / (length[:, :, None] * length[:, None, :])
        cross = np.tensordot(weight, found.cross, axes=1) / length.ravel()
        return gram, cross[:, :-1], cross[:, -1].reshape(len(weight), *length.shape)


@dataclass(frozen=True, slots=True, eq=False)
class Grams:
    """Of c sets of p transformed columns, in each band: with themselves, and with other columns."""

    own: Array  # (bands, c, p, p)
    cross: Array  # (bands, others, c p)

    @classmethod
    def of(cls, X: Array, right: Array, bands: Bands) -> Grams:
        """For X (n, q, c, p) and other columns `right` (n q, others)."""
        n, q, c, p = X.shape
        flat, edges = X.reshape(n * q, c, p), (bands.edges * q).tolist()
        own = np.empty((len(edges) - 1, c, p, p))
        for k, (a, b) in enumerate(itertools.pairwise(edges)):
            np.matmul(flat[a:b].transpose(1, 2, 0), flat[a:b].transpose(1, 0, 2), out=own[k])
        return cls(own, _cross_grams(X, right, bands))

    def with_columns(self, X: Array, more: Array, bands: Bands) -> Grams:
        """These with other columns (n q, more) put before the last of those there are."""
        new = _cross_grams(X, more, bands)
        return Grams(self.own, np.concatenate([self.cross[:, :-1], new, self.cross[:, -1:]], axis=1))


def _cross_grams(X: Array, right: Array, bands: Bands) -> Array:
    """Gram matrices (bands, others, c p)."""
    n, q, c, p = X.shape
    flat, edges = X.reshape(n * q, c * p), (bands.edges * q).tolist()
    out = np.empty((len(edges) - 1, right.shape[1], c * p))
    for k, (a, b) in enumerate(itertools.pairwise(edges)):
        np.matmul(right[a:b].T, flat[a:b], out=out[k])
    return out


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
