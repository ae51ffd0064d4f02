"""A DUT that sends a line a sample: the twin's reading and the housekeeping that its column map asks for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.streaming import Talker, dut_rows


class CsvLineEmulator(Talker):
    """Sends from the moment it is powered, whether anybody listens or not."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        form = settings.delimiter.join(form_of(name) for name in settings.columns) + "\n"
        super().__init__(dut_rows(lab, settings.columns, settings), lambda t, row: (form % tuple(row)).encode())


def form_of(name: str) -> str:
    """How many decimals a column has."""
    return {"t": "%.3f", "x": "%.2f", "y": "%.2f", "z": "%.2f"}.get(name, "%.4f")
