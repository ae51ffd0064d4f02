"""samples.csv, the rows of a run bundle: read with the header's word for what a column means, written byte-stable."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.files.text_safety import checked_text
from labcal.record import Channel, Dut, Reference, Run
from labcal.record.physical import LARGEST_FIELD_nT
from labcal.store.limits import listed, shortened
from labcal.store.number_text import number_texts
from labcal.store.run_json import FIXED_COLUMNS, RunJson
from labcal.store.table import ColumnTable, read_table

Array = NDArray[np.float64]

DUT = ("dut_x", "dut_y", "dut_z")
REFERENCE = {"vector": ("ref_x", "ref_y", "ref_z"), "scalar": ("ref_f",), "none": ()}
FIELDS = ("ref_x", "ref_y", "ref_z", "ref_f")
LONGEST_MODE = 100


def read_samples(data: bytes, header: RunJson, *, file: object) -> Run:
    """The run of `header` with the rows of samples.csv. Raises InputError at the first fault."""
    table = _table(data, header, str(file))
    numbers = table.numbers
    return Run(
        run_id=header.run_id,
        started_utc=header.started_utc,
        simulated=header.simulated,
        operator=header.operator,
        dut=Dut(**header.dut.known()),
        reference=Reference(**header.reference.known()),
        segments=header.record_segments(),
        t_s=numbers["t_s"],
        segment_index=_segment_index(table, [segment.id for segment in header.segments]),
        reading=_stack(numbers, DUT),
        reference_vector=_stack(numbers, REFERENCE["vector"]) if header.reference.kind == "vector" else None,
        reference_magnitude=numbers["ref_f"] if header.reference.kind == "scalar" else None,
        angle_deg=numbers.get("angle_deg"),
        row_mode=_row_mode(table),
        specification=header.specification,
        closures=header.record_closures(),
        administrative=header.administrative,
        environment=header.stated_environment(),
        channels=tuple(
            Channel(name, part.spelt_unit, part.quantity, numbers[name], part.role)
            for name, part in header.channels.items()
            if name in numbers
        ),
    )


def write_samples(run: Run) -> bytes:
    """The rows of `run` as samples.csv: LF, shortest numbers that read back the same, empty where missing."""
    names, columns = zip(*_columns(run), strict=True)
    head = ",".join(map(_cell, names))
    return "\n".join([head, *map(",".join, zip(*columns, strict=True)), ""]).encode()


def _table(data: bytes, header: RunJson, file: str) -> ColumnTable:
    known = {*FIXED_COLUMNS, *header.channels}
    texts = {"segment", "mode"}
    required = ("t_s", "segment", *DUT, *REFERENCE[header.reference.kind])
    table = read_table(data, file=file, numbers=known - texts, texts=texts, required=required, growing="t_s")
    for name in table.header:
        if name not in known:
            what = f"run.json declares no channel of this name; it has {listed(header.channels) or 'none'}"
            raise InputError(what, file=file, line=1, column=shortened(name))
    if not len(table):
        raise InputError("expected rows of samples after the header, found none", file=file, line=2)
    for name in (name for name in FIELDS if name in table.numbers):
        _refuse_beyond(table, name, LARGEST_FIELD_nT)
    return table


def _refuse_beyond(table: ColumnTable, name: str, most_nT: float) -> None:
    """Raise InputError for a field that no lab can have made; what a DUT says for one is its own affair."""
    values = table.numbers[name]
    if (beyond := np.flatnonzero(np.abs(values) > most_nT)).size:
        row = int(beyond[0])
        raise table.fault(f"expected at most {most_nT:g} nT either way, found {values[row]:g}", row, name)


def _segment_index(table: ColumnTable, ids: Sequence[str]) -> NDArray[np.intp]:
    place = {name: index for index, name in enumerate(ids)}
    cells = table.texts["segment"]
    if not place.keys() >= set(cells):
        row = next(i for i, cell in enumerate(cells) if cell not in place)
        raise table.fault(f"unknown segment {cells[row][:40]!r}; run.json has {listed(ids)}", row, "segment")
    return np.array([place[cell] for cell in cells], dtype=np.intp)


def _row_mode(table: ColumnTable) -> NDArray[np.str_] | None:
    if "mode" not in table.texts:
        return None
    cells = table.texts["mode"]
    for mode in sorted(set(cells)):
        if len(mode) > LONGEST_MODE:
            raise table.fault(f"expected a power mode of at most {LONGEST_MODE} letters", cells.index(mode), "mode")
        try:
            checked_text(mode)
        except ValueError as error:
            raise table.fault(str(error), cells.index(mode), "mode") from None
    return np.array(cells, dtype=np.str_)


def _stack(numbers: Mapping[str, Array], names: Sequence[str]) -> Array:
    return np.stack([numbers[name] for name in names], axis=1)


def _columns(run: Run) -> Iterable[tuple[str, Sequence[str]]]:
    ids = [_cell(segment.id) for segment in run.segments]
    yield "t_s", number_texts(run.t_s)
    yield "segment", [ids[index] for index in run.segment_index.tolist()]
    yield from zip(DUT, map(number_texts, run.reading.T), strict=True)
    if run.reference_vector is not None:
        yield from zip(REFERENCE["vector"], map(number_texts, run.reference_vector.T), strict=True)
    elif run.reference_magnitude is not None:
        yield "ref_f", number_texts(run.reference_magnitude)
    if run.angle_deg is not None:
        yield "angle_deg", number_texts(run.angle_deg)
    if run.row_mode is not None:
        yield "mode", _cells(run.row_mode.tolist())
    for channel in run.channels:
        yield channel.name, number_texts(channel.values)


def _cell(word: str) -> str:
    """A text as a cell, quoted where it has to be."""
    line = io.StringIO()
    csv.writer(line, lineterminator="\n").writerow([word, ""])
    return line.getvalue().removesuffix(",\n")


def _cells(words: Sequence[str]) -> list[str]:
    """The same of many words, few of them different."""
    cells = {word: _cell(word) for word in set(words)}
    return [cells[word] for word in words]
