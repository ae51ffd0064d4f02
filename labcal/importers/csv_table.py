"""Tables of text as loggers write them: any of the usual delimiters, with or without a header, comments and NaN."""

from __future__ import annotations

import codecs
import csv
import re
from collections.abc import Iterator, Sequence
from itertools import islice, pairwise
from pathlib import Path
from typing import BinaryIO, cast

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.importers.recording import CsvForm, ForeignRecording, ReadRequest, Stream, WantedColumns
from labcal.record.physical import LARGEST_NUMBER
from labcal.store.limits import MOST_CELLS, MOST_COLUMNS, shortened
from labcal.store.table import line_blocks

Array = NDArray[np.float64]
Numbered = tuple[int, list[str]]  # line (from 1) and its cells

DELIMITERS = (",", ";", "\t", " ")
MISSING = frozenset({"", "nan", "na", "n/a", "null", "none"})
COMMA, POINT = re.compile(r"[+-]?\d*,\d+(?:[eE][+-]?\d+)?"), re.compile(r"[+-]?\d*\.\d+(?:[eE][+-]?\d+)?")
SNIFFED = 1 << 20  # bytes
MOSTLY = 0.9  # of a column's first cells: it is one of numbers, and what is none is a fault with its line
AT_ONCE = 20_000  # rows
DAY, CLOCK = re.compile(r"\d{4}-\d\d-\d\d|\d{1,2}\.\d{1,2}\.\d{4}"), re.compile(r"\d\d:\d\d(:\d\d([.,]\d+)?)?")
LOOKED_AT = 20  # lines, to see how the table is written


def read(path: Path, request: ReadRequest) -> ForeignRecording:
    """The table as the stream "". Columns of a table without a header are called 1, 2, 3 and so on.

    A row of units below the header goes into the names: `Bx` over `nT` is `Bx [nT]`. A day and a time of day in two
    columns beside each other are a third, of texts, by both their names: `Date Time`.
    """
    with _as_utf8(path) as source:
        lines = _lines(line_blocks(source, str(path)), request.form)
        first = list(islice(lines, LOOKED_AT))
        if not first:
            raise InputError("expected rows, found none", file=path)
        delimiter = request.form.delimiter or _delimiter([text for _, text in first])
        rows = _cells(first, lines, delimiter, path)
        head = next(rows)
        names, first_row = _header(head, request.form, path)
        if first_row is None:
            first_row = next(rows, None)
            if first_row is not None and _are_units(first_row, request.form):
                names = [
                    f"{name} [{unit.strip('()[]')}]" if unit else name
                    for name, unit in zip(names, first_row[1], strict=True)
                ]
                first_row = next(rows, None)
        table = _Table(names, request.of(""), request.form, path)
        for block in _blocks(first_row, rows, request.most_rows):
            table.take(block)
    return ForeignRecording(path, {"": table.stream()})


def has_decimal_commas(path: Path) -> bool:
    """Whether its first rows have numbers such as 1,5 between other delimiters, and none such as 1.5."""
    with _as_utf8(path) as source:
        texts = [text for _, text in islice(_lines(line_blocks(source, str(path)), CsvForm()), LOOKED_AT)]
    delimiter = _delimiter(texts) if texts else ","
    cells = [cell for text in texts for cell in _split(text, delimiter)] if delimiter != "," else []
    return any(map(COMMA.fullmatch, cells)) and not any(map(POINT.fullmatch, cells))


def _as_utf8(path: Path) -> BinaryIO:
    """The file as UTF-8: what a spreadsheet wrote in UTF-16, or in a code page of Windows, is turned into it.

    Raises InputError for what is no text, or has lines that end in CR alone.
    """
    with path.open("rb") as source:
        head = source.read(SNIFFED)
    if head[:2] in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE):
        return cast(BinaryIO, codecs.EncodedFile(path.open("rb"), "utf-8", "utf-16"))
    if b"\0" in head:
        raise InputError("has zero bytes: no table of text, or one in UTF-16 without its byte order mark", file=path)
    if b"\r" in head and b"\n" not in head:
        raise InputError("lines end in CR alone; expected LF or CRLF", file=path, line=1)
    try:
        codecs.getincrementaldecoder("utf-8")().decode(head)
    except UnicodeDecodeError:
        return cast(BinaryIO, codecs.EncodedFile(path.open("rb"), "utf-8", "cp1252", errors="replace"))
    return path.open("rb")


def _lines(blocks: Iterator[tuple[int, list[str]]], form: CsvForm) -> Iterator[tuple[int, str]]:
    """Lines that hold cells, with their numbers: those to skip, comments and empty ones are left out."""
    for first, texts in blocks:
        for line, text in enumerate(texts, first):
            if line > form.skip_lines and text.strip() and not (form.comment and text.startswith(form.comment)):
                yield line, text


def _delimiter(lines: Sequence[str]) -> str:
    """The first that cuts the lines at hand into equal numbers of cells, two or more; a comma where none does."""
    for delimiter in DELIMITERS:
        counts = {len(_split(line, delimiter)) for line in lines}
        if len(counts) == 1 and counts.pop() > 1:
            return delimiter
    return ","


def _split(line: str, delimiter: str) -> list[str]:
    if delimiter == " ":
        return line.split()
    if '"' not in line:
        return [cell.strip() for cell in line.split(delimiter)]
    return [cell.strip() for cell in next(csv.reader([line], delimiter=delimiter), [])]


