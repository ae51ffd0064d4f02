"""A Leadshine EM2RS drive that turns the platform through a gear."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.modbus_rtu import (
    ILLEGAL_ADDRESS,
    ILLEGAL_VALUE,
    READ_HOLDING,
    WRITE_REGISTER,
    WRITE_REGISTERS,
    Refused,
    RtuSlave,
)

PULSES, STATUS, ALARM, COMMANDED, TRIGGER, PATH = 0x0001, 0x1003, 0x2203, 0x602A, 0x6002, 0x6200
FAULT, ENABLED, RUNNING, COMMAND_DONE, PATH_DONE, HOMED = 1, 2, 4, 16, 32, 64
HOME_RPM, HOME_RPMS = 0x600F, (150, 30)
WORDS, AT_ONCE = 8, PATH + 7  # of a path; the last of them triggers


class LeadshineEmulator(RtuSlave):
    """Holds path 0, written whole or in parts, and runs it when its last word or the trigger says so.

    A stopped path is not complete.
    """

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(settings.address, self._get, self._put, delay_s=0.008)
        self._platform, self._pulses_per_turn = lab.platform, settings.pulses_per_turn
        self._pulses_per_deg, self._gear = settings.pulses_per_turn * settings.gear / 360, settings.gear
        self._path, self._homed, self._done, self.alarm = [0] * WORDS, False, False, 0

    def _get(self, t_s: float, function: int, address: int, count: int) -> list[int]:
        position = divmod(round(self._platform.now(t_s)[0] * self._pulses_per_deg) & 0xFFFFFFFF, 0x10000)
        known = {PULSES: self._pulses_per_turn, STATUS: self._status(t_s), ALARM: self.alarm, TRIGGER: 0}
        known |= dict(enumerate((*position, *position), COMMANDED)) | dict(enumerate(self._path, PATH))
        known |= dict(enumerate(HOME_RPMS, HOME_RPM))
        if function != READ_HOLDING or not all(address + k in known for k in range(count)):
            raise Refused(ILLEGAL_ADDRESS)
        return [known[address + k] for k in range(count)]

    def _status(self, t_s: float) -> int:
        resting = COMMAND_DONE | (PATH_DONE if self._done else 0)
        moving = self._platform.moving(t_s)
        return ENABLED | (RUNNING if moving else resting) | (HOMED if self._homed else 0) | (FAULT if self.alarm else 0)

    def _put(self, t_s: float, function: int, address: int, values: list[int]) -> None:
        written = dict(enumerate(values, address))
        known = written.keys() <= {TRIGGER, *range(PATH, PATH + WORDS)}
        if function not in (WRITE_REGISTER, WRITE_REGISTERS) or not known:
            raise Refused(ILLEGAL_ADDRESS)
        for at in written.keys() - {TRIGGER, AT_ONCE}:
            self._path[at - PATH] = written[at]
        for at in (TRIGGER, AT_ONCE):
            if written.get(at):
                self._trigger(t_s, written[at])

    def _trigger(self, t_s: float, code: int) -> None:
        match code:
            case 0x0010 if self._path[0] == 1 and self._path[3]:
                _, high, low, rpm, *_ = self._path
                pulses = (high << 16 | low) - (high >> 15 << 32)
                self._platform.move(t_s, pulses / self._pulses_per_deg, rpm * 6 / self._gear)
                self._done = True
            case 0x0020:
                self._platform.move(t_s, 0.0, HOME_RPMS[0] * 6 / self._gear)
                self._homed = True
            case 0x0040:
                self._platform.stop(t_s)
                self._done = False
            case _:
                raise Refused(ILLEGAL_VALUE)
