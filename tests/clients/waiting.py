"""Waiting for what comes in its own time."""

from __future__ import annotations

import time
from collections.abc import Callable

import serial
from served_benches import Line

LONG_S = 90.0  # a busy machine gets there, a broken one does not


def until(true: Callable[[], bool]) -> None:
    """Wait until it is true."""
    begun = time.monotonic()
    while not true():
        assert time.monotonic() - begun < LONG_S, f"not within {LONG_S:g} s"
        time.sleep(0.02)


def settled(read: Callable[[], float], to: float, within: float = 0.006) -> bool:
    """Whether what is read gets there."""
    until(lambda: abs(read() - to) <= within)
    return True


def heard(line: Line, end: bytes, count: int) -> list[bytes]:
    """So many whole pieces of a stream; the first is dropped, for it may have begun before we came."""
    with serial.Serial(line.path, line.baud, timeout=LONG_S) as port:
        return [port.read_until(end).removesuffix(end) for _ in range(count + 1)][1:]
