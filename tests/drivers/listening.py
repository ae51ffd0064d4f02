"""A line on which somebody talks, for the tests of drivers that listen."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Any, get_type_hints

from labcal.bench.clock import VirtualClock
from labcal.bench.links import EmulatedLink
from labcal.record.stream import Block


class Sender:
    """Puts given pieces on the line at given times."""

    def __init__(self, pieces: list[tuple[float, bytes]]) -> None:
        self.pieces = pieces

    def take(self, t_s: float, data: bytes) -> None:
        raise AssertionError("nothing may be sent to what is only listened to")

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        due = [p for p in self.pieces if p[0] <= until_s]
        self.pieces = self.pieces[len(due) :]
        return due


def listening(driver: Any, pieces: list[tuple[float, bytes]], **settings: object) -> Any:
    """The driver on a line where `pieces` come."""
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    link = EmulatedLink("emulated://line", Sender(pieces), clock)
    return driver("dut", link, clock, get_type_hints(driver.__init__)["settings"](**settings))


def heard(driver: Any, pieces: list[tuple[float, bytes]], **settings: object) -> tuple[list[Block], dict[str, int]]:
    """All blocks of a driver that hears `pieces`, and what was lost by kind."""
    listener = listening(driver, [], **settings)
    listener.start()
    listener._link._emulator.pieces = pieces
    blocks = listener.read_until(1e6)
    return blocks, {e.data["fault"]: e.data["lost"] for e in listener.events()}


def cut(data: bytes, sizes: list[int]) -> list[tuple[float, bytes]]:
    """The bytes in pieces of these sizes, over and over."""
    pieces, at = [], 0
    while at < len(data):
        size = sizes[len(pieces) % len(sizes)]
        pieces.append((0.001 * len(pieces), data[at : at + size]))
        at += size
    return pieces
