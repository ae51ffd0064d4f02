"""A calibration applied to a recording on disk: every column and row stays, five columns are added.

A text that a spreadsheet would work out as a formula gets an apostrophe before it (`labcal.spreadsheet`).
"""

from __future__ import annotations

from math import isfinite
from pathlib import Path

import numpy as np

from labcal.errors import InputError
from labcal.files import write_text
from labcal.model import Calibration
from labcal.model.apply import Applied, Readings, apply, needed_columns, temperature_channel
from labcal.model.effects import load_shipped
from labcal.spreadsheet import shielded_row
from labcal.store.table import Table, read_table, require_increasing

READING = ("dut_x", "dut_y", "dut_z")
ADDED = ("b_x", "b_y", "b_z", "u_nT", "flag")


def check_effects(calibration: Calibration, file: Path) -> None:
    """Raise InputError that names the place in `file` where an effect is not whole, or no installed package has it."""
    for number, record in enumerate(calibration.effects):
        try:
            load_shipped(record)
        except InputError as error:
            raise InputError(f"effects[{number}]: {error.what}", file=file) from None


def apply_file(calibration: Calibration, source: Path, out: Path) -> Applied:
    """Write `source` with b_x, b_y, b_z, u_nT and flag added to `out`, whole or not at all (contract: `apply`).

    Raises InputError with file, line and column for a missing column, a cell that is no number, or a time that does
    not grow where an effect remembers; and where `out` is `source` itself, which is a record.
    """
    if out.exists() and out.samefile(source):
        raise InputError("is the recording itself; write what is corrected to another file", file=out)
    if source.is_char_device():
        raise InputError("is a device, no recording", file=source)
    table = _table(calibration, source)
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is left empty
        applied = apply(calibration, _readings(table))
    write_text(out, "\n".join([f"{shielded_row(table.header_line)},{','.join(ADDED)}", *_rows(table, applied)]) + "\n")
    return applied


def _table(calibration: Calibration, source: Path) -> Table:
    needed = needed_columns(calibration)
    texts = ("segment", "mode")
    wanted = {*READING, *(n for n in needed if n not in texts)}
    wanted |= {name for name in (temperature_channel(calibration, {"temp_dut": np.array([])}),) if name}
    table = read_table(source.read_bytes(), file=source, numbers=wanted, texts=texts, required=(*READING, *needed))
    for name in ADDED:
        if name in table.header:
            raise InputError("the column is there already: is this a corrected recording?", file=source, column=name)
    if "segment" in needed:
        require_increasing(table)
    return table


def _readings(table: Table) -> Readings:
    numbers, texts = dict(table.numbers), table.texts
    reading = np.stack([numbers.pop(name) for name in READING], axis=1)
    segment, mode = (np.array(texts[n], dtype=np.str_) if n in texts else None for n in ("segment", "mode"))
    return Readings(reading, numbers.pop("t_s", None), segment, mode, numbers)


def _rows(table: Table, applied: Applied) -> list[str]:
    numbers = np.column_stack([applied.field_nT, applied.u_nT]).tolist()
    cells = (",".join(f"{v:.3f}" if isfinite(v) else "" for v in row) for row in numbers)
    rows = zip(map(shielded_row, table.lines), cells, applied.flags, strict=True)
    return [f"{line},{new},{flag}" for line, new, flag in rows]
