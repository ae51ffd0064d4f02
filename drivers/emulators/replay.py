"""The wire of a replayed file: its rows as lines of text, each when it was recorded."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from drivers.emulators.line import Lab, Pieces
from drivers.framing.columns import number
from drivers.replay import recording
from labcal.errors import InputError

NAMES = {"t": ("t", "t_s"), "x": ("x", "dut_x"), "y": ("y", "dut_y"), "z": ("z", "dut_z"), "-": ()}


class ReplayEmulator:
    """Begins with the bench; the first row comes at once, each other as much later as its t says."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._left = list(_lines(Path(settings.file), settings))

    def take(self, t_s: float, data: bytes) -> None:
        """It does not listen."""

    def due_s(self) -> float:
        """When its next line is; inf behind the last."""
        return self._left[0][0] if self._left else math.inf

    def emit(self, until_s: float) -> Pieces:
        """The lines that are due."""
        count = next((k for k, (t, _) in enumerate(self._left) if t > until_s), len(self._left))
        due, self._left = self._left[:count], self._left[count:]
        return due


def _lines(file: Path, settings: Any) -> Iterator[tuple[float, bytes]]:
    """Times from the first row on, and lines in the order of the column map. Raises InputError with the line."""
    try:
        header, *rows = csv.reader(io.StringIO(recording(file).decode(), newline=""))
    except InputError:
        raise
    except (ValueError, csv.Error) as error:
        raise InputError(f"no table of samples is there ({error})", file=file) from error
    places = [_place(name, header, file) for name in settings.columns]
    begun, clock = None, places[settings.columns.index("t")]
    for line, row in enumerate(rows, 2):
        t_s = number(row[clock or 0]) if len(row) == len(header) else None
        if t_s is None or not math.isfinite(t_s):
            raise InputError("no number stands for its time, or cells are missing", file=file, line=line)
        begun = t_s if begun is None else begun
        yield t_s - begun, (settings.delimiter.join("" if k is None else row[k] for k in places) + "\n").encode()


def _place(name: str, header: list[str], file: Path) -> int | None:
    found = [header.index(n) for n in NAMES.get(name, (name,)) if n in header]
    if not found and name != "-":
        raise InputError(f"the table has no column {name}", file=file, line=1, column=name)
    return found[0] if found else None
