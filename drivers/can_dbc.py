"""A DUT on a CAN bus, its frames described by a DBC: the reading from one frame, housekeeping from any."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from drivers.framing.columns import NT, Columns, OwnClock, channels
from drivers.framing.dbc import FIELD_UNITS, Signal, database, found, frames
from drivers.framing.listener import ParsedListener, Pieces
from drivers.framing.mishaps import Mishaps
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link
from labcal.errors import InputError
from labcal.record.run import Quantity
from labcal.record.stream import Block

READING = ("x", "y", "z")


@dataclass(frozen=True, slots=True)
class Settings:
    """`file`: the DBC. `signals`: x, y and z as MESSAGE.SIGNAL of one message, and housekeeping by its names.

    There `t` is the DUT's own clock [s] and `count` a counter that wraps at its own width, both of that message.
    `unit`: "dut" is the unit that [dut] states; another becomes nT, and is refused where the DBC states a third.
    `quantities`, `stamp` and `delay_s` are those of `csv-line`.
    """

    file: str = ""
    signals: dict[str, str] = field(default_factory=dict)
    unit: Literal["dut", "nT", "uT", "mG", "G"] = "dut"
    scale: float = 1.0
    stamp: Literal["host", "device"] = "host"
    delay_s: float = 0.0
    quantities: dict[str, tuple[Quantity, str]] = field(default_factory=dict)
    serial: str = ""

    def __post_init__(self) -> None:
        if not self.file or not set(READING) <= set(self.signals):
            raise ValueError("file must name a DBC, and signals have x, y and z")
        if self.stamp == "device" and "t" not in self.signals:
            raise ValueError("signals must have t where stamp is device")
        self.housekeeping  # noqa: B018  a name without a unit is refused

    @property
    def housekeeping(self) -> Columns:
        """The names beside the reading, as a column map: it knows their quantities."""
        others = tuple(name for name in self.signals if name not in (*READING, "t", "count"))
        return Columns((*READING, *others), quantities=self.quantities)


class Parser:
    """Frames as can:// gives them, into blocks. Raises InputError where the DBC does not have what is stated."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._source, self._settings, self._mishaps = source, settings, mishaps
        self._messages = database(settings.file)
        self._signals = {name: found(settings.file, path) for name, path in settings.signals.items()}
        self._reading = _one_frame(settings, self._signals)
        self._frames = {signal.frame: signal.message for signal in self._signals.values()}
        self._clock, self._count = OwnClock(mishaps), -1

    def feed(self, pieces: Pieces) -> list[Block]:
        """The blocks of these frames."""
        stamps, rows, raw, of_channels = list[float](), list[list[float]](), list[bytes](), list[Block]()
        for stamp, number, frame, data in frames(pieces):
            if (values := self._decoded(stamp, number, data)) is None:
                continue
            of_channels += self._channels(stamp, number, values)
            if number == self._reading and self._counted(stamp, values):
                stamps.append(stamp)
                rows.append([values[name] for name in ("t", *READING) if name in values])
                raw.append(frame)
        return [*self._block(stamps, rows, b"".join(raw)), *of_channels]

    def _decoded(self, stamp: float, number: int, data: bytes) -> dict[str, float] | None:
        """The signals of a frame that are asked for; None for another's frame, or one that is no good."""
        if (message := self._frames.get(number)) is None:
            return None
        try:
            every = self._messages.decode_message(message, data, decode_choices=False)
            mine = {name: s for name, s in self._signals.items() if s.frame == number}
            values = {name: float(every[s.name]) for name, s in mine.items()}
        except Exception:  # cantools says in many ways that a frame is cut
            self._mishaps.note("bad frame", stamp)
            return None
        if not all(map(math.isfinite, values.values())):
            self._mishaps.note("bad frame", stamp)
            return None
        return values

    def _counted(self, stamp: float, values: dict[str, float]) -> bool:
        """Whether this frame is not the one before again; what its counter has passed over is noted."""
        if "count" not in values:
            return True
        before, self._count = self._count, int(values["count"])
        step = (self._count - before) % (1 << self._signals["count"].bits) if before >= 0 else 1
        if step != 1:
            self._mishaps.note("gap" if step else "late", stamp, max(step - 1, 1))
        return step != 0

    def _channels(self, stamp: float, number: int, values: dict[str, float]) -> list[Block]:
        known = {name: v for name, v in values.items() if name not in (*READING, "t", "count")}
        if not known:
            return []
        t, row = np.array([stamp - self._settings.delay_s]), np.array([list(known.values())])
        return [Block("channel", self._source, tuple(known), t, row)]

    def _block(self, stamps: list[float], rows: list[list[float]], raw: bytes) -> list[Block]:
        if not rows:
            return []
        s, table, t = self._settings, np.array(rows), np.array(stamps)
        if s.stamp == "device":
            t = self._clock.tie(t, table[:, 0])
        values = table[:, -3:] * (s.scale * NT[s.unit])
        return [Block("dut", self._source, ("dut_x", "dut_y", "dut_z"), t - s.delay_s, values, raw)]


class CanDbc(ParsedListener):
    """Frames that the DBC cannot decode give no value and are reported, and so is each gap in `count`."""

    roles = ("dut",)
    parser = Parser
    before = b""

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.channels = channels(settings.housekeeping)
        model = f"CAN {settings.signals['x'].partition('.')[0]}"
        who = Identity("", model, settings.serial)
        super().__init__(name, link, clock, settings, who)


def _one_frame(settings: Settings, signals: dict[str, Signal]) -> int:
    """The frame of the reading. Raises InputError where x, y, z, t and count are not of one, or the unit is another."""
    of_one: dict[str, Any] = {name: s for name, s in signals.items() if name in (*READING, "t", "count")}
    if len({signal.frame for signal in of_one.values()}) != 1:
        raise InputError(f"{', '.join(of_one)} must be signals of one message", file=settings.file)
    units = {FIELD_UNITS[s.unit] for name, s in of_one.items() if name in READING and s.unit in FIELD_UNITS}
    if settings.unit != "dut" and units - {settings.unit}:
        raise InputError(f"says that x is in {units.pop()}, and unit = {settings.unit!r}", file=settings.file)
    return int(signals["x"].frame)
