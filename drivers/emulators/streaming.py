"""Samples on a steady beat: which moments have come since the last look."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


class Beat:
    """Sample times k / rate; `due` gives those up to a time that were not given before."""

    def __init__(self, rate_hz: float, start_s: float = 0.0) -> None:
        self._rate, self._next = rate_hz, int(np.ceil(start_s * rate_hz))

    def due(self, until_s: float) -> NDArray[np.float64]:
        """Times (n,), in order."""
        last = int(np.floor(until_s * self._rate + 1e-9))
        if last < self._next:
            return np.empty(0)
        times = np.arange(self._next, last + 1) / self._rate
        self._next = last + 1
        return times
