"""Links: how bytes reach an instrument. The only place that imports serial and pymodbus."""

from __future__ import annotations

from labcal.bench.clock import Clock
from labcal.bench.links.emulated import EmulatedLink, Emulator
from labcal.bench.links.line import Link, read_reply
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InputError

__all__ = ["EmulatedLink", "Emulator", "Link", "ModbusLink", "open_link", "read_reply"]


def open_link(url: str, clock: Clock) -> Link:
    """Open a link by its URL. Raises InputError for a scheme that is not known."""
    raise InputError(f"link {url!r}: only emulated:// is known yet")
