"""The white level of a series from its second differences: robust, and blind to what is slow."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def white_level(y: Array, segment: NDArray[np.intp]) -> float:
    """Standard deviation of y (n, q) from row to row inside segments: a lower bound where noise correlates."""
    within = segment[2:] == segment[:-2]
    second = (y[2:] - 2 * y[1:-1] + y[:-2])[within]
    return float(1.4826 * np.median(np.abs(second)) / np.sqrt(6)) if len(second) else 1.0
