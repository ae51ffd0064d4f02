"""Frames of a CAN bus, and the database (DBC) that says which holds which signals, read by cantools."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from drivers.framing.listener import Pieces
from labcal.bench.links.canbus import EXTENDED, HEAD, HOW
from labcal.errors import InputError

FIELD_UNITS = {"nT": "nT", "uT": "uT", "µT": "uT", "mG": "mG", "mGauss": "mG", "G": "G", "Gauss": "G"}


@dataclass(frozen=True, slots=True)
class Signal:
    """One signal: the frame's id (as a piece of can:// has it) and the names of its message and its own."""

    frame: int
    message: str
    name: str
    unit: str
    bits: int


@cache
def database(file: str) -> Any:
    """The database in `file`. Raises InputError where it cannot be read, or cantools is not installed."""
    try:
        import cantools
    except ImportError:
        raise InputError(HOW) from None
    try:
        return cantools.database.load_file(Path(file), database_format="dbc")
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}", file=file) from error
    except Exception as error:  # cantools says in many ways what a DBC lacks
        raise InputError(f"is no CAN database: {str(error)[:120]}", file=file) from error


def found(file: str, path: str) -> Signal:
    """The signal `MESSAGE.SIGNAL`. Raises InputError where there is none, or which one it is depends on another."""
    message_name, _, name = path.partition(".")
    try:
        message = database(file).get_message_by_name(message_name)
        signal = message.get_signal_by_name(name)
    except KeyError:
        raise InputError(f"has no signal {path!r}; expected MESSAGE.SIGNAL", file=file) from None
    if signal.multiplexer_ids:
        raise InputError(f"{path} is multiplexed, which labcal does not read", file=file)
    number = message.frame_id | (EXTENDED if message.is_extended_frame else 0)
    return Signal(number, message_name, name, signal.unit or "", signal.length)


def frames(pieces: Pieces) -> list[tuple[float, int, bytes, bytes]]:
    """Stamp, id, whole and data of each frame; what is cut is left out."""
    every = list[tuple[float, int, bytes, bytes]]()
    for stamp, data in pieces:
        while len(data) >= HEAD.size:
            number, length = HEAD.unpack_from(data)
            frame, data = data[: HEAD.size + length], data[HEAD.size + length :]
            if len(frame) == HEAD.size + length:
                every.append((stamp, number, frame, frame[HEAD.size :]))
    return every