def _cells(
    first: Sequence[tuple[int, str]], lines: Iterator[tuple[int, str]], delimiter: str, path: Path
) -> Iterator[Numbered]:
    width = 0
    for part in (first, lines):
        for line, text in part:
            cells = _split(text, delimiter)
            width = width or len(cells)
            if width > MOST_COLUMNS:
                raise InputError(f"{width} columns are more than {MOST_COLUMNS}, which no recording has", file=path)
            if len(cells) != width:
                what = f"expected {width} cells as in the first row, found {len(cells)}"
                raise InputError(what, file=path, line=line)
            yield line, cells


def _header(head: Numbered, form: CsvForm, path: Path) -> tuple[list[str], Numbered | None]:
    """The columns' names, and the first row where it is no header."""
    line, cells = head
    is_header = form.header if form.header is not None else any(not _is_value(cell, form) for cell in cells)
    if not is_header:
        return [str(number) for number in range(1, len(cells) + 1)], head
    names = [cell.removeprefix("\ufeff") or str(number) for number, cell in enumerate(cells, 1)]
    for place, name in enumerate(names):
        if name in names[:place]:
            numbered = f"skip_lines = {line} and header = false under [csv]"
            what = f"the column is there twice: give one another name, or call all of them 1, 2, 3 … by {numbered}"
            raise InputError(what, file=path, line=line, column=shortened(name))
    return names, None


def _are_units(row: Numbered, form: CsvForm) -> bool:
    """Whether a row below the header holds words, and no number or date."""
    words = [cell for cell in row[1] if cell]
    return bool(words) and not any(cell[0].isdigit() or cell[0] in "+-.," or _is_value(cell, form) for cell in words)


def _is_value(cell: str, form: CsvForm) -> bool:
    """Whether the cell is a number, a date or missing: something that no header has."""
    return _number(cell, form) is not None or (cell[:4].isdigit() and cell[4:5] == "-")


def _number(cell: str, form: CsvForm) -> float | None:
    if cell.lower() in MISSING or cell in form.missing:
        return float("nan")
    try:
        value = float(cell.replace(",", ".") if form.decimal == "," else cell)
    except ValueError:
        return None
    return value if abs(value) <= LARGEST_NUMBER and "_" not in cell else None


def _blocks(first: Numbered | None, rows: Iterator[Numbered], most: int | None) -> Iterator[list[Numbered]]:
    waiting = [first] if first is not None else []
    left = most
    while True:
        size = AT_ONCE if left is None else min(AT_ONCE, left)
        block = [*waiting, *islice(rows, size - len(waiting))]
        waiting = []
        if not block:
            return
        yield block
        left = None if left is None else left - len(block)


class _Table:
    """The wanted columns, growing block by block; of all, those are numbers whose first cells are."""

    def __init__(self, names: list[str], wanted: WantedColumns | None, form: CsvForm, path: Path) -> None:
        self._names, self._form, self._path = names, form, path
        self._wanted = wanted
        self._numbers: dict[str, list[Array]] = {}
        self._texts: dict[str, list[str]] = {}
        self._days: dict[str, tuple[str, str]] = {}  # of a day's and a time's column, by both their names
        self._lines: list[int] = []

    def take(self, block: list[Numbered]) -> None:
        columns = dict(zip(self._names, zip(*(cells for _, cells in block), strict=True), strict=True))
        lines = [line for line, _ in block]
        if (len(self._lines) + len(lines)) * len(self._names) > MOST_CELLS:
            raise InputError(f"has more than {MOST_CELLS // 1_000_000} million cells: split it", file=self._path)
        if not self._lines:
            self._begin(columns)
        for name, parts in self._numbers.items():
            parts.append(self._parsed(columns[name], lines, name))
        for name, texts in self._texts.items():
            of = self._days.get(name, (name,))
            texts.extend(map(" ".join, zip(*(columns[one] for one in of), strict=True)))
        self._lines += lines

    def stream(self) -> Stream:
        numbers = {name: np.concatenate(parts) for name, parts in self._numbers.items()}
        if not self._lines:
            raise InputError("expected rows after the header, found none", file=self._path)
        return Stream("", self._path, numbers, self._texts, np.array(self._lines, dtype=np.intp))

    def _begin(self, columns: dict[str, tuple[str, ...]]) -> None:
        for name, cells in columns.items():
            if self._wanted is not None:
                is_text, is_number = name in self._wanted.texts, name in self._wanted.numbers
            else:
                fit = sum(_number(cell, self._form) is not None for cell in cells)
                is_number = fit >= MOSTLY * len(cells) and _number(cells[0], self._form) is not None
                is_text = not is_number
            if is_number:
                self._numbers[name] = []
            if is_text:
                self._texts[name] = []
        for (day, days), (clock, times) in pairwise(columns.items()):
            name = f"{day} {clock}"
            is_wanted = name not in columns if self._wanted is None else name in self._wanted.texts
            if is_wanted and DAY.fullmatch(days[0]) and CLOCK.fullmatch(times[0]):
                self._days[name], self._texts[name] = (day, clock), []

    def _parsed(self, cells: tuple[str, ...], lines: list[int], name: str) -> Array:
        values = [_number(cell, self._form) for cell in cells]
        if None in values:
            at = values.index(None)
            what = f"expected a number, found {shortened(cells[at], 40)!r}"
            if COMMA.fullmatch(cells[at]):
                what += ': where commas are decimal, the mapping says so: decimal = "," under [csv]'
            raise InputError(what, file=self._path, line=lines[at], column=shortened(name))
        return np.array(values, dtype=float)
