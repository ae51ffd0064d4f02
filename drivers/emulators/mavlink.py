"""A vehicle that speaks MAVLink, by pymavlink's own encoder: heartbeat, battery, magnetometer, parameters."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab, Pieces, Replies
from drivers.emulators.streaming import SampleClock, dut_rows
from drivers.framing.mavlink import INT32, NT, PX4, Vehicle, calibration_names, dialect

RATE_HZ = 20.0
XYZ = ("x", "y", "z", "i_payload")


class MavlinkEmulator:
    """System 1, a PX4; its readings are the twin's, and `CAL_MAGn_…` are zero but the scales."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._settings, self._dialect = settings, dialect()
        self._out = self._dialect.MAVLink(None, settings.system_id or 1, settings.component_id)
        self._in = self._dialect.MAVLink(None)
        self._in.robust_parsing = True
        self._scale = settings.scale * NT[settings.message]
        self._rows, self._beat, self._replies = _rows(lab, self._scale), SampleClock(RATE_HZ), Replies()
        names = calibration_names(Vehicle(1, PX4), settings.sensor)
        self.parameters = {name: 1.0 if "SCALE" in name else 0.0 for name in names}

    def take(self, t_s: float, data: bytes) -> None:
        """Answers a question for a parameter that it has."""
        for message in self._in.parse_buffer(data) or ():
            if message.get_type() == "PARAM_REQUEST_READ" and message.target_system == self._out.srcSystem:
                self._parameter(t_s, str(message.param_id).rstrip("\0"))

    def due_s(self) -> float:
        """When it sends next."""
        return min(self._beat.next_s(), self._replies.due_s())

    def emit(self, until_s: float) -> Pieces:
        """Frames that are due."""
        times = self._beat.due(until_s)
        said = self._replies.emit(until_s)
        if len(times):
            said += [
                (t, self._frames(t, row)) for t, row in zip(times.tolist(), self._rows(times).tolist(), strict=True)
            ]
        return sorted(said)

    def _parameter(self, t_s: float, name: str) -> None:
        if name not in self.parameters:
            return
        value, whole = self.parameters[name], name.endswith(("_ID", "_ROT"))
        sent = struct.unpack("<f", struct.pack("<i", int(value)))[0] if whole else value
        kind = INT32 if whole else self._dialect.MAV_PARAM_TYPE_REAL32
        answer = self._dialect.MAVLink_param_value_message(name.encode(), sent, kind, len(self.parameters), 0)
        self._replies.say(t_s + 0.02, self._packed(answer))

    def _frames(self, t_s: float, row: list[float]) -> bytes:
        number = round(t_s * RATE_HZ)
        out = self._reading(t_s, row[:3])
        if number % 4 == 0:
            out += self._packed(self._battery(row[3]))
        if number % 20 == 0:
            out += self._packed(self._dialect.MAVLink_heartbeat_message(2, PX4, 0, 0, 3, 3))
        return out

    def _battery(self, current_A: float) -> Any:
        zeros = (0,) * 6
        return self._dialect.MAVLink_sys_status_message(0, 0, 0, 500, 12_000, round(100 * current_A), 90, *zeros)

    def _reading(self, t_s: float, xyz: list[float]) -> bytes:
        kind, m = self._settings.message, self._dialect
        if kind == "HIGHRES_IMU":
            rest = (1013.0, 0.0, 0.0, 25.0, 0x1FFF, self._settings.instance)
            return self._packed(m.MAVLink_highres_imu_message(round(t_s * 1e6), *(0.0,) * 6, *xyz, *rest))
        counts = [max(-32768, min(32767, round(v))) for v in xyz]
        if kind == "RAW_IMU":
            return self._packed(m.MAVLink_raw_imu_message(round(t_s * 1e6), *(0,) * 6, *counts, 0, 2500))
        made = getattr(m, f"MAVLink_{kind.lower()}_message")
        return self._packed(made(round(t_s * 1e3), *(0,) * 6, *counts, 2500))

    def _packed(self, message: Any) -> bytes:
        frame = bytes(message.pack(self._out))
        self._out.seq = (self._out.seq + 1) % 256
        return frame


def _rows(lab: Lab, scale: float) -> Any:
    class Scaled:
        """What the rows need of the settings."""

        def __init__(self) -> None:
            self.scale = scale

    return dut_rows(lab, XYZ, Scaled())
