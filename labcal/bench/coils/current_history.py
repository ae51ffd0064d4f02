"""Which currents flowed when: what a reference saw may come seconds later, when others flow."""

from __future__ import annotations

import math
from bisect import bisect_right

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
KEPT = 20_000  # readings: hours, where they are read a few times a second


class CurrentHistory:
    """Readings of the three currents by their time; before the first nothing flowed."""

    def __init__(self) -> None:
        self._t_s, self._read_A = [-math.inf], [np.zeros(3)]

    @property
    def last_A(self) -> Array:
        """As last read, (3,), signed."""
        return self._read_A[-1]

    def see(self, t_s: float, currents_A: Array) -> None:
        """They were read to be `currents_A` (3,), from `t_s` on."""
        self._t_s.append(t_s)
        self._read_A.append(currents_A)
        too_many = max(0, len(self._t_s) - KEPT)
        del self._t_s[:too_many], self._read_A[:too_many]

    def at(self, t_s: ArrayLike) -> Array:
        """The currents (n, 3) at the times (n,): at each as read last until then, the oldest known before that."""
        places = (max(bisect_right(self._t_s, t) - 1, 0) for t in np.asarray(t_s).tolist())
        return np.array([self._read_A[place] for place in places]).reshape(-1, 3)
