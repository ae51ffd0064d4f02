"""A DUT that sends one line of text a sample: numbers between delimiters, in the order of a column map."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import isfinite
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.clock import Clock
from labcal.bench.frames import Lines
from labcal.bench.links import Link
from labcal.bench.roles import ChannelSpec, Identity
from labcal.errors import InstrumentError
from labcal.record.run import Quantity
from labcal.record.stream import Block

Array = NDArray[np.float64]
READING = ("dut_x", "dut_y", "dut_z")
QUANTITIES: dict[str, tuple[Quantity, str]] = {
    "i": ("current", "A"),
    "v": ("voltage", "V"),
    "temp": ("temperature", "degC"),
    "p": ("power", "W"),
}


@dataclass(frozen=True, slots=True)
class Settings:
    """`columns`: x y z are the reading, t is the DUT's own clock [`t_unit`], "-" is skipped, all else housekeeping.

    `quantities` states quantity and unit of channels whose name does not (i_… A, v_… V, temp_… degC, p_… W).
    `stamp`: "host" takes the time of the first byte less `delay_s`, "device" the column t on the bench's clock.
    """

    columns: tuple[str, ...] = ("t", "x", "y", "z")
    delimiter: str = ","
    comment: str = "#"
    scale: float = 1.0
    t_unit: Literal["s", "ms"] = "s"
    stamp: Literal["host", "device"] = "host"
    delay_s: float = 0.0
    quantities: dict[str, tuple[Quantity, str]] = field(default_factory=dict)
    serial: str = ""

    def __post_init__(self) -> None:
        for name in ("x", "y", "z", *(("t",) if self.stamp == "device" else ())):
            if self.columns.count(name) != 1:
                raise ValueError(f"columns must have {name} once")
        if unknown := [c.name for c in _channels(self) if not c.unit]:
            raise ValueError(f"quantities must state quantity and unit of {unknown[0]}")


class CsvLine:
    """Lines that are not numbers (headers, comments, cut or noisy lines) are dropped and counted in `dropped`."""

    roles = ("dut",)
    never = (rb".",)  # it is only listened to

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self.channels = _channels(settings)
        self.dropped = 0
        self._lines = Lines(skip_first=True)
        self._offset_s: float | None = None
        where = settings.columns.index
        self._reading = [where(axis) for axis in "xyz"]
        self._housekeeping = [where(c.name) for c in self.channels]

    def identify(self) -> Identity:
        """A line of text has no name: wait for one good line and answer with what bench.toml states."""
        lines, deadline = Lines(skip_first=True), self._clock.now() + 3.0
        while self._clock.now() < deadline:
            for _, line in lines.feed(self._link.receive(self._clock.now() + 0.05)):
                if self._numbers(line) is not None:
                    return Identity("", "text line", self.settings.serial)
        raise InstrumentError(
            f"{self.name}: no line of {len(self.settings.columns)} numbers came in 3 s.",
            fault="silent",
            remedy="Is the DUT powered and sending? Do columns and delimiter in bench.toml fit its lines?",
        )

    def start(self) -> None:
        """Begin: what arrived before is dropped, and so is the first line, which may be cut."""
        self._link.flush()
        self._lines, self._offset_s, self.dropped = Lines(skip_first=True), None, 0

    def read_until(self, t_s: float) -> list[Block]:
        """Readings and housekeeping that arrived up to `t_s`."""
        stamps, rows, raw = [], [], []
        for stamp, line in self._lines.feed(self._link.receive(t_s)):
            if (row := self._numbers(line)) is not None:
                stamps.append(stamp)
                rows.append(row)
                raw.append(line)
        if not rows:
            return []
        table = np.array(rows)
        t = self._stamps(np.array(stamps), table)
        blocks = [Block("dut", self.name, READING, t, table[:, self._reading] * self.settings.scale, b"\n".join(raw))]
        if self._housekeeping:
            names = tuple(c.name for c in self.channels)
            blocks.append(Block("channel", self.name, names, t, table[:, self._housekeeping]))
        return blocks

    def stop(self) -> None:
        """Stop listening; the DUT goes on."""

    def make_safe(self) -> None:
        """A listener has nothing to make safe."""

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _numbers(self, line: bytes) -> list[float] | None:
        """The numbers of one line; None, counted, where it is none."""
        text = line.strip(b"\r\n \0").decode("ascii", "replace")
        if not text or text.startswith(self.settings.comment):
            return None
        parts = text.split(self.settings.delimiter)
        try:
            if len(parts) == len(self.settings.columns):
                row = [float(p) if name != "-" else 0.0 for name, p in zip(self.settings.columns, parts, strict=True)]
                if all(map(isfinite, row)):
                    return row
        except ValueError:
            pass
        self.dropped += 1
        return None

    def _stamps(self, host_s: Array, table: Array) -> Array:
        """The bench's time of each row; the DUT's own clock is set once, by the line that came the quickest."""
        if self.settings.stamp == "host":
            return host_s - self.settings.delay_s
        own_s = table[:, self.settings.columns.index("t")] * (1e-3 if self.settings.t_unit == "ms" else 1.0)
        if self._offset_s is None:
            self._offset_s = float(np.min(host_s - own_s))
        return np.asarray(own_s + self._offset_s - self.settings.delay_s)


def _channels(settings: Settings) -> tuple[ChannelSpec, ...]:
    names = [c for c in settings.columns if c not in ("t", "x", "y", "z", "-")]
    unstated: tuple[Quantity, str] = ("other", "")
    stated = {n: settings.quantities.get(n) or QUANTITIES.get(n.split("_")[0], unstated) for n in names}
    return tuple(ChannelSpec(name, unit, quantity) for name, (quantity, unit) in stated.items())
