"""A strict reader of comma-separated tables, some rows at a time: every fault with its file, line and column.

A line end always ends a row. LF and CRLF are read alike, and so is a byte order mark before the header.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.record.physical import LARGEST_NUMBER
from labcal.store.limits import (
    LONGEST_LINE,
    MOST_CELLS,
    MOST_COLUMNS,
    MOST_WORDS,
    MiB,
    listed,
    shortened,
)

Array = NDArray[np.float64]
Rows = list[list[str]]

NUMBER_TEXT = b"0123456789+-.eE"
AT_ONCE = 4 * MiB  # bytes


@dataclass(frozen=True, slots=True, eq=False)
class Piece:
    """Some rows of a table, the first of them on line `line` of its file."""

    file: str
    line: int
    rows: int
    lines: Sequence[str]  # (n,) each row's own text, without its line end; empty where nobody needs them any more
    numbers: dict[str, Array]  # (n,) each, NaN where the cell is empty
    texts: dict[str, Sequence[str]]  # (n,) each

    def __len__(self) -> int:
        return self.rows

    def fault(self, what: str, row: int, column: str) -> InputError:
        """The error that says `what` is wrong in one cell."""
        return InputError(what, file=self.file, line=self.line + row, column=column)


@dataclass(frozen=True, slots=True, eq=False)
class ColumnTable:
    """Those columns of a table that were asked for. Row i is line i + 2 of the file."""

    file: str
    header: tuple[str, ...]
    rows: int
    numbers: Mapping[str, Array]  # (n,) each, NaN where the cell is empty
    texts: Mapping[str, Sequence[str]]  # (n,) each

    def __len__(self) -> int:
        return self.rows

    def fault(self, what: str, row: int, column: str) -> InputError:
        """The error that says `what` is wrong in one cell."""
        return InputError(what, file=self.file, line=row + 2, column=column)


class TableReader:
    """Reads those of the columns `numbers` and `texts` that are there; the others stay in each row's own text.

    `required` columns must be there; the last line needs no line end. Raises InputError at the first fault.
    """

    def __init__(
        self,
        source: BinaryIO,
        *,
        file: object,
        numbers: Collection[str],
        texts: Collection[str] = (),
        required: Collection[str] = (),
    ) -> None:
        self.file = str(file)
        self._blocks = line_blocks(source, self.file)
        _, self._first = next(self._blocks, (1, list[str]()))
        if not self._first:
            raise InputError("expected a header row, found an empty file", file=self.file, line=1)
        self.header_line = self._first[0]
        if "\r" in self.header_line:
            raise InputError("lines end in CR alone; expected LF or CRLF", file=self.file, line=1)
        self.header = _header(self.header_line, self.file, required)
        self._numbers, self._texts = frozenset(numbers), frozenset(texts)

    def pieces(self) -> Iterator[Piece]:
        """The rows, once, in order."""
        if len(self._first) > 1:
            yield self._read(2, self._first[1:])
            self._first = []
        for line, lines in self._blocks:
            yield self._read(line, lines)

    def _read(self, line: int, lines: list[str]) -> Piece:
        """Columns of some rows: fast as long as nothing is wrong, then once more with care to say where."""
        rows = _split(lines, self.file, line)
        if any(len(row) != len(self.header) for row in rows):
            raise self._fault(rows, line)
        cells: dict[str, Sequence[str]] = dict(zip(self.header, zip(*rows, strict=True), strict=True))
        parsed = {name: _floats(cells[name]) for name in self.header if name in self._numbers}
        numbers = {name: values for name, values in parsed.items() if values is not None}
        if len(numbers) < len(parsed):
            raise self._fault(rows, line)
        texts = {name: cells[name] for name in self.header if name in self._texts}
        return Piece(self.file, line, len(lines), lines, numbers, texts)

    def _fault(self, rows: Rows, first_line: int) -> InputError:
        for line, row in enumerate(rows, first_line):
            if len(row) != len(self.header):
                what = f"expected {len(self.header)} cells as in the header, found {len(row)}"
                return InputError(what, file=self.file, line=line, column=min(len(row), len(self.header)) + 1)
            for name, cell in zip(self.header, row, strict=True):
                if name in self._numbers and _floats([cell]) is None:
                    what = f"expected a finite number (up to {LARGEST_NUMBER:g}) or an empty cell, found {cell[:40]!r}"
                    return InputError(what, file=self.file, line=line, column=name)
        raise AssertionError("a chunk was refused that has no fault")


def read_table(
    data: bytes,
    *,
    file: object,
    numbers: Collection[str],
    texts: Collection[str] = (),
    required: Collection[str] = (),
    growing: str | None = None,
) -> ColumnTable:
    """The whole of a table that is in memory, as `TableReader`. Raises InputError at the first fault.

    `growing`: the column whose values must grow from row to row; the first row where they do not ends the reading.
    """
    reader = TableReader(io.BytesIO(data), file=file, numbers=numbers, texts=texts, required=required)
    rows, columns = data.count(b"\n"), len(reader.header)
    if rows * columns > MOST_CELLS:
        what = f"{rows} rows of {columns} columns are more than {MOST_CELLS // 1_000_000} million cells: split the run"
        raise InputError(what, file=file)
    words: dict[str, dict[str, str]] = {}
    pieces, last = list[Piece](), -np.inf
    for piece in reader.pieces():
        last = last if growing is None else require_increasing(piece, growing, last)
        pieces.append(_with_few_words(piece, words))
    names = [name for name in reader.header if name in {*numbers, *texts}]
    return ColumnTable(
        reader.file,
        reader.header,
        sum(map(len, pieces)),
        {c: np.concatenate([np.empty(0), *(p.numbers.pop(c) for p in pieces)]) for c in names if c in numbers},
        {c: [cell for piece in pieces for cell in piece.texts[c]] for c in names if c in texts},
    )


def _with_few_words(piece: Piece, words: dict[str, dict[str, str]]) -> Piece:
    """The piece without its lines, each text of its columns kept once; `words` are those met so far by column."""
    texts: dict[str, Sequence[str]] = {}
    for name, cells in piece.texts.items():
        known = words.setdefault(name, {})
        texts[name] = [known.setdefault(cell, cell) for cell in cells]
        if len(known) > MOST_WORDS:
            raise piece.fault(f"found more than {MOST_WORDS} different words in this column", len(piece) - 1, name)
    return replace(piece, lines=(), texts=texts)


def require_increasing(table: ColumnTable | Piece, column: str = "t_s", last: float = -np.inf) -> float:
    """Raise InputError at the first row whose `column` is empty or not after the row before; the first, after `last`.

    Returns the last row's.
    """
    values = table.numbers[column]
    if (missing := np.flatnonzero(np.isnan(values))).size:
        raise table.fault("expected a time, found an empty cell", int(missing[0]), column)
    before = np.concatenate([[last], values[:-1]])
    if (wrong := np.flatnonzero(values <= before)).size:
        row = int(wrong[0])
        word = "the same time as" if values[row] == before[row] else "an earlier time than"
        raise table.fault(f"found {word} the row before ({before[row]} s); time must grow", row, column)
    return float(values[-1]) if len(values) else last


def decode(data: bytes, *, file: str, line: int = 1) -> str:
    """UTF-8 text, without a byte order mark. Raises InputError with the line of the first wrong byte."""
    try:
        return data.decode("utf-8-sig" if line == 1 else "utf-8")
    except UnicodeDecodeError as error:
        line += data.count(b"\n", 0, error.start)
        raise InputError(f"expected UTF-8 text, found byte 0x{data[error.start]:02x}", file=file, line=line) from None


def line_blocks(source: BinaryIO, file: str) -> Iterator[tuple[int, list[str]]]:
    """Whole lines, some at a time, with the number of the first; without line ends and empty lines at the end."""
    line, blank = 1, 0
    for data in _whole_lines(source, file):
        kept = data.rstrip(b"\r\n")
        if not kept:
            blank += data.count(b"\n")
            continue
        for _ in range(blank):  # between two rows: the first is a fault, unless rows may be empty
            yield line, [""]
            line += 1
        lines = decode(kept, file=file, line=line).replace("\r\n", "\n").split("\n")
        yield line, lines
        line, blank = line + len(lines), max(data.count(b"\n", len(kept)) - 1, 0)


def _whole_lines(source: BinaryIO, file: str) -> Iterator[bytes]:
    """The bytes up to a line end each, the last ones as they are."""
    rest, line = b"", 1
    while data := source.read(AT_ONCE):
        end = data.rfind(b"\n") + 1
        whole, rest = (rest + data[:end], data[end:]) if end else (b"", rest + data)
        line += whole.count(b"\n")
        if len(rest) > LONGEST_LINE:
            raise InputError(f"a line is longer than {LONGEST_LINE // MiB} MiB", file=file, line=line)
        if whole:
            yield whole
    if rest:
        yield rest


def _header(line: str, file: str, required: Collection[str]) -> tuple[str, ...]:
    if line.count(",") >= MOST_COLUMNS:
        what = f"{line.count(',') + 1} columns are more than {MOST_COLUMNS}, which no recording has"
        raise InputError(what, file=file, line=1)
    (header,) = _split([line], file, 1)
    before = set[str]()
    for number, name in enumerate(header, 1):
        if not name:
            raise InputError("expected a column name, found nothing", file=file, line=1, column=number)
        if name in before:
            raise InputError("the column is there twice", file=file, line=1, column=shortened(name))
        before.add(name)
    for name in required:
        if name not in before:
            raise InputError(f"the column is missing; the header has {listed(header)}", file=file, column=name)
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


def _floats(cells: Sequence[str]) -> Array | None:
    """The cells as numbers (n,), NaN where empty; None where one is not a finite decimal number."""
    if "".join(cells).encode().translate(None, NUMBER_TEXT):  # float() alone would take nan, inf, 1_000 and blanks
        return None
    try:
        values = np.array(list(map(float, cells)) if "" not in cells else [float(c) if c else np.nan for c in cells])
    except ValueError:
        return None
    return None if (np.abs(values) > LARGEST_NUMBER).any() else values
