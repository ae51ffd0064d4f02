"""A board with labcal's sketch: twenty lines a second of the chip's counts, or what keeps it from them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Lab
from drivers.emulators.streaming import Talker
from drivers.i2c_board import NUMBERS, sealed

RATE_HZ = 20.0
ENDS = {"rm3100": 8_388_607, "mmc5983": 262_143, "lis3mdl": 32_767, "qmc5883": 32_767, "bmm350": 8_388_607}


class I2cBoardEmulator(Talker):
    """`unplugged`: its chip does not answer."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._chip, self._number, self.unplugged = settings.chip, 0, False
        scale = np.array(settings.scale)
        super().__init__(lambda times: np.round(lab.dut_reading(times)[0] / scale), self._line, RATE_HZ)

    def _line(self, t_s: float, row: list[float]) -> bytes:
        number, self._number = self._number, (self._number + 1) % NUMBERS
        said = " ".join(f"{count:.0f}" for count in row)
        if self.unplugged:
            said = "none"
        elif max(map(abs, row)) >= ENDS[self._chip]:
            said = "full"
        return sealed(f"{number} {self._chip} {round(1000 * t_s) % 2**32} {said}")
