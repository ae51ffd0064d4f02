"""Lines above the Nyquist frequency, where a recorder that starts anew tells them from their folded images.

In each segment a line shows at its image below the Nyquist frequency, at a phase of its own. Of all the frequencies
that fold there, the true one alone has the same phase on the clock in every segment.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.noise.periodogram import periodogram, running_median

Array = NDArray[np.float64]
HIGHEST_Hz = 65.0  # the mains of any country, and what is slower
MOST_ORDERS = 650  # of the sampling rate: a recorder slower than 10 s is not looked at so high
CONTRAST = 3.0  # times its neighbourhood: a lower peak of all segments is not looked at
EXACT = 1e-6  # of the scores' squares: a line leaves no less; and so far are sine and cosine apart
PER_RESOLUTION = 4  # frequencies tried for each 1 / (the run's length)
LOOKED_AT_CLOSELY = 12  # orders, the most powerful: one in a hundred at these steps is a fiftieth below its top
BETWEEN = 8  # places between two of them


def unfolded_line(t_s: Array, scores: Array, parts: Sequence[slice]) -> tuple[float, int] | None:
    """The frequency [Hz] of the highest line that keeps its phase over all segments, and how many were tried.

    For scores (n, axes) at times t_s (n,) in these segments. None where no image of a line shows, or where that image
    below the Nyquist frequency is as likely as the line.
    """
    if len(parts) < 2:
        return None
    found = [_unfolded(t_s, scores, parts, image) for image in _images(t_s, scores, parts)]
    best = max(filter(None, found), key=lambda one: one[2], default=None)
    return None if best is None else best[:2]


def _unfolded(t_s: Array, scores: Array, parts: Sequence[slice], image: float) -> tuple[float, int, float] | None:
    """The likeliest frequency that folds to an image [Hz], how many were tried, and its power; None if none leads."""
    rate = 1 / float(np.median(np.diff(t_s)))
    orders = range(1, min(int(HIGHEST_Hz / rate), MOST_ORDERS) + 1)
    folds = np.array([image, *(order * rate + sign * image for order in orders for sign in (-1, 1))])
    shifts = _shifts(t_s, parts)
    powers = _in_phase(t_s, scores, parts, folds, shifts)  # (folds, shifts)
    first = np.argsort(-powers.max(axis=1))[:LOOKED_AT_CLOSELY]
    near, step = folds + shifts[powers.argmax(axis=1)], shifts[1] - shifts[0]
    of_image, *others = (_top(t_s, scores, parts, near[k], step) for k in (0, *first[first > 0]))
    best = max(others, key=lambda top: top[1])
    return (*best[:1], int(powers.size), best[1]) if _leads(scores, best[1], of_image[1], len(folds)) else None


def _top(t_s: Array, scores: Array, parts: Sequence[slice], frequency: float, step: float) -> tuple[float, float]:
    """Where about a frequency the power is largest [Hz], and that power: between two that are tried it may fall."""
    near = frequency + step * np.linspace(-1.0, 1.0, 2 * BETWEEN + 1)
    power = _in_phase(t_s, scores, parts, near, np.zeros(1))[:, 0]
    at = int(np.argmax(power))
    return float(near[at]), float(power[at])


def _leads(scores: Array, power: float, of_image: float, tried: int) -> bool:
    """Whether the likeliest of `tried` frequencies is likelier than the image, by what each leaves of the scores."""
    total = float(np.sum(scores**2))
    left, by_image = (max(total - one, EXACT * total) for one in (power, of_image))
    lead = 0.5 * scores.size * float(np.log(by_image / left))
    return lead > policy.POLICY.equivalent_nats + float(np.log(tried))


def _images(t_s: Array, scores: Array, parts: Sequence[slice]) -> list[float]:
    """Where the powers of all segments together stand highest above their neighbourhood [Hz], and below a period.

    A whole period in a segment is enough, and less of one is looked at as well: a drift may look so, but keeps its
    phase at no frequency that folds there.
    """
    spectra = [periodogram(t_s[part], scores[part]) for part in parts if part.stop - part.start > PER_RESOLUTION]
    if not spectra:
        return []
    grid = max((frequency for frequency, _ in spectra), key=len)
    power = np.sum([np.interp(grid, frequency, one) for frequency, one in spectra], axis=0)
    contrast, length_s = power / running_median(power), _length_s(t_s, parts)
    resolved = (grid > 1 / length_s) & (grid < grid[-1] - 0.5 / length_s)  # from an offset, from its own mirror image
    peak = int(np.argmax(np.where(resolved, contrast, 0.0)))
    slow = (grid > 0) & (grid <= 1 / length_s)
    found = [float(grid[peak])] if resolved[peak] and contrast[peak] > CONTRAST else []
    return found + ([0.5 / length_s] if (contrast[slow] > CONTRAST).any() else [])


def _shifts(t_s: Array, parts: Sequence[slice]) -> Array:
    """Frequencies beside one that a segment does not resolve from it, as finely as the run does [Hz]."""
    width = 0.5 / _length_s(t_s, parts)
    step = 1 / (PER_RESOLUTION * float(np.ptp(t_s)))
    return np.arange(-width, width, step)


def _length_s(t_s: Array, parts: Sequence[slice]) -> float:
    """Of a usual segment [s]."""
    return float(np.median([np.ptp(t_s[part]) for part in parts]))


def _in_phase(t_s: Array, scores: Array, parts: Sequence[slice], folds: Array, shifts: Array) -> Array:
    """What a line of one phase takes off the scores' squares, at frequencies and beside them (folds, shifts).

    Of sine and cosine together, which are not at right angles where the Nyquist frequency is near.
    """
    sums = np.zeros((scores.shape[1], len(folds), len(shifts)), dtype=np.complex128)
    twice = np.zeros(sums.shape[1:], dtype=np.complex128)
    for part in parts:
        at, near = (np.exp(-2j * np.pi * np.outer(f, t_s[part])) for f in (folds, shifts))
        sums += (scores[part].T[:, None, :] * at) @ near.T
        twice += (at**2) @ (near**2).T
    n, apart = len(t_s), np.maximum(len(t_s) ** 2 - np.abs(twice) ** 2, EXACT * len(t_s) ** 2)
    powers = n * np.abs(sums) ** 2 - (twice.conj() * sums**2).real
    return np.asarray(2 * np.sum(powers, axis=0) / apart)
