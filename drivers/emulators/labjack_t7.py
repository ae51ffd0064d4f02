"""A LabJack T7 with an analogue fluxgate on three of its inputs."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Lab
from drivers.emulators.modbus_rtu import (
    ILLEGAL_ADDRESS,
    ILLEGAL_FUNCTION,
    ILLEGAL_VALUE,
    READ_HOLDING,
    READ_INPUT,
    WRITE_REGISTERS,
    Refused,
    RtuSlave,
)  # fmt: skip
from drivers.emulators.modbus_tcp import NetworkPort

INPUTS, NO_INPUT_V = 14, -9999.0
RANGES = (10.0, 1.0, 0.1, 0.01)


def words(value: float) -> list[int]:
    """A float32 as two registers, high word first."""
    return list(struct.unpack(">2H", struct.pack(">f", value)))


class LabJackEmulator(RtuSlave):
    """An input that nothing is wired to reads a few microvolts; above its range it reads the range's end."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(settings.address, self._read, self._write, delay_s=0.003)
        self._lab, self._settings, self._sampled_s = lab, settings, -1.0
        self._volts = np.zeros(INPUTS)
        self._kept = {40000 + k: word for k, word in enumerate(words(10.0) * INPUTS)}
        self._kept |= {41000 + n: 199 for n in range(INPUTS)} | {41500 + n: 0 for n in range(INPUTS)}
        facts = {60000: words(7.0), 60004: words(1.0366), 60028: [7, 18_234]}
        self._kept |= {start + k: word for start, pair in facts.items() for k, word in enumerate(pair)}

    def on_network(self) -> NetworkPort:
        """What is met on its network port; in a simulated lab it is spoken to by RTU."""
        return NetworkPort(self)

    def _read(self, t_s: float, function: int, address: int, count: int) -> list[int]:
        if function not in (READ_HOLDING, READ_INPUT):
            raise Refused(ILLEGAL_FUNCTION)
        if address + count <= 2 * INPUTS and address % 2 == count % 2 == 0:
            return [word for n in range(address // 2, (address + count) // 2) for word in words(self._input(t_s, n))]
        if not count or any(k not in self._kept for k in range(address, address + count)):
            raise Refused(ILLEGAL_ADDRESS)
        return [self._kept[k] for k in range(address, address + count)]

    def _write(self, t_s: float, function: int, address: int, values: list[int]) -> None:
        if function != WRITE_REGISTERS:
            raise Refused(ILLEGAL_FUNCTION)
        if any(not 40000 <= k < 42000 or k not in self._kept for k in range(address, address + len(values))):
            raise Refused(ILLEGAL_ADDRESS)
        if address < 41000 and (len(values) != 2 or address % 2 or not any(values == words(v) for v in RANGES)):
            raise Refused(ILLEGAL_VALUE)
        self._kept |= {address + k: word for k, word in enumerate(values)}

    def _input(self, t_s: float, n: int) -> float:
        if t_s > self._sampled_s:
            self._sample(t_s)
        against = self._kept[41000 + n]
        if against != 199 and against != n + 1:
            return NO_INPUT_V
        (most,) = struct.unpack(">f", struct.pack(">2H", self._kept[40000 + 2 * n], self._kept[40001 + 2 * n]))
        return float(np.clip(self._volts[n], -1.01 * most, 1.01 * most))

    def _sample(self, t_s: float) -> None:
        s, self._sampled_s = self._settings, t_s
        field_uT = (self._lab.reference_nT(np.array([t_s])) * self._lab.reference_nT_per_unit / 1000)[0]
        self._volts[list(s.inputs)] = field_uT / np.array(s.uT_per_V) + np.array(s.zero_V)
