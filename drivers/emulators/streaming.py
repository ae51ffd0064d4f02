"""Samples on a steady beat: which moments have come since the last look."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from drivers.emulators.line import Lab, Pieces

RATE_HZ = 10.0


class SampleClock:
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

    def next_s(self) -> float:
        """The first that was not given."""
        return self._next / self._rate


class Talker:
    """Sends `rows(t_s)` as frames from the moment it is powered, whether anybody listens or not."""

    def __init__(
        self,
        rows: Callable[[NDArray[np.float64]], NDArray[np.float64]],
        frame: Callable[[float, list[float]], bytes],
        rate_hz: float = RATE_HZ,
    ) -> None:
        self._rows, self._frame, self._beat = rows, frame, SampleClock(rate_hz)

    def take(self, t_s: float, data: bytes) -> None:
        """It does not listen."""

    def due_s(self) -> float:
        """When it sends next."""
        return self._beat.next_s()

    def emit(self, until_s: float) -> Pieces:
        """The frames that are due."""
        times = self._beat.due(until_s)
        if not len(times):
            return []
        return [(t, self._frame(t, row)) for t, row in zip(times.tolist(), self._rows(times).tolist(), strict=True)]


def dut_rows(lab: Lab, columns: Sequence[str], settings: Any) -> Callable[[Any], Any]:
    """The twin's reading and housekeeping in the order of a column map, in the DUT's own unit over `scale`."""

    def rows(times: Any) -> Any:
        reading, channels = lab.dut_reading(times)
        reading = reading / settings.scale
        known = {"t": times, "x": reading[:, 0], "y": reading[:, 1], "z": reading[:, 2], **channels}
        return np.column_stack([known.get(name, np.zeros_like(times)) for name in columns])

    return rows
