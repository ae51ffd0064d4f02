"""A strict reader of comma-separated tables: every fault with its file, line and column.

A line end always ends a row. LF and CRLF are read alike, and so is a byte order mark before the header.
"""

from __future__ import annotations

import csv
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError

Array = NDArray[np.float64]
Rows = list[list[str]]

NUMBER_TEXT = frozenset("0123456789+-.eE")
LARGEST = 1e30  # a larger number is no measurement, and its square would be none at all
ROWS_AT_ONCE = 50_000


@dataclass(frozen=True, slots=True, eq=False)
class Table:
    """A table as it stood, and those of its columns that were asked for. Row i is line i + 2 of the file."""

    file: str
    header: tuple[str, ...]
    header_line: str
    lines: Sequence[str]  # (n,) each row's own text, without its line end
    numbers: Mapping[str, Array]  # (n,) each, NaN where the cell is empty
    texts: Mapping[str, Sequence[str]]  # (n,) each

    def __len__(self) -> int:
        return len(self.lines)

    def fault(self, what: str, row: int, column: str) -> InputError:
        """The error that says `what` is wrong in one cell."""
        return InputError(what, file=self.file, line=row + 2, column=column)


def read_table(
    data: bytes,
    *,
    file: object,
    numbers: Collection[str],
    texts: Collection[str] = (),
    required: Collection[str] = (),
    must_end: bool = False,
) -> Table:
    """Read those of the columns `numbers` and `texts` that are there; the others are kept in `lines` alone.

    `required` columns must be there. With `must_end` a last line without a line end counts as cut off, since a
    number that lost its last digits looks like any other. Raises InputError at the first fault.
    """
    name = str(file)
    header_line, lines = _lines(decode(data, file=name), name, must_end)
    header = _header(header_line, name, required)
    reader = _Reader(name, header, frozenset(numbers), frozenset(texts))
    chunks = [reader.read(lines[i : i + ROWS_AT_ONCE], i + 2) for i in range(0, max(len(lines), 1), ROWS_AT_ONCE)]
    return Table(
        name,
        header,
        header_line,
        lines,
        {c: np.concatenate([chunk[0][c] for chunk in chunks]) for c in chunks[0][0]},
        {c: [cell for chunk in chunks for cell in chunk[1][c]] for c in chunks[0][1]},
    )


def require_increasing(table: Table, column: str = "t_s") -> None:
    """Raise InputError at the first row whose `column` is empty or not after the row before."""
    values = table.numbers[column]
    if (missing := np.flatnonzero(np.isnan(values))).size:
        raise table.fault("expected a time, found an empty cell", int(missing[0]), column)
    if (wrong := np.flatnonzero(np.diff(values) <= 0)).size:
        row = int(wrong[0]) + 1
        word = "the same time as" if values[row] == values[row - 1] else "an earlier time than"
        raise table.fault(f"found {word} the row before ({values[row]} s); time must grow", row, column)


def decode(data: bytes, *, file: str) -> str:
    """UTF-8 text, without a byte order mark. Raises InputError with the line of the first wrong byte."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise InputError(f"expected UTF-8 text, found byte 0x{data[error.start]:02x}", file=file, line=line) from None


def _lines(text: str, file: str, must_end: bool) -> tuple[str, list[str]]:
    """The header line and the rows, without line ends and without empty lines at the end."""
    lines = text.replace("\r\n", "\n").split("\n")
    if must_end and lines[-1]:
        raise InputError("the last line has no line end: the file looks cut off", file=file, line=len(lines))
    while lines and not lines[-1]:
        lines.pop()
    if not lines:
        raise InputError("expected a header row, found an empty file", file=file, line=1)
    return lines[0], lines[1:]


def _header(line: str, file: str, required: Collection[str]) -> tuple[str, ...]:
    (header,) = _split([line], file, 1)
    for number, name in enumerate(header, 1):
        if not name:
            raise InputError("expected a column name, found nothing", file=file, line=1, column=number)
        if name in header[: number - 1]:
            raise InputError("the column is there twice", file=file, line=1, column=name)
    for name in required:
        if name not in header:
            raise InputError(f"the column is missing; the header has {', '.join(header)}", file=file, column=name)
    return tuple(header)


def _split(lines: list[str], file: str, first_line: int) -> Rows:
    if not any('"' in line for line in lines):
        return [line.split(",") for line in lines]
    reader = csv.reader(lines, strict=True)
    rows, taken = [], [0]
    try:
        for row in reader:
            rows.append(row or [""])
            taken.append(reader.line_num)
    except csv.Error as error:
        raise InputError(f"not a comma-separated row: {error}", file=file, line=first_line + taken[-1]) from None
    for before, after in pairwise(taken):
        if after != before + 1:
            raise InputError("a quoted cell runs over a line end", file=file, line=first_line + before)
    return rows


@dataclass(frozen=True, slots=True)
class _Reader:
    file: str
    header: tuple[str, ...]
    numbers: frozenset[str]
    texts: frozenset[str]

    def read(self, lines: list[str], first_line: int) -> tuple[dict[str, Array], dict[str, Sequence[str]]]:
        """Columns of some rows: fast as long as nothing is wrong, then once more with care to say where."""
        rows = _split(lines, self.file, first_line)
        if any(len(row) != len(self.header) for row in rows):
            raise self._fault(rows, first_line)
        columns: Sequence[Sequence[str]] = list(zip(*rows, strict=True)) or [()] * len(self.header)
        cells = dict(zip(self.header, columns, strict=True))
        parsed = {name: _floats(cells[name]) for name in self.header if name in self.numbers}
        numbers = {name: values for name, values in parsed.items() if values is not None}
        if len(numbers) < len(parsed):
            raise self._fault(rows, first_line)
        return numbers, {name: cells[name] for name in self.header if name in self.texts}

    def _fault(self, rows: Rows, first_line: int) -> InputError:
        for line, row in enumerate(rows, first_line):
            if len(row) != len(self.header):
                what = f"expected {len(self.header)} cells as in the header, found {len(row)}"
                return InputError(what, file=self.file, line=line, column=min(len(row), len(self.header)) + 1)
            for name, cell in zip(self.header, row, strict=True):
                if name in self.numbers and _floats([cell]) is None:
                    what = f"expected a finite number (up to {LARGEST:g}) or an empty cell, found {cell[:40]!r}"
                    return InputError(what, file=self.file, line=line, column=name)
        raise AssertionError("a chunk was refused that has no fault")


def _floats(cells: Sequence[str]) -> Array | None:
    """The cells as numbers (n,), NaN where empty; None where one is not a finite decimal number."""
    if not NUMBER_TEXT.issuperset("".join(cells)):  # float() alone would take nan, inf, 1_000 and blanks
        return None
    try:
        values = np.array([float(cell) if cell else np.nan for cell in cells])
    except ValueError:
        return None
    return None if (np.abs(values) > LARGEST).any() else values
