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
        self._first, self._apart = np.zeros(3), np.zeros((2, 3))

    def take(self, value: Array, usable: Mask) -> None:
        """The effect (n, 3) in the rows that follow, and which of them (n,) have it."""
        there = value[usable]
        self._squares = np.add.reduce(np.concatenate([self._squares[None], there**2]), axis=0)
        self._first = self._first if self.count or not len(there) else there[0].copy()
        apart = np.stack([there - self._first, (there - self._first) ** 2], axis=1)
        self._apart = np.add.reduce(np.concatenate([self._apart[None], apart]), axis=0)
        steps = np.diff(np.concatenate([self._last, value]), axis=0)
        self._steps = np.add.reduce(np.concatenate([self._steps[None], steps**2]), axis=0)
        self._last = value[-1:].copy() if len(value) else self._last
        self.count, self._rows = self.count + int(usable.sum()), self._rows + len(value)

    @property
    def mean_square(self) -> Array:
        """(3,); zero where no row has it."""
        return np.asarray(self._squares / max(self.count, 1))

    @property
    def variance(self) -> Array:
        """(3,) over the rows that have it: from what each lies apart from the first."""
        mean, square = self._apart / max(self.count, 1)
        return np.asarray(np.maximum(square - mean**2, 0.0))

    @property
    def mean_square_step(self) -> Array:
        """Mean square (3,) of the change from row to row: what a row between two others may miss."""
        return np.asarray(self._steps / max(self._rows - 1, 1))
