"""What a reader gives: the streams of a foreign file, each a table of columns, and what the file says besides."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.files.text_safety import one_line
from labcal.store.limits import listed, shortened

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class WantedColumns:
    """The columns of one stream that somebody asked for; a reader need not keep any other."""

    numbers: frozenset[str] = frozenset()
    texts: frozenset[str] = frozenset()

    def __or__(self, other: WantedColumns) -> WantedColumns:
        return WantedColumns(self.numbers | other.numbers, self.texts | other.texts)


@dataclass(frozen=True, slots=True)
class CsvForm:
    """How a text table is written; None is "look at it"."""

    delimiter: str | None = None
    decimal: str = "."
    header: bool | None = None
    skip_lines: int = 0
    comment: str = "#"
    missing: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ReadRequest:
    """What a reader is asked for: columns by stream, or all of them (None), from at most `most_rows` rows."""

    wanted: Mapping[str, WantedColumns] | None = None
    form: CsvForm = CsvForm()
    most_rows: int | None = None

    def of(self, stream: str) -> WantedColumns | None:
        """The columns wanted of `stream`; None where all are."""
        return None if self.wanted is None else self.wanted.get(stream, WantedColumns())


@dataclass(frozen=True, slots=True, eq=False)
class Stream:
    """A table of columns that share one clock; NaN is a missing value. `lines` are the rows' lines in a text file."""

    name: str
    file: Path
    numbers: Mapping[str, Array]
    texts: Mapping[str, Sequence[str]] = field(default_factory=dict)
    lines: NDArray[np.intp] | None = None

    def number(self, column: str) -> Array:
        """The column (n,). Raises InputError with the columns there are."""
        if column in self.numbers:
            return self.numbers[column]
        if column in self.texts:
            raise self.fault("holds texts, not numbers", 0, column)
        raise self._missing(column)

    def text(self, column: str) -> Sequence[str]:
        """The cells of a text column (n,). Raises InputError with the columns there are."""
        if column in self.texts:
            return self.texts[column]
        if column in self.numbers:
            return [f"{value:g}" for value in self.numbers[column]]
        raise self._missing(column)

    def together(self, names: Sequence[str]) -> Array:
        """Columns side by side (n, k). Raises InputError where they differ in length."""
        columns = [self.number(name) for name in names]
        for name, column in zip(names, columns, strict=True):
            if len(column) != len(columns[0]):
                what = f"has {len(column)} values, {names[0]} has {len(columns[0])}: they are not of one clock"
                raise InputError(what, file=self.file, column=shortened(name))
        return np.stack(columns, axis=1)

    def fault(self, what: str, row: int, column: str) -> InputError:
        """The error that says `what` is wrong in one row of a column."""
        line = None if self.lines is None or row >= len(self.lines) else int(self.lines[row])
        where = f"row {row + 1} of {self.name}: " if line is None and self.name else ""
        return InputError(f"{where}{what}", file=self.file, line=line, column=shortened(column))

    def _missing(self, column: str) -> InputError:
        there = listed([*self.numbers, *self.texts]) or "none"
        of = f" of {self.name}" if self.name else ""
        return InputError(f"there is no such column{of}; it has {there}", file=self.file, column=shortened(column))


@dataclass(frozen=True, slots=True)
class ForeignRecording:
    """One foreign file: its streams by name, when it began (UTC, where it says so), and what belongs in the notes."""

    file: Path
    streams: Mapping[str, Stream]
    started_utc: str | None = None
    notes: tuple[str, ...] = ()

    def stream(self, name: str) -> Stream:
        """The stream called `name`; "" is the only one. Raises InputError with those there are."""
        if name in self.streams:
            return self.streams[name]
        if not name and len(self.streams) == 1:
            return next(iter(self.streams.values()))
        what = f"there is no stream {shortened(name)!r}" if name else "the mapping must name a stream"
        raise InputError(f"{what}; there are {listed(sorted(self.streams), 40) or 'none'}", file=self.file)


def unreadable(what: str, error: Exception, file: Path) -> InputError:
    """The error that says that a library could not read a file, in one line of its own words."""
    return InputError(f"{what} ({shortened(one_line(f'{type(error).__name__}: {error}'), 160)})", file=file)


def strictly_known(names: Collection[str], most: int, what: str, file: Path) -> None:
    """Raise InputError where there are more `names` than any recording has."""
    if len(names) > most:
        raise InputError(f"{len(names)} {what} are more than {most}, which no recording has", file=file)
