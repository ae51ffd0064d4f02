"""chain.jsonl of a bundle: the rows of the run as they were recorded, chained; it shows where samples.csv comes from.

A line is a row: `of` (run, status, item), the row's values by name (stamps, samples and raw frames in base64; absent
where there are none), and its link `sha256` (see `labcal.store.chain`). Values that are not stated count as none.
"""

from __future__ import annotations

import json
import sqlite3
from base64 import b64decode, b64encode
from collections.abc import Mapping
from dataclasses import replace
from math import isclose
from typing import Any

import numpy as np

from labcal.errors import InputError
from labcal.record import Run, RunHeader
from labcal.record.assemble import assemble
from labcal.record.stream import Event, Item
from labcal.store.chain import COLUMNS, FORMAT, START, Chain, link, parts, values_of
from labcal.store.items import ItemRow, from_row, header_from_json
from labcal.store.run_json import read_run_json, write_run_json
from labcal.store.samples_csv import read_samples, write_samples
from labcal.store.schema import CORRECTED

ENDS = ("finished", "stopped", "imported")  # and "failed: why"
BINARY = ("stamps", "samples", "raw")
RECORDED = ("run", "status", "item")  # the tables that a recorded run has rows in
ROUNDING = 1e-9  # relative: another machine may round the last bit of an interpolated value otherwise


def ends(status: str) -> bool:
    """Whether a run that stands so is over: nothing that was measured comes after it."""
    return status in ENDS or status.startswith("failed: ")


def chain_jsonl(connection: sqlite3.Connection, run: int) -> bytes:
    """The chain of a recorded run as lines; empty where it has none."""
    lines = bytearray()
    for table, row, made in parts(connection, run):
        values = values_of(connection, run, table, row) or ()
        stated = [(name, value) for name, value in zip(COLUMNS[table], values, strict=False) if value is not None]
        record = (f'"{name}":{_text(value)}' for name, value in (("of", table), *stated, ("sha256", made)))
        lines += f"{{{','.join(record)}}}\n".encode()
    return bytes(lines)


def corrected_header(header: RunHeader, items: list[Item]) -> RunHeader:
    """The header with the serial that the last correction among `items` states."""
    serials = [str(i.data["to"]) for i in items if isinstance(i, Event) and i.kind == CORRECTED]
    return replace(header, dut=replace(header.dut, serial=serials[-1])) if serials else header


def shown(content: bytes, run_json: bytes, samples_csv: bytes, file: object) -> Chain:
    """The chain that `content` holds, where a run's two files are what its rows make.

    Raises InputError naming the first line that does not fit.
    """
    chain, header, items, ended = Chain(START, 0), None, list[Item](), False
    for number, line in enumerate(content.split(b"\n")[:-1], 1):
        try:
            table, values, stated = _row(line)
            if (table == "run") != (number == 1) or link(chain.head, table, values) != stated:
                raise ValueError("this row is not as it was recorded, or its link is not")
            header = _header(values) if table == "run" else header
            items += [from_row(ItemRow(*values))] if table == "item" else []
            ended = ended or (table == "status" and ends(str(values[0])))
        except (ValueError, KeyError, TypeError, RecursionError) as error:
            raise InputError(_what(error), file=file, line=number) from None
        chain = Chain(stated, number)
    if header is None or not content.endswith(b"\n"):
        raise InputError("is cut off: it ends inside a line, or has none", file=file)
    if not ended:
        raise InputError("is cut off: it does not say how its run ended", file=file)
    _require_made_of(assemble(corrected_header(header, items), items), run_json, samples_csv, file)
    return chain


def last_link(content: bytes) -> Chain:
    """The head of a chain that was looked at before."""
    lines = content.split(b"\n")[:-1]
    return Chain(str(json.loads(lines[-1])["sha256"]), len(lines))


def _row(line: bytes) -> tuple[str, tuple[Any, ...], str]:
    """Table, values in the order of COLUMNS, and link of a line. Raises ValueError."""
    record = json.loads(line)
    if not isinstance(record, dict) or (table := record.get("of")) not in RECORDED:
        raise ValueError("is no row of a record")
    if unknown := record.keys() - {"of", "sha256", *COLUMNS[table]}:
        raise ValueError(f"states {sorted(unknown)[0]!r}, which no row of a record has")
    values = tuple(
        b64decode(record[name], validate=True) if name in BINARY and name in record else record.get(name)
        for name in COLUMNS[table]
    )
    return table, values, str(record.get("sha256"))


def _header(values: tuple[Any, ...]) -> RunHeader:
    run_id, text = values
    if (stated := json.loads(text).get("chain")) != FORMAT:
        raise ValueError(f"a chain of format {stated!r}; this labcal reads {FORMAT}")
    header = header_from_json(text)
    if header.run_id != run_id:
        raise ValueError("its head is of another run")
    return header


def _require_made_of(made: Run, run_json: bytes, samples_csv: bytes, file: object) -> None:
    """Raise InputError where the two files are not those of the run `made`, but for rounding."""
    if write_run_json(made) == run_json and write_samples(made) == samples_csv:
        return
    if not _same(json.loads(write_run_json(made)), json.loads(run_json.decode("utf-8-sig"))):
        raise InputError("run.json is not what its rows make", file=file)
    header = read_run_json(run_json, file="run.json")
    measured, stated = (read_samples(rows, header, file="samples.csv") for rows in (write_samples(made), samples_csv))
    if (different := _first_different(measured, stated)) is not None:
        raise InputError(f"samples.csv is not what its rows make: {different} differs", file=file)


def _first_different(one: Run, other: Run) -> str | None:
    """What of two runs' rows is not the same; None where all is."""
    if len(one) != len(other):
        return f"the number of rows, {len(other)} for {len(one)},"
    for name in ("t_s", "segment_index", "reading", "reference_vector", "reference_magnitude", "angle_deg"):
        if not _close(getattr(one, name), getattr(other, name)):
            return name
    if not np.array_equal(one.mode, other.mode):
        return "mode"
    pairs = zip(one.channels, other.channels, strict=False)
    return next((a.name for a, b in pairs if a.name != b.name or not _close(a.values, b.values)), None)


def _close(one: Any, other: Any) -> bool:
    if one is None or other is None:
        return one is other
    scale = float(np.nanmax(np.abs(one), initial=0.0)) if np.isfinite(one).any() else 0.0
    return bool(np.allclose(one, other, rtol=ROUNDING, atol=ROUNDING * scale, equal_nan=True))


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(_same(one[key], other[key]) for key in one)
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_same, one, other))
    if isinstance(one, float) and isinstance(other, float | int):
        return isclose(one, other, rel_tol=ROUNDING)
    return bool(one == other)


def _text(value: Any) -> str:
    """As JSON; of bytes their base64, whose letters JSON need not look at one by one."""
    if isinstance(value, bytes):
        return f'"{b64encode(value).decode("ascii")}"'
    return json.dumps(value, ensure_ascii=False)


def _what(error: Exception) -> str:
    if isinstance(error, json.JSONDecodeError):
        return f"is no row of a record: {error.msg}"
    return error.what if isinstance(error, InputError) else str(error)
