"""The column map: which number of a sample is what, in which unit, and when it was."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from drivers.framing.mishaps import Mishaps
from labcal.bench.driver_kit.roles import ChannelSpec
from labcal.record.run import Quantity
from labcal.record.stream import Block

Array = NDArray[np.float64]
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
DIGITS = re.compile(r"[0-9+\-.eE]+")
NEEDED = ("t", "x", "y", "z", "f")
EMPTY = ("", "nan", "NaN", "NAN")
NT = {"dut": 1.0, "nT": 1.0, "uT": 1e3, "mG": 100.0, "G": 1e5}
SECONDS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "iso": 1.0}
JUMP_S = 3600.0  # forward; a DUT's clock that jumps so far was set
QUANTITIES: dict[str, tuple[Quantity, str]] = {
    "i": ("current", "A"),
    "v": ("voltage", "V"),
    "temp": ("temperature", "degC"),
    "p": ("power", "W"),
}


class ColumnMap(Protocol):
    """What reading a row needs of the settings."""

    @property
    def columns(self) -> tuple[str, ...]:
        """What each number is."""
        ...

    @property
    def t_unit(self) -> str:
        """Unit of the column t."""
        ...


@dataclass(frozen=True, slots=True)
class Columns:
    """`columns`: x y z are the reading, t is the DUT's own clock [`t_unit`], "-" is skipped, all else housekeeping.

    `unit`: "dut" is the unit that [dut] states; another becomes nT. Readings are multiplied by `scale` first.
    `quantities` states quantity and unit of channels whose name does not (i_… A, v_… V, temp_… degC, p_… W).
    `stamp`: "host" takes the time of the first byte less `delay_s`, "device" the column t on the bench's clock.
    """

    columns: tuple[str, ...] = ("t", "x", "y", "z")
    unit: Literal["dut", "nT", "uT", "mG", "G"] = "dut"
    scale: float = 1.0
    t_unit: Literal["s", "ms", "us", "iso"] = "s"
    stamp: Literal["host", "device"] = "host"
    delay_s: float = 0.0
    quantities: dict[str, tuple[Quantity, str]] = field(default_factory=dict)
    serial: str = ""

    def __post_init__(self) -> None:
        needed = ("x", "y", "z", *(("t",) if self.stamp == "device" else ()))
        for name in {*needed, *self.columns} - {"-"}:
            if self.columns.count(name) != 1:
                raise ValueError(f"columns must have {name} once")
        if unknown := [c.name for c in channels(self) if not c.unit]:
            raise ValueError(f"quantities must state quantity and unit of {unknown[0]}")


def channels(settings: Columns) -> tuple[ChannelSpec, ...]:
    """The housekeeping of a column map; temp_coil… is the windings', all else the DUT's."""
    names = [c for c in settings.columns if c not in ("t", "x", "y", "z", "-")]
    unstated: tuple[Quantity, str] = ("other", "")
    stated = {n: settings.quantities.get(n) or QUANTITIES.get(n.split("_")[0], unstated) for n in names}
    return tuple(
        ChannelSpec(name, unit, quantity, "coil" if name.startswith("temp_coil") else "dut")
        for name, (quantity, unit) in stated.items()
    )


def number(text: str, decimal: str = ".") -> float | None:
    """A plain decimal number; NaN where it is empty or says so; None for all else (1_000, 0x10, inf, 1,5)."""
    text = text.strip(" \t")
    if text in EMPTY:
        return float("nan")
    plain = text if decimal == "." else text.replace(".", "?").replace(decimal, ".")
    return float(plain) if NUMBER.fullmatch(plain) else None


def numbers(parts: Sequence[str], settings: ColumnMap, decimal: str = ".") -> list[float] | None:
    """The row of one sample; None unless every column is a number and x, y, z and t are there and finite."""
    if len(parts) != len(settings.columns):
        return None
    if decimal == "." and settings.t_unit != "iso" and (plain := _all_plain(parts)) and "-" not in settings.columns:
        return plain
    row = [_cell(name, part, settings, decimal) for name, part in zip(settings.columns, parts, strict=True)]
    whole = [v for v in row if v is not None]
    return whole if len(whole) == len(row) and complete(whole, settings) else None


def _all_plain(parts: Sequence[str]) -> list[float] | None:
    """The row where every cell is a finite plain number and nothing else, as nearly always; None to look closer."""
    if DIGITS.fullmatch("".join(parts)) is None:
        return None
    try:
        row = [float(part) for part in parts]
    except ValueError:
        return None
    return row if all(map(math.isfinite, row)) else None


def complete(row: Sequence[float], settings: ColumnMap) -> bool:
    """Whether reading and time of a row are finite, and no cell is infinite."""
    needed = [v for name, v in zip(settings.columns, row, strict=True) if name in NEEDED]
    return bool(np.isfinite(needed).all() and not np.isinf(row).any())


def _cell(name: str, text: str, settings: ColumnMap, decimal: str) -> float | None:
    if name == "-":
        return 0.0
    if name == "t" and settings.t_unit == "iso":
        try:
            moment = datetime.fromisoformat(text.strip())
        except ValueError:
            return None
        return (moment if moment.tzinfo else moment.replace(tzinfo=UTC)).timestamp()
    return number(text, decimal)


class Table:
    """Rows of a column map on their way into blocks; stamped by the bench's clock."""

    def __init__(self, source: str, settings: Columns, mishaps: Mishaps) -> None:
        self._source, self._settings = source, settings
        self._reading = [settings.columns.index(axis) for axis in "xyz"]
        self._housekeeping = [(c.name, settings.columns.index(c.name)) for c in channels(settings)]
        self._clock = OwnClock(mishaps)

    def blocks(self, host_s: Sequence[float], rows: Sequence[Sequence[float]], raw: bytes) -> list[Block]:
        """One block of readings, and the housekeeping; `host_s` is when each row's first byte came."""
        if not rows:
            return []
        s, table = self._settings, np.array(rows)
        t = self._stamps(np.array(host_s), table)
        reading = table[:, self._reading] * (s.scale * NT[s.unit])
        return [Block("dut", self._source, ("dut_x", "dut_y", "dut_z"), t, reading, raw), *self._channels(t, table)]

    def _channels(self, t: Array, table: Array) -> list[Block]:
        """All housekeeping in one block; where a cell is empty, each channel by itself."""
        if not self._housekeeping:
            return []
        names, places = tuple(n for n, _ in self._housekeeping), [k for _, k in self._housekeeping]
        values = table[:, places]
        known = np.isfinite(values)
        if known.all():
            return [Block("channel", self._source, names, t, values)]
        return [
            Block("channel", self._source, (name,), t[known[:, k]], values[known[:, k], k : k + 1])
            for k, name in enumerate(names)
        ]

    def _stamps(self, host_s: Array, table: Array) -> Array:
        """The bench's time of each row."""
        s = self._settings
        if s.stamp == "host":
            return host_s - s.delay_s
        own_s = table[:, s.columns.index("t")] * SECONDS[s.t_unit]
        return self._clock.tie(host_s, own_s) - s.delay_s


