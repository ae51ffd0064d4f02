"""An observatory that sends a row of IAGA-2002 each `period_s`, its head first."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime, timedelta
from typing import Any

import numpy as np

from drivers.emulators.line import Lab, Pieces
from drivers.emulators.streaming import Talker

BEGAN = datetime(2026, 1, 1, tzinfo=UTC)


class IagaEmulator(Talker):
    """A row leaves `delay_s` after the moment that it names. What is none of X, Y, Z, H, D and F is not recorded."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._head = _head(settings.station or "LAB", settings.elements, settings.period_s).encode()

        def rows(times: Any) -> Any:
            x, y, z = (lab.reference_nT(times - settings.delay_s) * lab.reference_nT_per_unit).T
            known = {"X": x, "Y": y, "Z": z, "H": np.hypot(x, y), "D": np.degrees(np.arctan2(y, x)) * 60}
            known["F"] = np.sqrt(x**2 + y**2 + z**2)
            return np.column_stack([known.get(e, np.full_like(times, 88_888.0)) for e in settings.elements])

        def line(t_s: float, row: list[float]) -> bytes:
            moment = BEGAN + timedelta(seconds=t_s - settings.delay_s)
            when = f"{moment:%Y-%m-%d %H:%M:%S}.{moment.microsecond // 1000:03d} {moment:%j}"
            return (when + "   " + "".join(f" {value:9.2f}" for value in row) + "\n").encode()

        super().__init__(rows, line, 1 / settings.period_s)

    def emit(self, until_s: float) -> Pieces:
        """The rows that are due, the head before the first."""
        pieces = super().emit(until_s)
        if pieces and self._head:
            pieces[0], self._head = (pieces[0][0], self._head + pieces[0][1]), b""
        return pieces


def _head(station: str, elements: str, period_s: float) -> str:
    """Its twelve records, each of 70 letters, and the line that names the columns."""
    records = (
        ("Format", "IAGA-2002"), ("Source of Data", "emulated"), ("Station Name", "Laboratory"), ("IAGA CODE", station),
        ("Geodetic Latitude", "48.000"), ("Geodetic Longitude", "11.000"), ("Elevation", "500"),
        ("Reported", elements), ("Sensor Orientation", elements[:3]), ("Digital Sampling", f"{period_s:g} second"),
        ("Data Interval Type", f"{period_s:g}-second"), ("Data Type", "variation"),
    )  # fmt: skip
    names = "".join(f"{station + element:<10}" for element in elements)
    lines = [f" {label:<23}{value:<45}|" for label, value in records]
    return "\n".join([*lines, f"DATE       TIME         DOY     {names}|", ""])
