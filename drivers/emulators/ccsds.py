"""A DUT that sends a space packet a sample, with its own clock in the secondary header."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from itertools import count
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.streaming import Talker, dut_rows
from drivers.framing import ccsds, cobs, slip
from drivers.framing.crc16 import crc16


class CcsdsEmulator(Talker):
    """Counts its packets from zero, modulo 16384."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._settings, self._count = settings, count()
        super().__init__(dut_rows(lab, settings.columns, settings), self._packet)

    def _packet(self, t_s: float, row: list[float]) -> bytes:
        s = self._settings
        kinds = struct.unpack(s.layout, bytes(struct.calcsize(s.layout)))
        numbers = [round(v) if isinstance(kind, int) else v for kind, v in zip(kinds, row, strict=True)]
        data = own_time(s, t_s) + struct.pack(s.layout, *numbers)
        packet = ccsds.build(s.apid, next(self._count), data + b"\0\0" * s.crc, secondary=s.time != "none")
        if s.crc:
            packet = packet[:-2] + crc16(packet[:-2]).to_bytes(2, "big")
        return slip.encode(packet) if s.framing == "slip" else cobs.encode(packet) if s.framing == "cobs" else packet


def own_time(settings: Any, t_s: float) -> bytes:
    """The secondary header: the DUT's clock, which began with the bench's."""
    if settings.time == "cuc":
        ticks: int = round(t_s * 256**settings.cuc_fine)
        return ticks.to_bytes(4 + settings.cuc_fine, "big")
    return (0).to_bytes(2, "big") + round(t_s * 1000).to_bytes(4, "big") if settings.time == "cds" else b""
