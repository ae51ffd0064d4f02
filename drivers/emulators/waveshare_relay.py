"""A Waveshare 8-channel Modbus relay board whose contacts reverse the coils of the twin."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.modbus_rtu import (
    ILLEGAL_ADDRESS,
    ILLEGAL_VALUE,
    READ_COILS,
    READ_HOLDING,
    WRITE_COIL,
    WRITE_COILS,
    Refused,
    RtuSlave,
)

CHANNELS, ALL, VERSION, ADDRESS = 8, 0xFF, 0x8000, 0x4000


class WaveshareEmulator(RtuSlave):
    """Relay n on: the coil wired to it is reversed. Who asks all boards for an address or a version is answered."""

    more, of_all = (WRITE_COILS,), (READ_HOLDING,)

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(settings.address, self._get, self._put)
        wired = {axis: getattr(settings, axis) for axis in "xyz"}
        self._coils = {relay: lab.coils[axis] for axis, relay in wired.items() if relay is not None}
        self._on = [False] * CHANNELS

    def _get(self, t_s: float, function: int, address: int, count: int) -> list[int]:
        if function == READ_COILS and address + count <= CHANNELS:
            return [int(on) for on in self._on[address : address + count]]
        if function != READ_COILS and count == 1 and address in (known := {VERSION: 300, ADDRESS: self.device}):
            return [known[address]]
        raise Refused(ILLEGAL_ADDRESS)

    def _put(self, t_s: float, function: int, address: int, values: list[int]) -> None:
        if function == WRITE_COIL and values[0] not in (0xFF00, 0x0000):
            raise Refused(ILLEGAL_VALUE)
        if (function, address) == (WRITE_COIL, ALL):
            address, values = 0, values * CHANNELS
        if function not in (WRITE_COIL, WRITE_COILS) or address + len(values) > CHANNELS:
            raise Refused(ILLEGAL_ADDRESS)
        for relay, value in enumerate(values, address):
            self._on[relay] = bool(value)
            if relay in self._coils:
                self._coils[relay].reverse(t_s, -1 if value else 1)
