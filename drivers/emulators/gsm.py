"""A GSM-90 that sends time, field and quality; out of its range it finds no signal, and says so by its quality."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Lab
from drivers.emulators.streaming import Talker

LEAST_nT, MOST_nT = 20_000.0, 120_000.0


class GsmEmulator(Talker):
    """A reading each `period_s`, with two decimals."""

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        def rows(times: Any) -> Any:
            field = lab.reference_nT(times - settings.delay_s) * lab.reference_nT_per_unit
            return np.linalg.norm(field, axis=1, keepdims=True)

        super().__init__(rows, _line, 1 / settings.period_s)


def _line(t_s: float, row: list[float]) -> bytes:
    seconds = int(t_s) % 86_400
    clock = f"{seconds // 3600:02d}{seconds // 60 % 60:02d}{seconds % 60:02d}.0"
    quality = 99 if LEAST_nT <= row[0] <= MOST_nT else 0
    return f"{clock} {row[0]:9.2f} {quality:02d}\r\n".encode()
