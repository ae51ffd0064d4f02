"""A reference that sends a line a sample: the twin's, in the order and unit of its column map."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Lab
from drivers.emulators.streaming import Talker
from drivers.framing.columns import NT


class TextLineEmulator(Talker):
    """Ten lines a second with four decimals."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        def rows(times: Any) -> Any:
            field = lab.reference_nT(times) * lab.reference_nT_per_unit / (settings.scale * NT[settings.unit])
            known = {"t": times, **dict(zip("xyz", field.T, strict=True)), "f": np.linalg.norm(field, axis=1)}
            return np.column_stack([known.get(name, np.zeros_like(times)) for name in settings.columns])

        def line(t_s: float, row: list[float]) -> bytes:
            text: str = settings.delimiter.join(f"{value:.4f}".replace(".", settings.decimal) for value in row)
            return (text + "\r\n").encode()

        super().__init__(rows, line)
