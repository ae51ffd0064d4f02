"""An RM3100 bridge: whole counts, ten lines a second."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Lab
from drivers.emulators.streaming import Talker


class Rm3100Emulator(Talker):
    """`x,y,z` and CR LF."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        scale = lab.reference_nT_per_unit / settings.nT_per_count
        super().__init__(
            lambda times: np.round(lab.reference_nT(times) * scale),
            lambda t, row: (",".join(f"{count:.0f}" for count in row) + "\r\n").encode(),
        )
