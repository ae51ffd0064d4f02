"""A calibration applied to a recording on disk: every column and row stays, five columns are added.

The file is read twice, some rows at a time: its numbers, then its rows as they stand. A text that a spreadsheet would
work out as a formula gets an apostrophe before it (`labcal.files.spreadsheet`).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, islice
from math import isfinite
from operator import ne
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.files.atomic import replacing
from labcal.files.spreadsheet import shielded_row
from labcal.model import Calibration
from labcal.model.apply import apply_in_pieces, needed_columns, temperature_channel
from labcal.model.effects import load_shipped
from labcal.model.readings import Applied, Readings
from labcal.store.limits import MOST_WORDS, MiB
from labcal.store.table import Piece, TableReader, line_blocks, require_increasing

READING = ("dut_x", "dut_y", "dut_z")
TEXTS = ("segment", "mode")
ADDED = ("b_x", "b_y", "b_z", "u_nT", "flag")
AT_ONCE = 30_000  # rows
FORM = "%.3f,%.3f,%.3f,%.3f"


@dataclass(frozen=True, slots=True)
class AppliedFile:
    """How many rows were corrected, and how many of them have each flag, "" or words apart by spaces."""

    rows: int
    flags: Counter[str]


def check_effects(calibration: Calibration, file: Path) -> None:
    """Raise InputError that names the place in `file` where an effect is not whole, or no installed package has it."""
    for number, record in enumerate(calibration.effects):
        try:
            load_shipped(record)
        except InputError as error:
            raise InputError(f"effects[{number}]: {error.what}", file=file) from None


def apply_file(calibration: Calibration, source: Path, out: Path) -> AppliedFile:
    """Write `source` with b_x, b_y, b_z, u_nT and flag added to `out`, whole or not at all (contract: `apply`).

    Raises InputError with file, line and column for a missing column, a cell that is no number, or a time that does
    not grow where an effect remembers; and where `out` is `source` itself, which is a record.
    """
    if out.exists() and out.samefile(source):
        raise InputError("is the recording itself; write what is corrected to another file", file=out)
    if source.is_dir():
        raise InputError("is a folder: name the table of readings, of a bundle its samples.csv", file=source)
    if source.exists() and not source.is_file():
        raise InputError("is no plain file, and it is read twice: write the recording to a file first", file=source)
    with source.open("rb") as recording, np.errstate(over="ignore", invalid="ignore"):  # what overflows is left empty
        readings = _readings(calibration, recording, source)
        lines = _lines(recording, source)
        flags, rows = Counter[str](), 0
        with replacing(out) as part, part.open("w", encoding="utf-8", newline="\n") as written:
            written.write(f"{shielded_row(next(lines))},{','.join(ADDED)}\n")
            for applied in apply_in_pieces(calibration, readings, AT_ONCE):
                batch = list(islice(lines, len(applied.flags)))
                written.writelines(_rows(batch, applied))
                flags.update(applied.flags)
                rows += len(batch)
            if rows != len(readings) or next(lines, None) is not None:
                raise InputError("was changed while it was read", file=source)
    return AppliedFile(rows, flags)


def _readings(calibration: Calibration, recording: BinaryIO, source: Path) -> Readings:
    """The numbers that the calibration needs, all rows of them."""
    needed = needed_columns(calibration)
    wanted = {*READING, *(n for n in needed if n not in TEXTS)}
    wanted |= {name for name in (temperature_channel(calibration, {"temp_dut": np.array([])}),) if name}
    most = _line_ends(recording) + 1
    table = TableReader(recording, file=source, numbers=wanted, texts=TEXTS, required=(*READING, *needed))
    for name in ADDED:
        if name in table.header:
            raise InputError("the column is there already: is this a corrected recording?", file=source, column=name)
    kept, last_s = _Kept(table.header, wanted, most), -np.inf
    for piece in table.pieces():
        last_s = require_increasing(piece, last=last_s) if "segment" in needed else last_s
        kept.take(piece)
    return kept.readings()


class _Kept:
    """Columns of numbers as they come, in the memory that they take and no more."""

    def __init__(self, header: Sequence[str], wanted: set[str], most: int) -> None:
        self._reading, self._rows = np.empty((most, 3)), 0
        self._numbers = {name: np.empty(most) for name in header if name in wanted and name not in READING}
        self._segment = np.empty(most, dtype=np.int32) if "segment" in header else None
        self._mode = np.empty(most, dtype=np.int32) if "mode" in header else None
        self._modes, self._last = dict[str, int](), ("", 0)

    def take(self, piece: Piece) -> None:
        """Some rows more."""
        rows = slice(self._rows, self._rows + len(piece))
        self._rows = rows.stop
        for axis, name in enumerate(READING):
            self._reading[rows, axis] = piece.numbers[name]
        for name, kept in self._numbers.items():
            kept[rows] = piece.numbers[name]
        if self._segment is not None:
            self._segment[rows] = self._numbered(piece.texts["segment"])
        if self._mode is not None:
            self._mode[rows] = [self._modes.setdefault(mode, len(self._modes)) for mode in piece.texts["mode"]]
            if len(self._modes) > MOST_WORDS:
                raise piece.fault(f"found more than {MOST_WORDS} power modes", len(piece) - 1, "mode")

    def readings(self) -> Readings:
        """All that was taken."""
        numbers = {name: kept[: self._rows] for name, kept in self._numbers.items()}
        segment, mode = (None if c is None else c[: self._rows] for c in (self._segment, self._mode))
        t_s, modes = numbers.pop("t_s", None), tuple(self._modes)
        return Readings(self._reading[: self._rows], t_s, segment, mode, numbers, modes)

    def _numbered(self, names: Sequence[str]) -> NDArray[np.int64]:
        """Which stretch of one segment each row (n,) is of, counted from the recording's start."""
        name, number = self._last
        changes = np.fromiter(map(ne, names, chain([name], names)), dtype=bool, count=len(names))
        numbers = np.asarray(number + np.cumsum(changes))
        self._last = names[-1], int(numbers[-1])
        return numbers


def _line_ends(recording: BinaryIO) -> int:
    recording.seek(0)
    count = sum(data.count(b"\n") for data in iter(lambda: recording.read(MiB), b""))
    recording.seek(0)
    return count


def _lines(recording: BinaryIO, source: Path) -> Iterator[str]:
    """The recording's lines as they stand, once more from the first."""
    recording.seek(0)
    return chain.from_iterable(lines for _, lines in line_blocks(recording, str(source)))


def _rows(lines: Sequence[str], applied: Applied) -> Iterator[str]:
    numbers = np.column_stack([applied.field_nT, applied.u_nT])
    cells: Iterable[str]
    if np.isfinite(numbers).all():
        cells = map(FORM.__mod__, map(tuple, numbers.tolist()))
    else:
        cells = (",".join(f"{v:.3f}" if isfinite(v) else "" for v in row) for row in numbers.tolist())
    return (
        f"{line},{new},{flag}\n"
        for line, new, flag in zip(map(shielded_row, lines), cells, applied.flags, strict=False)
    )