class OwnClock:
    """The DUT's own clock on the bench's: tied by the sample that came the quickest of the first that came.

    Where that clock goes back, or far ahead, it was set or began again: it is tied anew, and that is reported.
    """

    def __init__(self, mishaps: Mishaps) -> None:
        self._mishaps = mishaps
        self._offset_s: float | None = None
        self._last_s = 0.0

    def tie(self, host_s: Array, own_s: Array) -> Array:
        """The bench's time of samples that arrived at `host_s` (n,) and are stamped `own_s` (n,)."""
        before = own_s[0] if self._offset_s is None else self._last_s
        steps = np.diff(own_s, prepend=before)
        anew = np.flatnonzero((steps < 0) | (steps > JUMP_S))
        tied = np.empty_like(own_s)
        for rows in np.split(np.arange(len(own_s)), anew):
            if len(rows):
                tied[rows] = own_s[rows] + self._tied_anew(host_s[rows], own_s[rows], bool(np.isin(rows[0], anew)))
        self._last_s = float(own_s[-1])
        return tied

    def _tied_anew(self, host_s: Array, own_s: Array, restarted: bool) -> float:
        if restarted:
            self._mishaps.note("restart", float(host_s[0]), 0)
        if restarted or self._offset_s is None:
            self._offset_s = float(np.min(host_s - own_s))
        return self._offset_s
