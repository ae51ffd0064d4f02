"""The finite basis of a smooth function: B-splines whose coefficients follow a Gaussian process of one length."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.model.affine import MAP_PARAMETERS
from labcal.model.smooth import Basis

Array = NDArray[np.float64]
DEGREE = 3
SPLINES = {1: 14, 2: 6}  # along each input
LENGTHS = {1: (0.1, 0.2, 0.4, 1.0), 2: (0.35, 0.9)}  # of the inputs' ranges, over which the function bends
KEPT = 1e-5  # of the largest prior variance: directions with less are left out


def splines_of(x: Array) -> Basis:
    """Plain B-splines over the range of inputs (n, k), each a function of its own, of prior one."""
    count = SPLINES[x.shape[1]]
    ends = zip(x.min(axis=0), x.max(axis=0), strict=True)
    knots = tuple(tuple(_knots(low, high, count).tolist()) for low, high in ends)
    each = count ** x.shape[1]
    return Basis("b-spline", knots, DEGREE, table(np.eye(each)), table(np.zeros((len(MAP_PARAMETERS), 3 * each))), 1.0)


def _knots(low: float, high: float, count: int) -> Array:
    step = (high - low) / (count - DEGREE)
    return np.asarray(low + step * (np.arange(count + DEGREE + 1) - DEGREE))


def functions_of_length(inputs: int, length: float) -> Array:
    """Splines' weights (splines, r): with independent unit coefficients f varies by one, correlated over `length`.

    Squared exponential (Rasmussen & Williams, Gaussian Processes for Machine Learning, 4.9 and 2.11), by its largest
    directions.
    """
    count = SPLINES[inputs]
    centre = (np.arange(count) - 1.0) / (count - DEGREE)
    one = np.exp(-((centre[:, None] - centre) ** 2) / (2 * length**2))
    values, vectors = np.linalg.eigh(one if inputs == 1 else np.kron(one, one))
    kept = values > KEPT * values[-1]
    return np.asarray((vectors[:, kept] * np.sqrt(values[kept]))[:, ::-1])


def table(values: Array) -> tuple[tuple[float, ...], ...]:
    """A matrix as the plain rows that a record holds."""
    return tuple(map(tuple, np.asarray(values, dtype=float).tolist()))
