"""A gage study laid out: which DUT was measured by whom in which mounting, from runs or from a table."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product
from math import isfinite, prod
from pathlib import Path

import numpy as np

from labcal import session
from labcal.errors import InputError
from labcal.files.plain_file import read_limited
from labcal.quality.gage_rr import GageRR, gage_rr
from labcal.session.figures import figures_of_run

COLUMNS = ("dut", "operator", "mounting", "value")
FACTORS = ("DUT", "operator", "mounting")
LARGEST_BYTES = 2**24


@dataclass(frozen=True, slots=True)
class GageRow:
    """One measurement: three factors' levels ("" where not stated) and the value."""

    levels: tuple[str, str, str]
    value: float


@dataclass(frozen=True, slots=True)
class Study:
    """A study, its quantity and unit, how many levels each factor has, repeats of each cell, and what was left out."""

    quantity: str
    unit: str
    levels: tuple[tuple[str, int], ...]
    repeats: int
    found: GageRR
    remarks: tuple[str, ...]
    simulated: bool = False


def studied(
    rows: Sequence[GageRow], quantity: str, unit: str, tolerance: float | None = None, *, simulated: bool = False
) -> Study:
    """The study of these rows. Raises InputError where a cell is empty or a factor has one level alone."""
    used, remarks = _factors(rows)
    cells: dict[tuple[str, ...], list[float]] = {}
    for row in rows:
        cells.setdefault(tuple(row.levels[i] for i in used), []).append(row.value)
    names = tuple(FACTORS[i] for i in used)
    levels = [sorted({cell[i] for cell in cells}) for i in range(len(used))]
    if (many := prod(map(len, levels))) > len(cells):
        empty = next(cell for cell in product(*levels) if cell not in cells)
        said = "; ".join(f"{n} {v}" for n, v in zip(names, empty, strict=True))
        message = f"nothing is there of {said} ({many - len(cells)} of {many} are missing)"
        raise InputError(f"every DUT is measured by every operator in every mounting: {message}")
    repeats = min(len(values) for values in cells.values())
    if extra := sum(len(values) - repeats for values in cells.values()):
        remarks.append(f"{extra} later repeats are left out: each cell has {repeats}")
    shape = [*(len(one) for one in levels), repeats]
    values = np.array([cells[cell][:repeats] for cell in product(*levels)]).reshape(shape)
    try:
        found = gage_rr(values, names, tolerance=tolerance)
    except ValueError as fault:
        raise InputError(f"{quantity}: {fault}") from None
    return Study(
        quantity, unit, tuple(zip(names, map(len, levels), strict=True)), repeats, found, tuple(remarks), simulated
    )


def _factors(rows: Sequence[GageRow]) -> tuple[list[int], list[str]]:
    """The factors that vary, and a sentence about each that does not. Raises InputError for one DUT alone."""
    several = [len({row.levels[i] for row in rows}) > 1 for i in range(3)]
    if not several[0]:
        raise InputError("a gage study needs two DUTs at least: the spread of the gage is held against theirs")
    once = [FACTORS[i] for i in (1, 2) if not several[i]]
    remarks = [f"one {name} alone: what another would differ by is not seen" for name in once]
    return [i for i in range(3) if several[i]], remarks


def rows_of_runs(
    runs: Sequence[str], quantity: str, progress: Callable[[str], None] = lambda one: None
) -> tuple[list[GageRow], str, bool]:
    """A row for each run, in its mounting where its segments share one; the unit; whether the runs are simulated.

    Raises InputError where a run gives no figures, is named twice, or is simulated among real ones.
    """
    if len(set(runs)) < len(runs):
        raise InputError(f"the run {next(r for r in runs if runs.count(r) > 1)} is named twice")
    rows, unit, kinds = list[GageRow](), "", set[bool]()
    for name in runs:
        progress(name)
        run, found = session.load_run(name), figures_of_run(name)
        if quantity not in found:
            raise InputError(f"{quantity!r} is none of the figures {', '.join(found)}")
        mountings = {segment.mounting or "" for segment in run.segments}
        mounting = mountings.pop() if len(mountings) == 1 else ""
        rows.append(GageRow((run.dut.serial, run.operator, mounting), found[quantity].value))
        unit = found[quantity].unit
        kinds.add(run.simulated)
        if len(kinds) > 1:
            raise InputError("simulated and real runs are no study: name those that belong together")
    return rows, unit, True in kinds


def rows_of_table(path: Path) -> list[GageRow]:
    """The rows of a CSV with the columns dut, operator, mounting (if there is one) and value. Raises InputError."""
    try:
        text = read_limited(path, LARGEST_BYTES).decode("utf-8-sig")
    except UnicodeDecodeError as fault:
        raise InputError(f"is not UTF-8 (byte {fault.start})", file=path) from None
    reader = csv.DictReader(io.StringIO(text))
    try:
        heads = [head.strip().lower() for head in reader.fieldnames or ()]
        if missing := [name for name in ("dut", "value") if name not in heads]:
            raise InputError(f"has no column {missing[0]!r}; it needs {', '.join(COLUMNS)}", file=path, line=1)
        if twice := [name for name in COLUMNS if heads.count(name) > 1]:
            raise InputError(f"has two columns {twice[0]!r}: which of them is meant?", file=path, line=1)
        reader.fieldnames = heads
        return [_row(one, path, reader.line_num) for one in reader]
    except csv.Error as fault:
        raise InputError(f"is no CSV: {fault}", file=path, line=reader.line_num) from None


def _row(one: dict[str, str | None], path: Path, line: int) -> GageRow:
    if None in one:  # what csv calls the cells that are beyond the heads
        raise InputError("has more cells than the heads: a decimal comma is none here", file=path, line=line)
    try:
        value = float(one.get("value") or "")
    except ValueError:
        value = float("nan")
    if not isfinite(value):
        raise InputError(f"{one.get('value')!r} is no number", file=path, line=line, column="value")
    dut, operator, mounting = ((one.get(name) or "").strip() for name in COLUMNS[:3])
    return GageRow((dut, operator, mounting), value)
