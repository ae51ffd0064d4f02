"""A Waveshare 8-channel Modbus relay board whose contacts reverse the coils of the twin."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.modbus_rtu import ILLEGAL_ADDRESS, ILLEGAL_VALUE, READ_COILS, WRITE_COIL, Refused, RtuSlave

CHANNELS, ALL, VERSION, ADDRESS = 8, 0xFF, 0x8000, 0x4000


class WaveshareEmulator(RtuSlave):
    """Relay n on: the coil wired to it is reversed."""

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
        if function != WRITE_COIL or (address >= CHANNELS and address != ALL):
            raise Refused(ILLEGAL_ADDRESS)
        if values[0] not in (0xFF00, 0x0000):
            raise Refused(ILLEGAL_VALUE)
        for relay in range(CHANNELS) if address == ALL else (address,):
            self._on[relay] = values[0] == 0xFF00
            if relay in self._coils:
                self._coils[relay].reverse(t_s, -1 if self._on[relay] else 1)
