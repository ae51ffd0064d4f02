"""ROS bags (1 and 2), by rosbags, without any ROS: a stream is a topic, a column a field such as `magnetic_field.x`."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from labcal.errors import InputError
from labcal.importers.recording import ForeignRecording, ReadRequest, Stream, unreadable
from labcal.store.limits import MOST_CELLS, MOST_COLUMNS

RECEIVED = "received"  # when the bag got the message, s since 1970
LONGEST = 16  # of an array of numbers that becomes columns: a covariance has 9


def read(path: Path, request: ReadRequest) -> ForeignRecording:
    """The topics that are wanted; `header.stamp` and `received` are in s. Raises InputError."""
    from rosbags.highlevel import AnyReader
    from rosbags.typesys import Stores, get_typestore

    if path.is_dir() and not (path / "metadata.yaml").is_file():
        raise InputError("is a folder without the metadata.yaml of a bag: name a file in it", file=path)
    rows: dict[str, list[dict[str, float]]] = {}
    try:
        with AnyReader([path], default_typestore=get_typestore(Stores.ROS2_HUMBLE)) as bag:
            asked = [c for c in bag.connections if request.wanted is None or c.topic in request.wanted]
            for connection, stamp, raw in bag.messages(asked) if asked else ():
                kept = rows.setdefault(connection.topic, [])
                if request.most_rows is None or len(kept) < request.most_rows:
                    kept.append(_row(bag.deserialize(raw, connection.msgtype), stamp))
                    _refuse_too_many(rows, path)
    except InputError:
        raise
    except Exception as error:  # whatever a damaged file makes of the parser
        raise unreadable("not a readable bag", error, path) from None
    if not rows:
        raise InputError("the bag holds none of the topics asked for", file=path)
    streams = {topic: _stream(topic, kept, path) for topic, kept in rows.items()}
    first = min(stream.numbers[RECEIVED][0] for stream in streams.values())
    return ForeignRecording(path, streams, datetime.fromtimestamp(first, UTC).isoformat().replace("+00:00", "Z"))


def _row(message: Any, received_ns: int) -> dict[str, float]:
    return {RECEIVED: received_ns * 1e-9, **dict(_flat(message, ""))}


def _flat(value: Any, name: str) -> Iterator[tuple[str, float]]:
    """The numbers of a message by the path of their fields; a stamp becomes seconds, a short array columns."""
    if is_dataclass(value) and hasattr(value, "sec") and hasattr(value, "nanosec"):
        yield name, value.sec + value.nanosec * 1e-9
    elif is_dataclass(value):
        for field in fields(value):
            if not field.name.startswith("__"):
                yield from _flat(getattr(value, field.name), f"{name}.{field.name}" if name else field.name)
    elif isinstance(value, bool | int | float | np.number):
        yield name, float(value)
    elif isinstance(value, np.ndarray) and value.ndim == 1 and len(value) <= LONGEST:
        yield from ((f"{name}[{i}]", float(x)) for i, x in enumerate(value))


def _refuse_too_many(rows: dict[str, list[dict[str, float]]], path: Path) -> None:
    last = next(reversed(rows.values()))
    if len(last[-1]) > MOST_COLUMNS or len(last) * len(last[-1]) > MOST_CELLS // 10:
        raise InputError("a topic has more numbers than any recording: split the bag", file=path)


def _stream(topic: str, rows: list[dict[str, float]], path: Path) -> Stream:
    names = dict.fromkeys(name for row in rows for name in row)
    return Stream(topic, path, {name: np.array([row.get(name, np.nan) for row in rows]) for name in names})
