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

import numpy as np
from numpy.typing import NDArray

from labcal.loop.noise.bands import Bands, bands_of, transformed
from labcal.loop.parallel import each

Array = NDArray[np.float64]
RIDGE = 1e-12
MANY = 500_000  # numbers in columns whose Gram matrices are worth two cores


def spectrum_of(moved: Array, y: Array) -> tuple[Bands, Array]:
    """The bands and the noise's variance in each, with transformed columns (n, q, b) fitted to y (n, q)."""
    bands = bands_of(len(y))
    null = Stage.of(moved, transformed(y)[:, :, None], bands, 0.0).null
    return bands, null.level**2 * bands.spectra[null.tried]


def weighted_gram(moved: Array, bands: Bands, weight: Array) -> Array:
    """Σ_k weight_k G_k (b, b) over the bands, for transformed columns (n, q, b)."""
    return np.asarray(np.tensordot(weight, _grams(moved, bands), axes=1))


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
    right: Array  # (n q, b + 1) both
    bands: Bands
    lowest: float
    half: Array  # (tried, b, b) lower L of the weighted Gram matrices L Lᵀ, columns at unit length
    pulled: Array  # (tried, b) L⁻¹ times their products with y
    rss: Array  # (tried,)
    null: Likelihood

    @classmethod
    def of(cls, columns: Array, y: Array, bands: Bands, lowest: float) -> Stage:
        """Eliminate `columns` (n, q, b), whatever their lengths."""
        both = np.concatenate([columns, y], axis=2)
        columns = both[:, :, :-1]
        columns /= np.maximum(np.sqrt(np.einsum("nqb,nqb->b", columns, columns)), 1e-300)
        total = np.tensordot(1.0 / bands.spectra, _grams(both, bands), axes=1)
        A, b, yy = total[:, :-1, :-1], total[:, :-1, -1:], total[:, -1, -1]
        diagonal = np.einsum("tii->ti", A)
        diagonal += RIDGE * diagonal.sum(axis=1, keepdims=True)
        half = np.asarray(np.linalg.cholesky(A), dtype=np.float64)
        pulled = _divided(half, b)[:, 0]
        rss = np.maximum(yy - np.sum(pulled**2, axis=1), 1e-300)
        null = _best(rss[:, None], y.size, y.shape[1], bands, lowest)[0]
        return cls(columns, y, both.reshape(-1, both.shape[2]), bands, lowest, half, pulled, rss, null)

    def beside(self, X: Array) -> tuple[Likelihood, int]:
        """The likelihood with the transformed columns X (n, q, p) too, and how many directions they add."""
        return self.beside_each(X[:, :, None, :])[0]

    def beside_each(self, X: Array, ground: Grams | None = None, least: float = 1e-4) -> list[tuple[Likelihood, int]]:
        """The same for each of c sets of as many columns, X (n, q, c, p), on its own.

        `ground` are their Gram matrices with the first of the columns here and with y, where they are known.
        """
        own, cross, pull = self._totals(X, ground)
        stood = _divided(self.half, cross).reshape(*pull.shape, -1)
        schur = own - stood @ np.swapaxes(stood, 2, 3)
        pull = pull - (stood @ self.pulled[:, None, :, None])[..., 0]
        values, vectors = np.linalg.eigh(schur[0])
        new = values > least * np.trace(own[0], axis1=1, axis2=2)[:, None] / X.shape[3]
        if not new.all():
            schur, pull = np.swapaxes(vectors, 1, 2) @ schur @ vectors, (pull[:, :, None, :] @ vectors)[:, :, 0]
        drop = _explained(schur, pull, new)
        rss = np.maximum(self.rss[:, None] - drop, 1e-300)
        found = _best(rss, self.y.size, self.y.shape[1], self.bands, self.lowest)
        return list(zip(found, new.sum(axis=1).tolist(), strict=True))

    def _totals(self, X: Array, ground: Grams | None) -> tuple[Array, Array, Array]:
        """Gram matrices of X at unit length under every spectrum.

        With itself (tried, c, p, p), with the columns here (tried, b, c p), and with y (tried, c, p).
        """
        if ground is None:
            found = Grams.of(X, self.right, self.bands)
        else:
            found = ground.with_more(X, self.right[:, ground.cross.shape[1] - 1 : -1], self.bands)
        length = np.sqrt(np.maximum(np.einsum("kcpp->cp", found.own), 1e-300))
        weight = 1.0 / self.bands.spectra
        own = np.tensordot(weight, found.own, axes=1) / (length[:, :, None] * length[:, None, :])
        cross = np.tensordot(weight, found.cross, axes=1) / length.ravel()
        return own, cross[:, :-1], cross[:, -1].reshape(len(weight), *length.shape)


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
        return cls(own, _crossed(X, right, bands))

    def with_more(self, X: Array, more: Array, bands: Bands) -> Grams:
        """These with other columns (n q, more) put before the last of those there are."""
        new = _crossed(X, more, bands)
        return Grams(self.own, np.concatenate([self.cross[:, :-1], new, self.cross[:, -1:]], axis=1))


def _crossed(X: Array, right: Array, bands: Bands) -> Array:
    """Gram matrices (bands, others, c p)."""
    n, q, c, p = X.shape
    flat, edges = X.reshape(n * q, c * p), (bands.edges * q).tolist()
    out = np.empty((len(edges) - 1, right.shape[1], c * p))
    for k, (a, b) in enumerate(itertools.pairwise(edges)):
        np.matmul(right[a:b].T, flat[a:b], out=out[k])
    return out


def _divided(half: Array, columns: Array) -> Array:
    """(L⁻¹ columns)ᵀ (tried, m, b) for each lower L of `half` (tried, b, b) and columns (tried, b, m)."""
    from scipy.linalg.blas import dtrsm

    return np.stack([dtrsm(1.0, lower.T, right.T, side=1) for lower, right in zip(half, columns, strict=True)])


def _explained(schur: Array, pull: Array, new: NDArray[np.bool_]) -> Array:
    """What falls off the sums of squares (tried, c), in the directions that are `new` (c, p) alone."""
    inside = new[:, :, None] & new[:, None, :]
    system = np.where(inside, schur, 0.0) + np.eye(schur.shape[-1]) * ~new[:, :, None]
    pull = np.where(new, pull, 0.0)[..., None]
    return np.asarray(np.sum(pull * np.linalg.solve(system, pull), axis=(2, 3)))


def _grams(columns: Array, bands: Bands) -> Array:
    """Gram matrices (bands, p, p) of columns (n, q, p)."""
    parts = [columns[a:b].reshape(-1, columns.shape[2]) for a, b in itertools.pairwise(bands.edges)]
    return np.stack(
        each(lambda part: part.T @ part, parts) if columns.size > MANY else [part.T @ part for part in parts]
    )


def _best(rss: Array, size: int, q: int, bands: Bands, lowest: float) -> list[Likelihood]:
    """The spectrum of the largest likelihood (without its constant) for each of c residual sums (tried, c)."""
    variance = np.maximum(rss / size, lowest**2)
    logs = -0.5 * (size * np.log(variance) + rss / variance + q * (np.log(bands.spectra) @ bands.count)[:, None])
    best = np.argmax(logs, axis=0)
    return [
        Likelihood(float(logs[t, k]), float(np.sqrt(variance[t, k])), int(t), float(rss[0, k]))
        for k, t in enumerate(best)
    ]
