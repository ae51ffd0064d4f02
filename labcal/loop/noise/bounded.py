"""The noise spectrum for uncertainties: bounded at low frequency, and no more certain than the residual makes it.

The spectrum that fits the whole band best says little about its lowest frequencies, which weigh most in the uncertainty
of a constant: a random walk that follows a short correlation is infinite at zero. So white noise plus a slow process of
any correlation time up to the run's length, exponential or flicker, is weighted by its restricted likelihood (Patterson
& Thompson, Biometrika 58, 545, 1971: what the fitted columns took up tells nothing of the noise), and the spectra are
averaged with these weights (Hoeting et al., Statist. Sci. 14, 382, 1999). They stand nearer to one another than the
residual tells them apart: by how much they differ in a variance is how well it is known, and where one alone is likely
the variance seems as well known as its level, by all rows. Below the lowest cosine of the run there is
what there is at it: a process slower than the run is a part of the constant, which holds inside the run's span.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from labcal.loop.noise.bands import LENGTHS_KEPT, Bands, bands_of
from labcal.loop.noise.coloured import grams_of_bands
from labcal.loop.noise.nuisance import RANK_TOLERANCE

Array = NDArray[np.float64]
CORNERS = np.logspace(-5, -1, 17).tolist()  # c, in λ = 2 − 2 cos(π k / n),
BELOW_LOWEST = 16  # part of the lowest cosine's λ, and one there: at a quarter of its frequency
POWERS = (0.5, 1.0)  # flicker noise (1/f), exponential correlation (1/f² above its corner)
SIZES = np.logspace(-1, 5, 25)  # of the slow process at its largest over the white noise
IN_A_BAND = 32  # frequencies at which a spectrum is averaged over a band of more
WHITE_ODDS = 10.0  # of white noise against all the others together, before the residual is asked


@dataclass(frozen=True, slots=True, eq=False)
class WeightedSpectra:
    """The spectra tried, as large as the residual makes them, and their odds."""

    bands: Bands
    weight: Array  # (tried,) adds up to one
    spectra: Array  # (tried, bands) the noise's variance
    dof: float  # of the level of each

    @property
    def mean(self) -> Array:
        """The noise's variance in each band, over all of them."""
        return np.asarray(self.weight @ self.spectra)


def weighted_spectra(transformed: Array, y: Array) -> WeightedSpectra:
    """What noise there may be, with transformed columns (n, q, b) fitted to transformed y (n, q)."""
    bands, tried = bands_of(len(y)), tried_spectra(len(y))
    grams = _on_independent(grams_of_bands(np.concatenate([transformed, y[:, :, None]], axis=2), bands))
    logs, level = _restricted(np.tensordot(1.0 / tried, grams, axes=1), tried, bands, y)
    weight = np.exp(logs - logs.max())
    weight[0] *= WHITE_ODDS * (len(weight) - 1)
    return WeightedSpectra(bands, weight / weight.sum(), level[:, None] * tried, float(y.size - grams.shape[1] + 1))


@lru_cache(maxsize=LENGTHS_KEPT)
def tried_spectra(n: int) -> Array:
    """The spectra tried (tried, bands), relative to the white level; white noise first."""
    edges = bands_of(n).edges
    counts = np.minimum(np.diff(edges), IN_A_BAND)
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    width = np.repeat(np.diff(edges) / counts, counts)
    within = np.arange(counts.sum()) - np.repeat(starts, counts) + 0.5
    k = np.repeat(edges[:-1], counts) + within * width - 0.5
    eigen = 2 - 2 * np.cos(np.pi * np.maximum(k, 1) / n)
    lowest = float(eigen[0]) / BELOW_LOWEST
    corners = [lowest, *(c for c in CORNERS if c > 2 * lowest)]
    shapes = np.array([(eigen + c) ** -power for power, c in itertools.product(POWERS, corners)])
    slow = SIZES[:, None] * (shapes / shapes[:, :1])[:, None]
    logs = np.log1p(np.concatenate([np.zeros((1, len(k))), slow.reshape(-1, len(k))]))
    return np.asarray(np.exp(np.add.reduceat(logs, starts, axis=1) / counts))


def _on_independent(grams: Array) -> Array:
    """The Gram matrices (bands, b + 1, b + 1) of columns and y on directions of the columns that are independent."""
    total = grams.sum(axis=0)[:-1, :-1]
    size = np.sqrt(np.maximum(np.diag(total), 1e-300))
    values, vectors = np.linalg.eigh(total / np.outer(size, size))
    new = values > RANK_TOLERANCE * values[-1]
    basis = np.zeros((len(size) + 1, int(new.sum()) + 1))
    basis[:-1, :-1], basis[-1, -1] = vectors[:, new] / size[:, None] / np.sqrt(values[new]), 1.0
    return np.asarray(basis.T @ grams @ basis)


def _restricted(grams: Array, spectra: Array, bands: Bands, y: Array) -> tuple[Array, Array]:
    """Restricted log-likelihoods (tried,) at the most likely level, without their constant; squares of that level."""
    lower = np.linalg.cholesky(grams)
    free = y.size - grams.shape[1] + 1
    left = np.maximum(lower[:, -1, -1] ** 2, 1e-300) / free
    of_columns = np.log(np.einsum("tii->ti", lower)[:, :-1]).sum(axis=1)
    return -0.5 * (free * np.log(left) + y.shape[1] * (np.log(spectra) @ bands.count)) - of_columns, left
