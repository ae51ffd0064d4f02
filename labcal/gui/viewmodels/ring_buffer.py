"""The last samples of a stream, for live traces: a fixed buffer that plots pull from on a timer."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class RingBuffer:
    """Holds the newest `size` rows of (t, k values); writing is O(new rows), reading gives them in order."""

    def __init__(self, columns: int, size: int = 10_000) -> None:
        self._rows = np.empty((size, 1 + columns))
        self.written = 0

    def __len__(self) -> int:
        return min(self.written, len(self._rows))

    def push(self, t_s: Array, values: Array) -> None:
        """Append rows: `t_s` (n,), `values` (n, k)."""
        new = np.column_stack([t_s, values])[-len(self._rows) :]
        self._rows[(self.written + np.arange(len(new))) % len(self._rows)] = new
        self.written += len(new)

    def rows(self) -> Array:
        """What it holds, oldest first, (n, 1 + k)."""
        if self.written <= len(self._rows):
            return self._rows[: self.written]
        start = self.written % len(self._rows)
        return np.concatenate([self._rows[start:], self._rows[:start]])

    def clear(self) -> None:
        """Forget everything."""
        self.written = 0
