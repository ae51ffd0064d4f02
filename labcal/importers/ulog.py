"""PX4's logs, by pyulog: a stream is a topic with its instance, such as `vehicle_magnetometer:1`."""

from __future__ import annotations

import io
from contextlib import redirect_stdout
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from labcal.errors import InputError
from labcal.importers.recording import ForeignRecording, ReadRequest, Stream, unreadable

GPS = ("vehicle_gps_position", "sensor_gps")
FIRST_YEAR = 2000  # a receiver without a fix tells 1970 or 1980


def read(path: Path, request: ReadRequest) -> ForeignRecording:
    """The topics that are wanted; `timestamp` is in µs since the autopilot began. Raises InputError."""
    from pyulog import ULog

    names = None if request.wanted is None else sorted({key.partition(":")[0] for key in request.wanted} | {*GPS})
    try:
        with path.open("rb") as file, redirect_stdout(io.StringIO()):  # it prints what it does not like
            log = ULog(file, names)
    except Exception as error:  # whatever a damaged file makes of the parser
        raise unreadable("not a readable ULog file", error, path) from None
    streams = {f"{data.name}:{data.multi_id}": _stream(data, path, request) for data in log.data_list}
    streams |= {name.removesuffix(":0"): stream for name, stream in streams.items() if name.endswith(":0")}
    if not streams:
        raise InputError("the log holds none of the topics asked for", file=path)
    return ForeignRecording(path, streams, _started(log), _on_board(log))


def _stream(data: Any, path: Path, request: ReadRequest) -> Stream:
    names = data.data.keys()
    wanted = [request.of(key) for key in (f"{data.name}:{data.multi_id}", data.name)]
    if all(one is not None for one in wanted):
        names = [name for name in names if any(one and name in one.numbers for one in wanted)]
    kept = {name: np.asarray(data.data[name], dtype=float)[: request.most_rows] for name in names}
    return Stream(f"{data.name}:{data.multi_id}", path, kept)


def _started(log: Any) -> str | None:
    """When the log's first timestamp was, by the satellites' clock; None where no receiver knew."""
    for data in log.data_list:
        if data.name in GPS and "time_utc_usec" in data.data:
            utc, own = (np.asarray(data.data[name], dtype=float) for name in ("time_utc_usec", "timestamp"))
            known = np.flatnonzero(utc > 0)
            if not known.size:
                continue
            try:
                at = datetime.fromtimestamp((utc[known[0]] - own[known[0]] + log.start_timestamp) * 1e-6, UTC)
            except (ValueError, OverflowError, OSError):
                return None
            return at.isoformat(timespec="seconds").replace("+00:00", "Z") if at.year >= FIRST_YEAR else None
    return None


def _on_board(log: Any) -> tuple[str, ...]:
    """The calibration that the autopilot has applied already to what `vehicle_magnetometer` says."""
    stated = {str(name): value for name, value in log.initial_parameters.items() if isinstance(value, int | float)}
    kept = {name: value for name, value in stated.items() if name.startswith("CAL_MAG") and not name.endswith("_ID")}
    if not kept:
        return ()
    return ("on board: " + ", ".join(f"{name} {value:.6g}" for name, value in sorted(kept.items())),)
