"""What every instrument of a run has read last, and when that came by the computer's monotonic clock. No widgets."""

from __future__ import annotations

import time

import numpy as np
from numpy.typing import NDArray

from labcal.record.stream import Block


class LastReadings:
    """By instrument: columns with values, in the units of the stream, and since when they are here [s]."""

    def __init__(self) -> None:
        self.values: dict[str, tuple[tuple[str, ...], NDArray[np.float64]]] = {}
        self.read_s: dict[str, float] = {}
        self._sends_more: set[str] = set()  # of which channels are not the main thing

    def take(self, block: Block, seen_s: float) -> None:
        """The last row of `block`; `seen_s`: the stamp of what came last. What waited came late."""
        if block.stream != "channel":
            self._sends_more.add(block.source)
        elif block.source in self._sends_more:
            return
        self.values[block.source] = block.columns, block.values[-1]
        self.read_s[block.source] = time.monotonic() - (seen_s - float(block.t_s[-1]))
