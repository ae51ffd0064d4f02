"""How large an effect is over a recording, row after row: the same sum however the rows are cut into pieces."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


class Seen:
    """Sums of an effect's squares over the rows that have it, and of its changes from row to row."""

    def __init__(self) -> None:
        self.count, self._rows = 0, 0
        self._squares, self._steps, self._last = np.zeros(3), np.zeros(3), np.empty((0, 3))

    def take(self, value: Array, usable: Mask) -> None:
        """The effect (n, 3) in the rows that follow, and which of them (n,) have it."""
        self._squares = np.add.reduce(np.concatenate([self._squares[None], value[usable] ** 2]), axis=0)
        steps = np.diff(np.concatenate([self._last, value]), axis=0)
        self._steps = np.add.reduce(np.concatenate([self._steps[None], steps**2]), axis=0)
        self._last = value[-1:] if len(value) else self._last
        self.count, self._rows = self.count + int(usable.sum()), self._rows + len(value)

    @property
    def mean_square(self) -> Array:
        """(3,); nought where no row has it."""
        return np.asarray(self._squares / max(self.count, 1))

    @property
    def restless(self) -> Array:
        """Mean square (3,) of the change from row to row: what a row between two others may miss."""
        return np.asarray(self._steps / max(self._rows - 1, 1))
