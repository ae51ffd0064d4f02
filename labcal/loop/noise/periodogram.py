"""Lines in the spectrum of a residual."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
FINER = 4  # places for each sampling interval, to which times are rounded
MEDIAN_WIDTH = 201  # frequencies about one that are its neighbourhood
LONGEST, PADDING = 64, 1024  # quarter intervals for each row, and beside: longer gaps are closed


def periodogram(t_s: Array, residual: Array) -> tuple[Array, Array]:
    """Frequencies [Hz] up to half the sampling rate and the power of all components; gaps count as zeros.

    Times are rounded to a quarter of the sampling interval.
    """
    from scipy.fft import next_fast_len, rfft

    step = float(np.median(np.diff(t_s)))
    place = np.round((t_s - t_s[0]) / (step / FINER)).astype(int)
    if place[-1] > LONGEST * len(t_s) + PADDING:  # gaps far longer than the record: close them
        place = np.cumsum(np.concatenate([[0], np.minimum(np.diff(place), LONGEST)]))
    grid = np.zeros((int(place[-1]) + 1, residual.shape[1]))
    np.add.at(grid, place, residual - residual.mean(axis=0))
    length = next_fast_len(2 * len(grid), real=True)
    power = np.sum(np.abs(rfft(grid, n=length, axis=0)) ** 2, axis=1)
    frequency = np.fft.rfftfreq(length, step / FINER)
    inside = frequency <= 0.5 / step
    return np.asarray(frequency[inside]), np.asarray(power[inside])


def running_median(power: Array, width: int = MEDIAN_WIDTH) -> Array:
    """The running median of a spectrum (k,)."""
    blocks = max(len(power) // width, 1)
    centres = (np.arange(blocks) + 0.5) * len(power) / blocks
    medians = [float(np.median(part)) for part in np.array_split(power, blocks)]
    return np.maximum(np.interp(np.arange(len(power)), centres, medians), 1e-300)
