"""IAGA-2002, the observatories' text format: values in nT, H and D turned into X and Y, UTC in seconds.

https://www.ncei.noaa.gov/services/world-data-system/v-dat-working-group/iaga-2002-data-exchange-format
"""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.importers.recording import ForeignRecording, ReadRequest, Stream
from labcal.store.table import line_blocks

Array = NDArray[np.float64]

NOT_THERE = 88_888.0  # and beyond: 88888 was not recorded, 99999 is missing
KEPT = ("Station Name", "IAGA CODE", "Geodetic Latitude", "Geodetic Longitude", "Elevation", "Reported", "Data Type")
VALUES = 4


def read(path: Path, request: ReadRequest) -> ForeignRecording:
    """The stream "" with `time` [s since 1970, UTC] and the elements that are reported, X Y Z F among them [nT]."""
    head: dict[str, str] = {}
    columns: list[str] = []
    stamps, values, lines = list[float](), list[list[float]](), list[int]()
    with path.open("rb") as source:
        for line, text in _lines(path, line_blocks(source, str(path))):
            if text.endswith("|") and not columns:
                columns = _columns(text, head, path, line)
            elif columns:
                stamp, row = _row(text, path, line)
                stamps.append(stamp)
                values.append(row)
                lines.append(line)
                if request.most_rows is not None and len(stamps) >= request.most_rows:
                    break
    if not stamps:
        raise InputError("expected an IAGA-2002 file: a head, a line of columns and rows; found none", file=path)
    table = _elements(columns, np.array(values), path)
    started = datetime.fromtimestamp(stamps[0], UTC).isoformat().replace("+00:00", "Z")
    numbers = {"time": np.array(stamps), **table}
    notes = tuple(f"{key}: {head[key]}" for key in KEPT if head.get(key))
    return ForeignRecording(path, {"": Stream("", path, numbers, lines=np.array(lines, dtype=np.intp))}, started, notes)


def _lines(path: Path, blocks: Iterator[tuple[int, list[str]]]) -> Iterator[tuple[int, str]]:
    for first, texts in blocks:
        for line, text in enumerate(texts, first):
            if line == 1 and "Format" not in text:
                raise InputError("expected an IAGA-2002 file, whose first line says its format", file=path, line=1)
            if text.strip():
                yield line, text.rstrip()


def _columns(text: str, head: dict[str, str], path: Path, line: int) -> list[str]:
    """The elements' names where this line has them; else it is one of the head, which is kept."""
    if not text.startswith("DATE"):
        head[text[1:24].strip()] = text[24:-1].strip()
        return []
    names = text[:-1].split()[3:]
    if len(names) != VALUES:
        raise InputError(f"expected {VALUES} elements after DATE TIME DOY, found {len(names)}", file=path, line=line)
    return [name[-1] for name in names]  # behind the station's code


def _row(text: str, path: Path, line: int) -> tuple[float, list[float]]:
    cells = text.split()
    try:
        if len(cells) != 3 + VALUES:
            raise ValueError
        stamp = datetime.fromisoformat(f"{cells[0]}T{cells[1]}").replace(tzinfo=UTC).timestamp()
        return stamp, [_value(cell) for cell in cells[3:]]
    except ValueError:
        what = f"expected date, time, day of year and {VALUES} numbers, found {text[:60]!r}"
        raise InputError(what, file=path, line=line) from None


def _value(cell: str) -> float:
    value = float(cell)
    if not np.isfinite(value):
        raise ValueError
    return value if abs(value) < NOT_THERE else float("nan")


def _elements(names: list[str], values: Array, path: Path) -> dict[str, Array]:
    """The columns by element; of H [nT] and D [minutes of arc], X and Y too."""
    if len(set(names)) != len(names):
        raise InputError(f"an element is there twice: {' '.join(names)}", file=path)
    found = {name: np.ascontiguousarray(column) for name, column in zip(names, values.T, strict=True)}
    if {"H", "D"} <= found.keys():
        declination = np.radians(found["D"] / 60)
        found |= {"X": found["H"] * np.cos(declination), "Y": found["H"] * np.sin(declination)}
    return found
