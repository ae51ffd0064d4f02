"""Stamps of a foreign stream as seconds that grow, on the run's clock."""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.importers.mapping import ColumnSource, TimePart
from labcal.importers.recording import Stream
from labcal.importers.units import s_OF

Array = NDArray[np.float64]

FIRST_DATE_S, LAST_DATE_S = 1e9, 4e9  # 2001 and 2096: stamps between are seconds since 1970, UTC
DAY_FIRST = re.compile(r"(\d{1,2})\.(\d{1,2})\.(\d{4}) +(\d\d:\d\d(?::\d\d(?:[.,]\d+)?)?)")  # written with dots
WORDS = {"duplicates": "the same time as", "backward": "an earlier time than"}


@dataclass(frozen=True, slots=True, eq=False)
class Stamps:
    """Times (n,) [s] that grow, and the rows (n,) of the stream that they belong to."""

    t_s: Array
    rows: NDArray[np.intp]


def clock_of(group: ColumnSource, time: TimePart) -> tuple[str, str] | None:
    """The column of a group's stamps, and their unit; None where its rows have none, but a rate."""
    column, unit = group.time or time.column, group.time_unit or time.unit
    return None if column is None else (column, unit or "s")


def stamps_of(stream: Stream, group: ColumnSource, time: TimePart, of: str) -> Stamps:
    """The clock of a group, or its rate: as many as the column `of` has values.

    Raises InputError for a missing stamp, and for stamps that do not grow unless dropped.
    """
    if (clock := clock_of(group, time)) is None:
        rows = np.arange(len(stream.number(of)))
        return Stamps(rows / (time.rate_Hz or 1.0) * (1 + group.clock_rate_ppm * 1e-6) + group.clock_offset_s, rows)
    column, unit = clock
    raw = _seconds(stream, column, unit)
    if (missing := np.flatnonzero(~np.isfinite(raw))).size:
        raise stream.fault("expected a time, found none", int(missing[0]), column)
    rows = np.arange(len(raw))
    rows = _growing(raw, rows, stream, column, "backward", time.backward)
    rows = _growing(raw, rows, stream, column, "duplicates", time.duplicates)
    return Stamps(raw[rows] * (1 + group.clock_rate_ppm * 1e-6) + group.clock_offset_s, rows)


def is_date(t_s: float) -> bool:
    """Whether a stamp [s] counts from 1970."""
    return FIRST_DATE_S <= t_s <= LAST_DATE_S


def utc(t_s: float) -> str:
    """A stamp that counts from 1970 as ISO 8601, in whole seconds."""
    return datetime.fromtimestamp(t_s, UTC).isoformat(timespec="seconds").replace("+00:00", "Z")


def _seconds(stream: Stream, column: str, unit: str) -> Array:
    if unit != "iso":
        return stream.number(column) * s_OF[unit]
    cells = stream.text(column)
    return np.array([_moment(cell, row, stream, column) for row, cell in enumerate(cells)])


def _moment(cell: str, row: int, stream: Stream, column: str) -> float:
    """A date and time as seconds since 1970; one that states no zone is UTC."""
    if dotted := DAY_FIRST.fullmatch(cell):
        cell = f"{dotted[3]}-{int(dotted[2]):02d}-{int(dotted[1]):02d}T{dotted[4]}"
    try:
        found = datetime.fromisoformat(cell)
    except ValueError:
        raise stream.fault(
            f"expected a date and time in ISO 8601, or 31.12.2026 23:59:59, found {cell[:40]!r}", row, column
        ) from None
    return (found if found.tzinfo else found.replace(tzinfo=UTC)).timestamp()


def _growing(
    t: Array,
    rows: NDArray[np.intp],
    stream: Stream,
    column: str,
    fault: Literal["duplicates", "backward"],
    what_to_do: Literal["refuse", "drop"],
) -> NDArray[np.intp]:
    """The rows without those whose stamp is (`backward`) before, or (`duplicates`) at, the latest so far."""
    latest = np.maximum.accumulate(np.concatenate([[-np.inf], t[rows][:-1]]))
    wrong = t[rows] < latest if fault == "backward" else t[rows] == latest
    if not wrong.any():
        return rows
    if what_to_do == "refuse":
        place = int(np.flatnonzero(wrong)[0])
        seen = f"found {WORDS[fault]} a row before ({t[rows][place]:.9g} s), in {int(wrong.sum())} of {len(rows)} rows"
        raise stream.fault(f'{seen}; {fault} = "drop" under [time] leaves these out', int(rows[place]), column)
    if wrong.sum() * 2 > len(rows):
        raise InputError(f"more than half of its times do not grow: {column} is no clock", file=stream.file)
    return rows[~wrong]
