"""The frames of one vehicle out of a MAVLink stream: its readings and telemetry, as blocks."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from drivers.framing import mavlink
from drivers.framing.columns import OwnClock
from drivers.framing.listener import Pieces
from drivers.framing.mavlink import CHANNEL, NO_AUTOPILOT, NT, SENSOR, Vehicle, dialect
from drivers.framing.mishaps import Mishaps
from labcal.errors import InstrumentError
from labcal.record.stream import Block


@dataclass(frozen=True)
class Settings:
    """`message` holds the reading: SCALED_IMU… and HIGHRES_IMU become nT, RAW_IMU stays as it is sent; times `scale`.

    `system_id`: whose; 0 is the only vehicle that is heard, and two are refused. `instance`: HIGHRES_IMU's own id.
    `channels`: i_battery v_battery temp_battery i_battery_2… i_motor_1… rpm_1… pwm_1… temp_dut (the sensor's).
    `stamp`: "host" is the arrival less `delay_s`, "device" the message's own time; telemetry always has the host's.
    """

    message: Literal["RAW_IMU", "SCALED_IMU", "SCALED_IMU2", "SCALED_IMU3", "HIGHRES_IMU"] = "HIGHRES_IMU"
    system_id: int = 0
    component_id: int = 1
    instance: int = 0
    channels: tuple[str, ...] = ("i_battery", "v_battery")
    scale: float = 1.0
    stamp: Literal["host", "device"] = "host"
    delay_s: float = 0.0
    serial: str = ""

    def __post_init__(self) -> None:
        if not 0 <= self.system_id <= 255 or not 0 <= self.component_id <= 255:
            raise ValueError("system_id is 0 to 255 (0: the only one), component_id likewise")
        if wrong := [name for name in self.channels if not CHANNEL.fullmatch(name)]:
            raise ValueError(f"channels: {wrong[0]} is none that is known")

    @property
    def sensor(self) -> int:
        """Which magnetometer on board, from 0."""
        return SENSOR.get(self.message, self.instance)


class Parser:
    """Frames of MAVLink 1 and 2 in any cutting, into blocks. Raises InstrumentError where two vehicles are heard."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._source, self._settings, self._mishaps = source, settings, mishaps
        self._frames = dialect().MAVLink(None)
        self._frames.robust_parsing = True
        self._clock, self._begun_s, self._count = OwnClock(mishaps), 0.0, -1
        self.vehicle = Vehicle(settings.system_id)
        self.parameters: dict[str, float] = {}

    def feed(self, pieces: Pieces) -> list[Block]:
        """The blocks of the frames that these pieces complete [nT; RAW_IMU as it is sent]."""
        readings, raw, channels = list[tuple[float, ...]](), list[bytes](), list[Block]()
        for stamp, message in self._messages(pieces):
            if not self._ours(message):
                continue
            self._note(message, stamp)
            channels += self._channels(message, stamp)
            if (row := self._reading(message, stamp)) is not None:
                readings.append((stamp, *row))
                raw.append(bytes(message.get_msgbuf()))
        return [*self._block(readings, b"".join(raw)), *channels]

    def _messages(self, pieces: Pieces) -> list[tuple[float, Any]]:
        """Whole frames, each stamped by the piece in which it begins."""
        found = []
        for stamp, data in pieces:
            self._begun_s = self._begun_s if self._frames.buf_len() else stamp
            for message in self._frames.parse_buffer(data) or ():
                found.append((self._begun_s, message))
                self._begun_s = stamp
        return found

    def _ours(self, message: Any) -> bool:
        """Whether it is from the vehicle that is meant; the first that is heard, where none is stated."""
        kind, system, s = message.get_type(), message.get_srcSystem(), self._settings
        if kind == "BAD_DATA" or message.get_srcComponent() != s.component_id:
            return False
        if kind != s.message and not (kind == "HEARTBEAT" and message.autopilot != NO_AUTOPILOT):
            return bool(system == self.vehicle.system)
        if self.vehicle.system == 0:
            self.vehicle = Vehicle(system)
        if system != self.vehicle.system and s.system_id == 0:
            raise InstrumentError(
                f"{self._source}: two vehicles are heard, of system ids {self.vehicle.system} and {system}.",
                fault="another instrument",
                remedy="Switch one off, or state system_id in its settings in bench.toml.",
            )
        return bool(system == self.vehicle.system)

    def _note(self, message: Any, stamp: float) -> None:
        """Its count of messages, 0 to 255; heartbeat and parameters."""
        lost = (message.get_seq() - self._count - 1) % 256 if self._count >= 0 else 0
        self._count = message.get_seq()
        if lost:
            self._mishaps.note("gap", stamp, lost)
        if message.get_type() == "HEARTBEAT":
            self.vehicle = Vehicle(self.vehicle.system, message.autopilot)
        elif message.get_type() == "PARAM_VALUE":
            self.parameters.update([mavlink.parameter(message, self.vehicle)])

    def _reading(self, message: Any, stamp: float) -> tuple[float, ...] | None:
        if message.get_type() != self._settings.message:
            return None
        row = mavlink.reading(message, self._settings.instance)
        if row is not None and not all(map(math.isfinite, row)):
            self._mishaps.note("bad frame", stamp)
            return None
        return row

    def _channels(self, message: Any, stamp: float) -> list[Block]:
        fields = mavlink.telemetry(message) if self._is_telemetry(message) else {}
        known = {name: v for name, v in fields.items() if name in self._settings.channels and math.isfinite(v)}
        if not known:
            return []
        t, values = np.array([stamp - self._settings.delay_s]), np.array([list(known.values())])
        return [Block("channel", self._source, tuple(known), t, values)]

    def _is_telemetry(self, message: Any) -> bool:
        """Whether a temperature in it would be another sensor's."""
        return message.get_type() == self._settings.message or not hasattr(message, "xmag")

    def _block(self, readings: list[tuple[float, ...]], raw: bytes) -> list[Block]:
        if not readings:
            return []
        s, table = self._settings, np.array(readings)
        t = table[:, 0] if s.stamp == "host" else self._clock.tie(table[:, 0], table[:, 1])
        columns = ("dut_x", "dut_y", "dut_z")
        return [Block("dut", self._source, columns, t - s.delay_s, table[:, 2:] * (s.scale * NT[s.message]), raw)]
