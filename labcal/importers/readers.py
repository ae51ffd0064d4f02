"""The formats of recordings: one row each, the library it needs, and where its reader is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

from labcal.errors import InputError
from labcal.importers.recording import ForeignRecording, ReadRequest
from labcal.store.limits import MiB

MOST_BYTES = 2048 * MiB  # of one recording


@dataclass(frozen=True, slots=True)
class Reader:
    """A format: the module with its `read(path, request)`, and the library it loads, None where it needs none."""

    module: str
    library: str | None = None
    what: str = ""


READERS: Mapping[str, Reader] = {
    "csv": Reader("csv_table", None, "a table of text"),
    "ulog": Reader("ulog", "pyulog", "a PX4 log"),
    "dataflash": Reader("dataflash", "pymavlink", "an ArduPilot log"),
    "rosbag": Reader("rosbag", "rosbags", "a ROS 1 or ROS 2 bag"),
    "mat": Reader("mat", None, "a MATLAB file"),
    "iaga": Reader("iaga", None, "an observatory's IAGA-2002 file"),
    "imagcdf": Reader("imagcdf", "cdflib", "an observatory's ImagCDF file"),
}


def read_recording(path: Path, format_: str, request: ReadRequest) -> ForeignRecording:
    """Read one foreign file. Raises InputError at its first fault, and where the format's library is not installed."""
    reader = READERS[format_]
    _refuse(path, reader)
    read: Callable[[Path, ReadRequest], ForeignRecording] = import_module(f"labcal.importers.{reader.module}").read
    return read(path, request)


def _refuse(path: Path, reader: Reader) -> None:
    if not path.exists():
        raise InputError("there is no such file", file=path)
    if reader.library is not None and find_spec(reader.library) is None:
        what = f"{reader.what} is read by {reader.library}, which is not installed: pip install 'labcal[imports]'"
        raise InputError(what, file=path)
    if path.is_dir() and reader.module == "rosbag":
        return
    if not path.is_file():
        raise InputError(f"expected {reader.what}, found a folder or a device", file=path)
    if path.stat().st_size > MOST_BYTES:
        raise InputError(f"is larger than {MOST_BYTES // MiB} MiB: split the recording", file=path)
    if path.stat().st_size == 0:
        raise InputError("is empty", file=path)
