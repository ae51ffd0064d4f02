"""Riden RD6006 supplies, one an axis, that may hang on one RS-485 pair."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.modbus_rtu import (
    ILLEGAL_ADDRESS,
    READ_HOLDING,
    WRITE_REGISTER,
    WRITE_REGISTERS,
    Refused,
    RtuPair,
    RtuSlave,
)

PER_V, PER_A = 100, 1000
REGISTERS = 120  # all are there to be read, in blocks as long as one likes
V, I, OUTPUT, OVP, OCP = 8, 9, 18, 82, 83  # noqa: E741  the symbols of the manual
FIXED = {0: 60062, 1: 0, 3: 135, 4: 0, 5: 27, 14: 2410, 15: 0, 20: 0, 68: 0}


class RidenEmulator(RtuPair):
    """Every supply of the pair, each at its own address."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(
            Riden(lab.coils[role[-1]], own.get("address", settings.address), 20_000 + ord(role[-1])).slave
            for role, own in roles.items()
        )


class Riden:
    """One supply and the coil behind it; over-voltage and over-current end the output."""

    def __init__(self, coil: Any, address: int, serial: int) -> None:
        self._coil, self._protection = coil, 0
        self._held = {V: 0, I: 0, OUTPUT: 0, OVP: 6200, OCP: 6200}
        self._fixed = {**FIXED, 2: serial}
        self.slave = RtuSlave(address, self._get, self._put, delay_s=0.06)

    def _get(self, t_s: float, function: int, address: int, count: int) -> list[int]:
        current = self._coil.current.now(t_s)
        voltage = current * self._coil.resistance_ohm
        power = round(voltage * current * 100)
        measured = {10: voltage * PER_V, 11: current * PER_A, 12: power >> 16, 13: power & 0xFFFF, 16: self._protection}
        limited = self._held[OUTPUT] and voltage * PER_V > self._held[V] - 1
        known = {**self._fixed, **self._held, **measured, 17: int(not limited)}
        if function != READ_HOLDING or address + count > REGISTERS:
            raise Refused(ILLEGAL_ADDRESS)
        return [round(known.get(address + k, 0)) for k in range(count)]

    def _put(self, t_s: float, function: int, address: int, values: list[int]) -> None:
        written = dict(enumerate(values, address))
        if function not in (WRITE_REGISTER, WRITE_REGISTERS) or not written.keys() <= self._held.keys():
            raise Refused(ILLEGAL_ADDRESS)
        self._held |= written
        if OUTPUT in written:
            self._protection = 0
        if self._held[OUTPUT]:
            self._protection = 1 if self._held[V] > self._held[OVP] else 2 if self._held[I] > self._held[OCP] else 0
            self._held[OUTPUT] = int(not self._protection)
        self._coil.drive(t_s, self._held[I] / PER_A, self._held[V] / PER_V, bool(self._held[OUTPUT]))
