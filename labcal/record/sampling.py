"""How often a stream samples, worked out from its stamps as they are: lines that arrive together share one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def period_s(t_s: Array) -> float:
    """The time [s] between two samples stamped `t_s` (n,), in any order; NaN where there are no two moments.

    Span over count between two moments, the median over the samples: where all stamps differ the median step, which a
    gap does not move; where lines arrive together, each has its part of the time since those before.
    """
    moments, count = np.unique(t_s, return_counts=True)
    if len(moments) < 2:
        return float("nan")
    return float(np.median(np.repeat(np.diff(moments) / count[1:], count[1:])))
