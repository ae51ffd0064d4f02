"""A node that publishes its magnetometer, ten times a second, as ros:// hands its messages on."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.streaming import Talker, dut_rows
from drivers.framing import ros
from labcal.bench.links.rostopic import HEAD

T_PER_NT = 1e-9
BEGAN_S = 1_767_225_600.0  # its clock shows 2026 when it is switched on


class RosTopicEmulator(Talker):
    """The twin's reading in tesla, stamped by its own clock."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._frame_id = settings.frame or "imu_link"
        super().__init__(dut_rows(lab, ("x", "y", "z"), settings), self._message)

    def _message(self, t_s: float, row: list[float]) -> bytes:
        x, y, z = (T_PER_NT * one for one in row)
        cdr = ros.build(ros.Message(BEGAN_S + t_s, self._frame_id, (x, y, z)))
        return HEAD.pack(len(cdr)) + cdr
