"""The likelihood of a residual whose noise is white plus a slow unnamed process, with any columns fitted.

In the cosine transform along the rows a process with spectrum s (1 + r / (λ + c)), λ = 2 − 2 cos(π k / n), is
uncorrelated: exactly so for white noise and for a random walk (c = 0), nearly so for an exponentially correlated one
(a path's Laplacian has the DCT-II as its eigenvectors; Strang, SIAM Review 41, 135, 1999). Generalised least squares is
then a weighted sum of Gram matrices over bands of frequency, and the noise's own parameters r and c cost no refit.
An effect has to beat this process, not white noise: what any slow wandering would explain as well is no evidence.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
BANDS_PER_OCTAVE = 2.0
CORNERS = (0.0, 1e-3, 1e-1)
RATIOS = (0.0, *np.logspace(-6, 1.5, 11).tolist())


@dataclass(frozen=True, slots=True, eq=False)
class Bands:
    """Bands of frequency for n rows, and the spectra tried in each."""

    edges: NDArray[np.intp]  # (bands + 1,)
    spectra: Array  # (tried, bands) relative to the white level
    corner: Array  # (tried,) c
    ratio: Array  # (tried,) r

    @property
    def count(self) -> Array:
        """Frequencies in each band."""
        return np.diff(self.edges).astype(float)


@lru_cache(maxsize=8)
def bands_of(n: int) -> Bands:
    """The bands and the spectra of the noise processes tried, white noise first."""
    octaves = max(int(np.ceil(np.log2(n) * BANDS_PER_OCTAVE)), 1)
    edges = np.unique(np.round(np.concatenate([[0, 1], np.geomspace(1, n, octaves + 1)])).astype(int))
    k = np.arange(n)
    eigen = 2 - 2 * np.cos(np.pi * np.maximum(k, 0.5) / n)
    tried = [(0.0, 0.0)] + [(c, r) for c in CORNERS for r in RATIOS[1:]]
    spectra = []
    for c, r in tried:
        full = 1 + r / (eigen + c)
        spectra.append(np.exp(np.add.reduceat(np.log(full), edges[:-1]) / np.diff(edges)))
    tried_array = np.array(tried)
    return Bands(edges, np.array(spectra), tried_array[:, 0], tried_array[:, 1])


def transformed(columns: Array) -> Array:
    """The cosine transform along the rows (n, ...), orthonormal."""
    from scipy.fft import dct

    return np.asarray(dct(columns, axis=0, norm="ortho"))


def spectrum_of(columns: Array, y: Array) -> tuple[Bands, Array]:
    """The bands and the noise's variance in each, with these columns (n, q, b) fitted to y (n, q)."""
    bands = bands_of(len(y))
    null = Stage.of(transformed(columns), transformed(y)[:, :, None], bands, 0.0).null
    return bands, null.level**2 * bands.spectra[null.tried]


def weighted_gram(columns: Array, bands: Bands, weight: Array) -> Array:
    """Σ_k weight_k G_k (b, b) over the bands, for columns (n, q, b)."""
    moved = transformed(columns)
    parts = [moved[a:b].reshape(-1, moved.shape[2]) for a, b in itertools.pairwise(bands.edges)]
    return np.asarray(sum(w * part.T @ part for w, part in zip(weight, parts, strict=True)))


@dataclass(frozen=True, slots=True, eq=False)
class Likelihood:
    """The best noise process for one set of columns."""

    log: float
    level: float  # standard deviation of the white part, in whitened units
    tried: int  # which spectrum of the bands
    rss: float  # residual sum of squares of plain least squares


