"""ArduPilot's logs, by pymavlink: a stream is a kind of message, with its instance where it has one: `MAG:0`."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress
from pathlib import Path
from typing import Any

import numpy as np

from labcal.errors import InputError
from labcal.importers.recording import ForeignRecording, ReadRequest, Stream, unreadable
from labcal.store.limits import MOST_CELLS

BINARY = b"\xa3\x95"  # every message of a binary log begins so
ON_BOARD = ("COMPASS_OFS", "COMPASS_DIA", "COMPASS_ODI", "COMPASS_MOT", "COMPASS_SCALE")


def read(path: Path, request: ReadRequest) -> ForeignRecording:
    """The messages that are wanted; `TimeUS` is in µs since the autopilot began. Raises InputError."""
    kept = _Kept(path, request)
    try:
        with _quiet(), _opened(path) as log:
            while (message := log.recv_msg()) is not None:
                kept.take(message)
    except InputError:
        raise
    except Exception as error:  # whatever a damaged file makes of the parser
        raise unreadable("not a readable ArduPilot log", error, path) from None
    return kept.recording()


@contextmanager
def _quiet() -> Iterator[None]:
    """Without what the parser, partly in C, prints of a file that it does not like."""
    sys.stderr.flush()
    kept = os.dup(2)
    try:
        with open(os.devnull, "w") as nowhere, redirect_stdout(nowhere), redirect_stderr(nowhere):
            os.dup2(nowhere.fileno(), 2)
            yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)


@contextmanager
def _opened(path: Path) -> Iterator[Any]:
    """The parser of a binary or a text log; its file is closed though it cannot be parsed."""
    from pymavlink.DFReader import DFReader_binary, DFReader_text

    with path.open("rb") as file:
        kind = DFReader_binary if file.read(len(BINARY)) == BINARY else DFReader_text
    log = kind.__new__(kind)
    try:
        log.__init__(str(path), zero_time_base=True)
        yield log
    finally:
        for part in ("filehandle", "data_map"):
            with suppress(AttributeError, BufferError):  # an error that is reported may still look at the map
                getattr(log, part).close()


class _Kept:
    def __init__(self, path: Path, request: ReadRequest) -> None:
        self._path, self._request = path, request
        self._kinds = None if request.wanted is None else {key.partition(":")[0] for key in request.wanted}
        self._rows: dict[str, list[tuple[float, ...]]] = {}
        self._fields: dict[str, list[str]] = {}
        self._parameters: dict[str, float] = {}
        self._cells = 0

    def take(self, message: Any) -> None:
        kind = message.get_type()
        if kind == "PARM" and str(message.Name).startswith(ON_BOARD):
            self._parameters[str(message.Name)] = float(message.Value)
        if kind in ("FMT", "PARM", "FMTU", "UNIT", "MULT") or (self._kinds is not None and kind not in self._kinds):
            return
        stated = {n: v for n in message.get_fieldnames() if isinstance(v := getattr(message, n), int | float)}
        name = f"{kind}:{stated['I']:g}" if "I" in stated else kind
        fields = self._fields.setdefault(name, list(stated))
        rows = self._rows.setdefault(name, [])
        if self._request.most_rows is not None and len(rows) >= self._request.most_rows:
            return
        rows.append(tuple(float(stated.get(field, np.nan)) for field in fields))
        self._cells += len(fields)
        if self._cells > MOST_CELLS // 10:
            raise InputError(f"has more than {MOST_CELLS // 10_000_000} million values: split it", file=self._path)

    def recording(self) -> ForeignRecording:
        streams = {}
        for name, rows in self._rows.items():
            table = np.array(rows)
            columns = {field: np.ascontiguousarray(table[:, i]) for i, field in enumerate(self._fields[name])}
            streams[name] = Stream(name, self._path, columns)
        if not streams:
            raise InputError("the log holds none of the messages asked for", file=self._path)
        parameters = ", ".join(f"{name} {value:.6g}" for name, value in sorted(self._parameters.items()))
        return ForeignRecording(self._path, streams, notes=(f"on board: {parameters}",) if parameters else ())
