"""An EA PSI 9080-60 T: classic series, slave address 0, values as fractions of nominal."""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.modbus_rtu import (
    ILLEGAL_ADDRESS,
    ILLEGAL_VALUE,
    READ_COILS,
    READ_HOLDING,
    WRITE_COIL,
    WRITE_REGISTER,
    Refused,
    RtuSlave,
)

FULL, TOP, IN_LOCAL = 52428, 53477, 0x17
MOST_TRIP = round(1.1 * FULL)  # where its protections stand until somebody lowers them
VOLTS, AMPS, WATTS = 80.0, 60.0, 1500.0
SET_POINTS, TRIPS = (500, 501, 502), (550, 553, 556)
REMOTE, OUTPUT, ACKNOWLEDGE = 402, 405, 411
LIMITS = {9000: TOP, 9001: 0, 9002: TOP, 9003: 0, 9004: TOP}  # U, I, P: largest, and of U and I smallest set-point
BOUNDS = {500: (9001, 9000), 501: (9003, 9002), 502: (None, 9004)}
OUTSIDE = 4


class EaEmulator(RtuSlave):
    """Takes set-points only under remote control; `local` is the lock on its panel.

    `monitoring_s`: the silence, of its menu, after which it leaves remote control and switches off; 0: none does.
    """

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(settings.address, self._get, self._put, delay_s=0.02)
        (role,) = roles
        self._coil, self._location = lab.coils[role[-1]], settings.location
        self._held = dict.fromkeys(SET_POINTS, 0) | dict.fromkeys(TRIPS, MOST_TRIP) | LIMITS
        self._bits = {REMOTE: False, OUTPUT: False}
        self.local = self.alarm = False
        self.monitoring_s, self._ends_s = settings.watchdog_s, math.inf
        nominal = struct.unpack(">6H", struct.pack(">3f", VOLTS, AMPS, WATTS))
        self._fixed = dict(zip(range(121, 127), nominal, strict=True))
        for at, text in ((1, "PSI 9080-60 T"), (21, "Elektro-Automatik"), (151, f"28{ord(role[-1])}30001")):
            self._fixed |= dict(enumerate(struct.unpack(">20H", text.encode().ljust(40, b"\0")), at))

    def _hear(self, t_s: float) -> None:
        if t_s > self._ends_s:
            self._bits = {REMOTE: False, OUTPUT: False}
            self._act(t_s)
        monitored = self.monitoring_s and self._bits[REMOTE]
        self._ends_s = t_s + self.monitoring_s if monitored else math.inf
        self._coil.close(t_s, "monitoring", self._ends_s)

    def _get(self, t_s: float, function: int, address: int, count: int) -> list[int]:
        self._hear(t_s)
        if function == READ_COILS and all(address + k in self._bits for k in range(count)):
            return [int(self._bits[address + k]) for k in range(count)]
        current = self._coil.current.now(t_s)
        voltage = current * self._coil.resistance_ohm
        actual = [voltage / VOLTS, current / AMPS, voltage * current / WATTS]
        state = self._bits[OUTPUT] << 7 | self._bits[REMOTE] << 11 | self.alarm << 15
        state |= self._location if self._bits[REMOTE] else int(self.local)
        known = {**self._fixed, **self._held, 505: 0, 506: state}
        known |= {507 + k: round(FULL * value) for k, value in enumerate(actual)}
        if function != READ_HOLDING or not all(address + k in known for k in range(count)):
            raise Refused(ILLEGAL_ADDRESS)
        return [known[address + k] for k in range(count)]

    def _put(self, t_s: float, function: int, address: int, values: list[int]) -> None:
        self._hear(t_s)
        if self.local or (address != REMOTE and not self._bits[REMOTE]):
            raise Refused(IN_LOCAL)
        if function == WRITE_COIL and address in self._bits:
            self._bits[address] = values[0] == 0xFF00
        elif (function, address) == (WRITE_COIL, ACKNOWLEDGE):
            self.alarm = False
        elif function == WRITE_REGISTER and address in self._held:
            if values[0] > (MOST_TRIP if address in TRIPS else TOP):
                raise Refused(ILLEGAL_VALUE)
            self._refuse_outside(address, values[0])
            self._held[address] = values[0]
        else:
            raise Refused(ILLEGAL_ADDRESS)
        self._act(t_s)
        self._hear(t_s)

    def _refuse_outside(self, address: int, value: int) -> None:
        least, most = BOUNDS.get(address, (None, None))
        if (least and value < self._held[least]) or (most and value > self._held[most]):
            raise Refused(OUTSIDE)

    def _act(self, t_s: float) -> None:
        if self._bits[OUTPUT] and (self._held[500] > self._held[550] or self._held[501] > self._held[553]):
            self.alarm, self._bits[OUTPUT] = True, False
        volts, amps = self._held[500] * VOLTS / FULL, self._held[501] * AMPS / FULL
        self._coil.drive(t_s, amps, volts, self._bits[OUTPUT])
