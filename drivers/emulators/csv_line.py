"""A DUT that sends a line a sample: the twin's reading and the housekeeping that its column map asks for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Lab, Pieces
from drivers.emulators.streaming import Beat

RATE_HZ = 10.0


class CsvLineEmulator:
    """Sends from the moment it is powered, whether anybody listens or not."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._lab, self._settings, self._beat = lab, settings, Beat(RATE_HZ)

    def take(self, t_s: float, data: bytes) -> None:
        """It does not listen."""

    def emit(self, until_s: float) -> Pieces:
        """The lines that are due."""
        times = self._beat.due(until_s)
        if not len(times):
            return []
        reading, channels = self._lab.dut_reading(times)
        reading = reading / self._settings.scale
        known = {"t": times, "x": reading[:, 0], "y": reading[:, 1], "z": reading[:, 2], **channels}
        nothing = np.zeros_like(times)
        table = np.column_stack([known.get(name, nothing) for name in self._settings.columns])
        form = self._settings.delimiter.join(_form(name) for name in self._settings.columns) + "\n"
        lines = [(form % tuple(row)).encode() for row in table.tolist()]
        return list(zip(times.tolist(), lines, strict=True))


def _form(name: str) -> str:
    return {"t": "%.3f", "x": "%.2f", "y": "%.2f", "z": "%.2f"}.get(name, "%.4f")
