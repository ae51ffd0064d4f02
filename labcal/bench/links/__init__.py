"""Links: how bytes reach an instrument. The only place that imports serial and pymodbus (the latter in `modbus`)."""

from __future__ import annotations

import math

from labcal.bench.clock import Clock
from labcal.bench.links.emulated import EmulatedLink, Emulator, SharedWire
from labcal.bench.links.line import Link, read_reply
from labcal.bench.links.quoting import abridged, quoted
from labcal.bench.links.urls import split
from labcal.bench.links.wired import WiredLink

__all__ = [
    "EmulatedLink", "Emulator", "Link", "Nobody", "SharedWire", "WiredLink", "abridged", "open_link", "quoted",
    "read_reply",
]  # fmt: skip


class Nobody:
    """The other end of manual://: a person, who is asked by prompts and not over a wire."""

    def take(self, t_s: float, data: bytes) -> None:
        """Nobody hears."""

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        """Nobody speaks."""
        return []

    def due_s(self) -> float:
        """Never."""
        return math.inf


def open_link(url: str, clock: Clock) -> Link:
    """Open the byte line of a URL. Raises InputError for a scheme that is not known, InstrumentError (link lost)."""
    scheme, _, _ = split(url)
    return EmulatedLink(url, Nobody(), clock) if scheme == "manual" else WiredLink(url, clock)
