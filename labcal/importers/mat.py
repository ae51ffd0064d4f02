"""MATLAB's files up to version 7, by scipy: a column is a variable, a field of a struct, or `name[0]` of a matrix."""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from pathlib import Path
from struct import unpack
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.importers.recording import ForeignRecording, ReadRequest, Stream, strictly_known, unreadable
from labcal.store.limits import FREELY, INFLATED, MOST_COLUMNS, MiB

Array = NDArray[np.float64]

HEAD, TAG, COMPRESSED = 128, 8, 15  # bytes, and the type of a compressed element ("MAT-File Format", 1-9)
MOST_INFLATED = 2048 * MiB
DEEPEST, WIDEST = 8, 64  # structs within structs; columns of a matrix that are signals


def read(path: Path, request: ReadRequest) -> ForeignRecording:
    """The numbers of the file as the stream ""; they need not be of equal length. Raises InputError."""
    from scipy.io import loadmat

    _refuse_what_grows(path)
    try:
        content = loadmat(path, simplify_cells=True)
    except NotImplementedError:
        raise InputError("is of version 7.3 (HDF5): save it with -v7", file=path) from None
    except Exception as error:  # whatever a damaged file makes of the parser
        raise unreadable("not a readable MATLAB file", error, path) from None
    found = {
        k: v[: request.most_rows] for name, value in content.items() if name[:2] != "__" for k, v in _flat(value, name)
    }
    strictly_known(found, MOST_COLUMNS, "columns", path)
    if not found:
        raise InputError("holds no arrays of numbers", file=path)
    return ForeignRecording(path, {"": Stream("", path, found)})


def _flat(value: Any, name: str, depth: int = 0) -> Iterator[tuple[str, Array]]:
    """Arrays of real numbers by name: a matrix, whichever way it lies, is cut along its shorter side."""
    if isinstance(value, dict) and depth < DEEPEST:
        for key, part in value.items():
            yield from _flat(part, f"{name}.{key}", depth + 1)
    if not isinstance(value, np.ndarray) or value.dtype.kind not in "fiub" or not value.size:
        return
    if value.ndim == 1:
        yield name, value.astype(float)
    elif value.ndim == 2 and min(value.shape) <= WIDEST:
        columns = value if value.shape[0] >= value.shape[1] else value.T
        yield from ((f"{name}[{i}]", column.astype(float)) for i, column in enumerate(columns.T))


def _refuse_what_grows(path: Path) -> None:
    """Raise InputError where a compressed element is far larger than a recording's, before anything is kept of it."""
    total = 0
    with path.open("rb") as file:
        head = file.read(HEAD)
        order = "<" if head[126:128] == b"IM" else ">"
        while len(tag := file.read(TAG)) == TAG and head[124:126] in (b"\x00\x01", b"\x01\x00"):
            kind, size = unpack(f"{order}II", tag)
            if kind != COMPRESSED:
                file.seek(size, 1)
                continue
            data = file.read(size)
            total += _inflated(data, max(FREELY, INFLATED * len(data)), path)
            if total > MOST_INFLATED:
                raise InputError(f"holds more than {MOST_INFLATED // MiB} MiB: split it", file=path)


def _inflated(data: bytes, most: int, path: Path) -> int:
    """How many bytes `data` grows to. Raises InputError beyond `most`; a damaged part is the parser's to tell."""
    stream, grown, rest = zlib.decompressobj(), 0, data
    try:
        while rest and not stream.eof:
            grown += len(stream.decompress(rest, MiB))
            rest = stream.unconsumed_tail
            if grown > most:
                raise InputError(f"a variable would grow from {len(data)} to over {most} bytes", file=path)
    except zlib.error:
        return grown
    return grown
