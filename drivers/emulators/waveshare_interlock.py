"""A Waveshare board one relay of which closes the circuits of all coils of the twin, for a time that it counts."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.modbus_rtu import (
    ILLEGAL_ADDRESS,
    ILLEGAL_VALUE,
    READ_COILS,
    READ_HOLDING,
    WRITE_COIL,
    Refused,
    RtuSlave,
)

CHANNELS, FLASH_ON, VERSION, TICK_S = 8, 0x0200, 0x8000, 0.1
ON, OFF = 0xFF00, 0x0000


class InterlockEmulator(RtuSlave):
    """`retriggers`: whether a pulse begins anew with the next; `endless`: whether it has no end.

    The contact counts as bridged until it is first told something: on a bench that is emulated altogether no guardian
    beats.
    """

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(settings.address, self._get, self._put)
        self._coils, self._wired = lab.coils, settings.relay
        self._until_s = [-math.inf] * CHANNELS
        self.retriggers, self.endless = True, False

    def _get(self, t_s: float, function: int, address: int, count: int) -> list[int]:
        if function == READ_COILS and address + count <= CHANNELS:
            return [int(t_s < until) for until in self._until_s[address : address + count]]
        if function == READ_HOLDING and (address, count) == (VERSION, 1):
            return [300]
        raise Refused(ILLEGAL_ADDRESS)

    def _put(self, t_s: float, function: int, address: int, values: list[int]) -> None:
        relay = address & 0xFF
        if function != WRITE_COIL or address - relay not in (0, FLASH_ON) or relay >= CHANNELS:
            raise Refused(ILLEGAL_ADDRESS)
        if address >= FLASH_ON:
            self._flash(t_s, relay, values[0] * TICK_S)
        elif values[0] in (ON, OFF):
            self._until(t_s, relay, math.inf if values[0] else t_s)
        else:
            raise Refused(ILLEGAL_VALUE)

    def _flash(self, t_s: float, relay: int, seconds: float) -> None:
        if self.retriggers or t_s >= self._until_s[relay]:
            self._until(t_s, relay, math.inf if self.endless else t_s + seconds)

    def _until(self, t_s: float, relay: int, until_s: float) -> None:
        self._until_s[relay] = until_s
        if relay == self._wired:
            for coil in self._coils.values():
                coil.close(t_s, "interlock", until_s)
