"""The white level of a series from its second differences: robust, and blind to what is slow."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SIGMA_PER_MAD = 1.4826  # standard deviation over median absolute deviation, of normal values
SECOND_DIFFERENCE = 6  # variance of y₁ − 2 y₂ + y₃ over that of y


def white_level(y: Array, segment: NDArray[np.intp], rounding: float = 0.0) -> float:
    """Standard deviation of y (n, q) from row to row inside segments: a lower bound where noise correlates.

    In steps that are coarser than the noise, whose `rounding` is more than the median says, most rows are like their
    neighbours, and those that are not tell the noise: then it is the root mean square.
    """
    within = segment[2:] == segment[:-2]
    second = (y[2:] - 2 * y[1:-1] + y[:-2])[within]
    if not len(second):
        return 1.0
    robust = float(SIGMA_PER_MAD * np.median(np.abs(second)) / np.sqrt(SECOND_DIFFERENCE))
    return robust if robust > rounding else float(np.sqrt(np.mean(second**2) / SECOND_DIFFERENCE))
