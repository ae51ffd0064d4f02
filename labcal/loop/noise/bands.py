"""Bands of frequency in the cosine transform, and the noise spectra that are tried in them."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
BANDS_PER_OCTAVE = 2.0
CORNERS = (0.0, 1e-3, 1e-1)  # c: 0 is a random walk
RATIOS = np.logspace(-6, 1.5, 11).tolist()  # r
LENGTHS_KEPT = 8  # numbers of rows whose bands and spectra are kept
PRIMES = 2 * 3 * 5  # of a length that is fast to transform
INDISTINGUISHABLE = 0.1  # sum of squared logarithms: a spectrum nearer to white noise than this is not tried


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


@lru_cache(maxsize=LENGTHS_KEPT)
def bands_of(n: int) -> Bands:
    """The bands and the spectra of the noise processes tried, white noise first."""
    octaves = max(int(np.ceil(np.log2(n) * BANDS_PER_OCTAVE)), 1)
    edges = np.unique(np.round(np.concatenate([[0, 1], np.geomspace(1, n, octaves + 1)])).astype(int))
    k = np.arange(n)
    eigen = 2 - 2 * np.cos(np.pi * np.maximum(k, 0.5) / n)
    corner, ratio = np.array([(0.0, 0.0), *itertools.product(CORNERS, RATIOS)]).T
    logs = np.log1p(ratio[:, None] / (eigen + corner[:, None]))
    apart = np.sum(logs**2, axis=1) > INDISTINGUISHABLE
    apart[0] = True
    means = np.add.reduceat(logs[apart], edges[:-1], axis=1) / np.diff(edges)
    return Bands(edges, np.exp(means), corner[apart], ratio[apart])


def cosine_transform(columns: Array) -> Array:
    """The cosine transform along the rows (n, ...), orthonormal."""
    from scipy.fft import dct

    return np.asarray(dct(columns, axis=0, norm="ortho"))


def fast_length(n: int, primes: int = PRIMES) -> int:
    """The largest length up to n that is fast to transform: one with a large prime factor takes five times as long.

    It has no other prime factors than those of `primes`.
    """
    return next(k for k in range(n, 0, -1) if pow(primes, n.bit_length(), k) == 0)
