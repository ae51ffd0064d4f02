"""The white level of a series from its second differences: robust, and blind to what is slow."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy

Array = NDArray[np.float64]
SIGMA_PER_MAD = 1.4826  # standard deviation over median absolute deviation, of normal values
SECOND_DIFFERENCE = 6  # variance of y₁ − 2 y₂ + y₃ over that of y


def white_level(y: Array, segment: NDArray[np.intp], rounding: float = 0.0) -> float:
    """Standard deviation of y (n, q) from row to row inside segments: a lower bound where noise correlates.

    Where the median sees less than the `rounding` that is in y most rows round to the same: the root mean square says.
    """
    within = segment[2:] == segment[:-2]
    second = (y[2:] - 2 * y[1:-1] + y[:-2])[within]
    if not len(second):
        return 1.0
    of_median = float(SIGMA_PER_MAD * np.median(np.abs(second)) / np.sqrt(SECOND_DIFFERENCE))
    if of_median >= rounding:
        return of_median
    near = np.minimum(np.abs(second) / np.sqrt(SECOND_DIFFERENCE), policy.POLICY.outlier_sigmas * rounding)
    return float(np.sqrt(np.mean(near**2)))