@dataclass(frozen=True, slots=True, eq=False)
class Stage:
    """Transformed columns that every candidate stands beside, and y: eliminated once for every spectrum.

    The white level of the noise is kept at `lowest` or above.
    """

    columns: Array  # (n, q, b)
    y: Array  # (n, q, 1)
    bands: Bands
    lowest: float
    inverse: Array  # (tried, b, b) of the weighted Gram matrices, columns at unit length
    solved: Array  # (tried, b) coefficients of y
    rss: Array  # (tried,)
    null: Likelihood

    @classmethod
    def of(cls, columns: Array, y: Array, bands: Bands, lowest: float) -> Stage:
        """Eliminate `columns` (n, q, b), whatever their lengths."""
        columns = columns / np.maximum(np.sqrt(np.sum(columns**2, axis=(0, 1))), 1e-300)
        total = _weighted(columns, np.concatenate([columns, y], axis=2), bands)
        A, b = total[:, :, :-1], total[:, :, -1]
        inverse = np.linalg.inv(A + RIDGE * np.eye(A.shape[1]) * np.trace(A, axis1=1, axis2=2)[:, None, None])
        solved = np.einsum("tij,tj->ti", inverse, b)
        yy = _weighted(y, y, bands)[:, 0, 0]
        rss = np.maximum(yy - np.sum(solved * b, axis=1), 1e-300)
        return cls(columns, y, bands, lowest, inverse, solved, rss, _best(rss, y.size, y.shape[1], bands, lowest))

    def beside(self, X: Array, least: float = 1e-4) -> tuple[Likelihood, int]:
        """The likelihood with the transformed columns X (n, q, p) too, and how many directions they add."""
        X = X / np.maximum(np.sqrt(np.sum(X**2, axis=(0, 1))), 1e-300)
        b, p = self.columns.shape[2], X.shape[2]
        bands = _grams(X, np.concatenate([self.columns, X, self.y], axis=2), self.bands)
        new = self._directions(bands.sum(axis=0), least)
        total = np.tensordot(1.0 / self.bands.spectra, np.einsum("pk,bpr->bkr", new, bands), axes=1)
        cross, own, pull = total[:, :, :b], total[:, :, b : b + p] @ new, total[:, :, -1]
        schur = own - cross @ self.inverse @ np.swapaxes(cross, 1, 2)
        pull = (pull - np.einsum("tkb,tb->tk", cross, self.solved))[:, :, None]
        drop = np.sum(pull * np.linalg.solve(schur, pull), axis=(1, 2))
        rss = np.maximum(self.rss - drop, 1e-300)
        return _best(rss, self.y.size, self.y.shape[1], self.bands, self.lowest), new.shape[1]

    def _directions(self, total: Array, least: float) -> Array:
        """Combinations (p, k) of columns of which more than `least` of the square is new, for white noise."""
        b, p = self.columns.shape[2], len(total)
        cross, own = total[:, :b], total[:, b : b + p]
        values, vectors = np.linalg.eigh(own - cross @ self.inverse[0] @ cross.T)
        return np.asarray(vectors[:, values > least * np.trace(own) / p])


RIDGE = 1e-12


def _weighted(left: Array, right: Array, bands: Bands) -> Array:
    """Gram matrices (tried, p, r) under every spectrum."""
    return np.asarray(np.tensordot(1.0 / bands.spectra, _grams(left, right, bands), axes=1))


def _grams(left: Array, right: Array, bands: Bands) -> Array:
    """Gram matrices (bands, p, r)."""
    return np.stack(
        [
            left[a:b].reshape(-1, left.shape[2]).T @ right[a:b].reshape(-1, right.shape[2])
            for a, b in itertools.pairwise(bands.edges)
        ]
    )


def _best(rss: Array, size: int, q: int, bands: Bands, lowest: float) -> Likelihood:
    """The spectrum of the largest likelihood (without its constant) for residual sums of squares (tried,)."""
    variance = np.maximum(rss / size, lowest**2)
    logs = -0.5 * (size * np.log(variance) + rss / variance + q * (np.log(bands.spectra) @ bands.count))
    best = int(np.argmax(logs))
    return Likelihood(float(logs[best]), float(np.sqrt(variance[best])), best, float(rss[0]))
