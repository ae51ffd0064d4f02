"""The table of a study: one row a job, in the order of jobs, as CSV, and as Parquet where pyarrow is there."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

from labcal.files.atomic import replacing
from labcal.files.spreadsheet import shielded
from labcal.study.job import Cell, Row

NO_PARQUET = "Without the extra `cluster` (pip install 'labcal[cluster]') the table is CSV alone."


def has_parquet() -> bool:
    """Whether tables can be written as Parquet here."""
    return find_spec("pyarrow") is not None


def columns(rows: Sequence[Row]) -> list[str]:
    """Every column that a row has, in the order in which they first come."""
    return list(dict.fromkeys(name for row in rows for name in row))


def csv_text(rows: Sequence[Row]) -> str:
    """The table as text: numbers so that they are read back the same, nothing where there is none."""
    out, names = io.StringIO(), columns(rows)
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(map(shielded, names))
    writer.writerows([_cell(row.get(name)) for name in names] for row in rows)
    return out.getvalue()


def write_parquet(rows: Sequence[Row], path: Path) -> None:
    """The table as one Parquet file; a column of both numbers and words is of words."""
    import pyarrow as pa
    import pyarrow.parquet as parquet

    table = pa.table({name: _column([row.get(name) for row in rows]) for name in columns(rows)})
    with replacing(path) as part:
        parquet.write_table(table, part)


def _cell(value: Cell) -> str:
    if value is None:
        return ""
    return shielded(value) if isinstance(value, str) else repr(value)


def _column(values: list[Cell]) -> list[Cell]:
    """Values of one kind: whole numbers beside others are numbers, numbers beside words are words."""
    kinds = {type(value) for value in values if value is not None}
    if len(kinds) < 2:
        return values
    if kinds == {int, float}:
        return [None if value is None else float(value) for value in values]
    return [None if value is None else str(value) for value in values]
