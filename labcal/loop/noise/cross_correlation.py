"""Cross-correlation of two series, in standard deviations of chance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
MAX_LAG = 20  # rows either way over which a cross-correlation is taken
TAPERED = 10  # part of the record over which the sums of chance are tapered


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """A series less its mean, as its cross-correlations need it."""

    n: int
    fourier: NDArray[np.complex128]
    rho: Array  # (n,) its autocorrelation from lag 0 on
    size: float  # root of its sum of squares

    @classmethod
    def of(cls, x: Array) -> Series:
        """Of the values x (n,)."""
        n, padded = len(x), _padded(len(x))
        fourier = np.fft.rfft(x - x.mean(), padded)
        rho = np.fft.irfft(np.abs(fourier) ** 2, padded)[:n]
        return cls(n, fourier, rho / max(rho[0], 1e-300), float(np.sqrt(max(rho[0], 0.0))))


def _padded(n: int) -> int:
    """A length that holds all lags of n rows and is fast to transform."""
    from scipy.fft import next_fast_len

    return int(next_fast_len(2 * n, real=True))


def cross_correlation(y: Series, x: Series) -> tuple[float, float]:
    """The largest cross-correlation over MAX_LAG rows either way: in standard deviations of chance, and its value.

    Chance has the variance Σ ρ_y ρ_x / n (Bartlett 1946), sums tapered at a tenth of the record.
    """
    cut = max(y.n // TAPERED, 1)
    taper = 1 - np.arange(cut) / cut
    both = y.rho[:cut] * x.rho[:cut] * taper
    variance = max(1 + 2 * float(np.sum(both[1:])), 1.0) / y.n
    cross = np.fft.irfft(y.fourier * np.conj(x.fourier), _padded(y.n)) / max(y.size * x.size, 1e-300)
    near = np.concatenate([cross[: MAX_LAG + 1], cross[-MAX_LAG:]])
    place = int(np.argmax(np.abs(near)))
    return float(abs(near[place]) / np.sqrt(variance)), float(near[place])
