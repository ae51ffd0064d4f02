"""A DUT that is published as sensor_msgs/MagneticField on a ROS 2 topic, over ros://DOMAIN/TOPIC."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from drivers.framing import ros
from drivers.framing.columns import OwnClock
from drivers.framing.listener import ParsedListener, Pieces
from drivers.framing.mishaps import Mishaps
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import ChannelSpec, Identity
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError
from labcal.record.stream import Block

NT_PER_T = 1e9


@dataclass(frozen=True, slots=True)
class Settings:
    """`frame`: the frame_id that its messages must state; "" takes any, as long as it stays the same.

    `stamp`: "host" is the arrival less `delay_s`, "device" the message's own header stamp on the bench's clock.
    `scale`: readings are multiplied by it, where a node publishes another unit than tesla.
    """

    frame: str = ""
    stamp: Literal["host", "device"] = "host"
    delay_s: float = 0.0
    scale: float = 1.0
    serial: str = ""


class Parser:
    """Messages as ros:// gives them, into blocks [nT]. Raises InstrumentError where another frame is stated."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._source, self._settings, self._mishaps = source, settings, mishaps
        self._clock, self._frame, self._last_s = OwnClock(mishaps), settings.frame, -math.inf

    def feed(self, pieces: Pieces) -> list[Block]:
        """The block of these messages."""
        good = [(stamp, whole, one) for stamp, whole, cdr in ros.messages(pieces) if (one := self._good(stamp, cdr))]
        if not good:
            return []
        s, t = self._settings, np.array([stamp for stamp, _, _ in good])
        if s.stamp == "device":
            t = self._clock.tie(t, np.array([one.stamp_s for _, _, one in good]))
        values = np.array([one.xyz_T for _, _, one in good]) * (NT_PER_T * s.scale)
        columns, raw = ("dut_x", "dut_y", "dut_z"), b"".join(whole for _, whole, _ in good)
        return [Block("dut", self._source, columns, t - s.delay_s, values, raw)]

    def _good(self, stamp: float, cdr: bytes) -> ros.Message | None:
        """The message; None, noted, where it is cut, no number, or the one before again."""
        message = ros.parse(cdr)
        if message is None or not all(map(math.isfinite, message.xyz_T)):
            self._mishaps.note("bad frame", stamp)
            return None
        self._frame = self._frame or message.frame
        if message.frame != self._frame:
            raise InstrumentError(
                f"{self._source}: a message of frame {quoted(message.frame)} came, not of {quoted(self._frame)}.",
                fault="another instrument",
                remedy="Do two nodes publish on this topic? State frame in its settings in bench.toml.",
            )
        if message.stamp_s == self._last_s and message.stamp_s:
            self._mishaps.note("late", stamp)
            return None
        self._last_s = message.stamp_s
        return message


class RosTopic(ParsedListener):
    """Best effort: what is lost on the way is not counted, for messages have no number."""

    roles = ("dut",)
    parser = Parser
    before = b""
    channels: tuple[ChannelSpec, ...] = ()

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        super().__init__(name, link, clock, settings, Identity("", "ROS 2 topic", settings.serial))
