"""An Oriental Motor AZ drive with a DG130 table."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.modbus_rtu import (
    DIAGNOSTICS,
    ILLEGAL_ADDRESS,
    ILLEGAL_VALUE,
    READ_HOLDING,
    WRITE_REGISTER,
    WRITE_REGISTERS,
    Refused,
    RtuSlave,
)

DIRECT, INPUTS, OUTPUTS, ALARM, RESET = 0x58, 0x7C, 0x7E, 0x80, 0x180
ABSOLUTE, FROM_COMMAND, FROM_ENCODER, ALL_DATA = 1, 2, 3, 1
POSITIONS = (0xC6, 0xCC, 0x120, 0x122)
READY, ALM, MOVE, IN_POS = 1 << 5, 1 << 7, 1 << 13, 1 << 14
STOP = 1 << 5


class AzEmulator(RtuSlave):
    """Starts a move when direct data arrive with the trigger of all, unless STOP is held; `alarm` is its code."""

    more = (DIAGNOSTICS,)

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(settings.address, self._get, self._put, delay_s=0.006)
        self._platform, self._steps = lab.platform, settings.steps_per_turn
        self._held, self.alarm = False, 0

    def _get(self, t_s: float, function: int, address: int, count: int) -> list[int]:
        position = round(self._platform.now(t_s)[0] * self._steps / 360) & 0xFFFFFFFF
        outputs = (MOVE if self._platform.moving(t_s) else READY | IN_POS) | (ALM if self.alarm else 0)
        known = {OUTPUTS: 0, OUTPUTS + 1: outputs, ALARM: 0, ALARM + 1: self.alarm}
        for at in POSITIONS:
            known[at], known[at + 1] = divmod(position, 0x10000)
        if function != READ_HOLDING or not all(address + k in known for k in range(count)):
            raise Refused(ILLEGAL_ADDRESS)
        return [known[address + k] for k in range(count)]

    def _put(self, t_s: float, function: int, address: int, values: list[int]) -> None:
        if function == WRITE_REGISTERS and (address, len(values)) == (DIRECT, 16):
            self._move(t_s, [high << 16 | low for high, low in zip(values[::2], values[1::2], strict=True)])
        elif (function, address, len(values)) in ((WRITE_REGISTERS, INPUTS, 2), (WRITE_REGISTER, INPUTS + 1, 1)):
            self._held = bool(values[-1] & STOP)
            if self._held:
                self._platform.stop(t_s)
        elif (function, address, len(values)) in ((WRITE_REGISTERS, RESET, 2), (WRITE_REGISTER, RESET + 1, 1)):
            self.alarm = 0 if values[-1] == 1 else self.alarm
        else:
            raise Refused(ILLEGAL_ADDRESS)

    def _move(self, t_s: float, data: list[int]) -> None:
        _, kind, position, speed, *_, trigger = data
        if kind not in (ABSOLUTE, FROM_COMMAND, FROM_ENCODER) or not speed or trigger not in (0, ALL_DATA):
            raise Refused(ILLEGAL_VALUE)
        if trigger and not self._held and not self.alarm:
            from_deg = 0.0 if kind == ABSOLUTE else float(self._platform.now(t_s)[0])
            position -= (position >> 31) << 32
            self._platform.move(t_s, from_deg + position * 360 / self._steps, speed * 360 / self._steps)
