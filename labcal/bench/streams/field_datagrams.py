"""labcal-field/1: the fields that a simulator wants, one a datagram (docs/field-source.md)."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.bench.links import quoted
from labcal.errors import InstrumentError
from labcal.record.physical import LARGEST_FIELD_nT

Array = NDArray[np.float64]
NAME, LONGEST = b"labcal-field/1,", 200
NUMBER = re.compile(r"-?[0-9]{1,15}(\.[0-9]{0,15})?([eE][+-]?[0-9]{1,2})?")
REMEDY = "Look at the simulator; nothing it sends is taken until play-field is begun anew."


@dataclass(frozen=True, slots=True, eq=False)
class WantedField:
    """One field `b_nT` (3,) in C, of the source's own time `t_s`; it came at `arrived_s` of the bench's clock."""

    number: int
    t_s: float
    b_nT: Array
    arrived_s: float


@dataclass(frozen=True, slots=True)
class EndOfSource:
    """The source says that it has no more."""

    number: int


def parse(data: bytes, arrived_s: float) -> WantedField | EndOfSource | None:
    """What a datagram says; None for one that does not begin as ours do. Raises InstrumentError (wrong reply)."""
    if not data.startswith(NAME):
        return None
    words = data[:LONGEST].decode("ascii", "replace").rstrip("\r\n").split(",")[1:]
    if len(data) > LONGEST or not re.fullmatch("[0-9]{1,15}", words[0]):
        raise _no_field(data)
    if words[1:] == ["end"]:
        return EndOfSource(int(words[0]))
    if len(words) != 5 or not all(NUMBER.fullmatch(word) for word in words[1:]):
        raise _no_field(data)
    t_s, *b_nT = map(float, words[1:])
    if max(map(abs, b_nT)) > LARGEST_FIELD_nT or abs(t_s) > 1e12:
        raise _no_field(data)
    return WantedField(int(words[0]), t_s, np.array(b_nT), arrived_s)


def answer(number: int, latency_s: float, b_nT: Array) -> bytes:
    """What the source gets when its field stands: how long that took, and what the currents read back make."""
    return NAME + b"set,%d,%.4f,%.1f,%.1f,%.1f\n" % (number, latency_s, *b_nT.tolist())


def _no_field(data: bytes) -> InstrumentError:
    return InstrumentError(
        f"the field source sent {quoted(data)}: no number, time and three fields in nT.",
        fault="wrong reply",
        remedy=REMEDY,
    )
