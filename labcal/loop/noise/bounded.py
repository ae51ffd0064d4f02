"""The noise spectrum for uncertainties: bounded at low frequency, and no more certain than the residual makes it.

The spectrum that fits the whole band best says little about its lowest frequencies, which weigh most in the uncertainty
of a constant: a random walk that follows a short correlation is infinite at zero. So white noise plus a slow process of
any correlation time up to the run's length, exponential or flicker, is weighed by its restricted likelihood (Patterson
& Thompson, Biometrika 58, 545, 1971: what the fitted columns took up tells nothing of the noise), and the spectra are
averaged with these weights (Hoeting et al., Statist. Sci. 14, 382, 1999). Below the lowest cosine of the run there is
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
CORNERS = (1e-5, 1e-4, 1e-3, 1e-2, 1e-1)  # c, in λ = 2 − 2 cos(π k / n),
BELOW_LOWEST = 16  # part of the lowest cosine's λ, and one there: at a quarter of its frequency
POWERS = (0.5, 1.0)  # flicker noise (1/f), exponential correlation (1/f² above its corner)
SIZES = np.logspace(-1, 5, 13).tolist()  # of the slow process at its largest over the white noise
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
    weighed = np.tensordot(1.0 / tried, grams, axes=1)
    logs, level = np.array([_restricted(g, spectrum, bands, y) for g, spectrum in zip(weighed, tried, strict=True)]).T
    weight = np.exp(logs - logs.max())
    weight[0] *= WHITE_ODDS * (len(weight) - 1)
    return WeightedSpectra(bands, weight / weight.sum(), level[:, None] * tried, float(y.size - grams.shape[1] + 1))


@lru_cache(maxsize=LENGTHS_KEPT)
def tried_spectra(n: int) -> Array:
    """The spectra tried (tried, bands), relative to the white level; white noise first."""
    edges = bands_of(n).edges
    k = np.maximum(np.arange(n), 1)
    eigen = 2 - 2 * np.cos(np.pi * k / n)
    lowest = float(eigen[0]) / BELOW_LOWEST
    corners = [lowest, *(c for c in CORNERS if c > 2 * lowest)]
    shapes = [(eigen + c) ** -power for power, c in itertools.product(POWERS, corners)]
    spectra = [np.ones(n), *(1 + size * s / s[0] for s, size in itertools.product(shapes, SIZES))]
    return np.exp(np.add.reduceat(np.log(spectra), edges[:-1], axis=1) / np.diff(edges))


def _on_independent(grams: Array) -> Array:
    """The Gram matrices (bands, b + 1, b + 1) of columns and y on directions of the columns that are independent."""
    total = grams.sum(axis=0)[:-1, :-1]
    size = np.sqrt(np.maximum(np.diag(total), 1e-300))
    values, vectors = np.linalg.eigh(total / np.outer(size, size))
    new = values > RANK_TOLERANCE * values[-1]
    basis = np.zeros((len(size) + 1, int(new.sum()) + 1))
    basis[:-1, :-1], basis[-1, -1] = vectors[:, new] / size[:, None] / np.sqrt(values[new]), 1.0
    return np.asarray(basis.T @ grams @ basis)


def _restricted(gram: Array, spectrum: Array, bands: Bands, y: Array) -> tuple[float, float]:
    """The restricted log-likelihood at the most likely level, without its constant, and the square of that level."""
    lower = np.linalg.cholesky(gram)
    left = max(float(lower[-1, -1]) ** 2, 1e-300)
    free = y.size - len(gram) + 1
    logs = free * np.log(left / free) + y.shape[1] * float(np.log(spectrum) @ bands.count)
    return -0.5 * (logs + 2 * float(np.log(np.diag(lower)[:-1]).sum())), left / free
