"""A Modbus line that supplies share with another instrument: the guardian owns it, the other one speaks through it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from labcal.bench.guardian.client import GuardianClient


class GuardedModbus:
    """What a driver uses of a ModbusLink, for the instrument `name` on one of the guardian's lines."""

    def __init__(self, name: str, guardian: GuardianClient) -> None:
        self._name, self._guardian = name, guardian

    def read_coils(self, device: int, address: int, count: int) -> list[bool]:
        """FC 01."""
        return [bool(bit) for bit in self._call("read_coils", device, address, count)]

    def read_holding(self, device: int, address: int, count: int) -> list[int]:
        """FC 03."""
        return list(self._call("read_holding", device, address, count))

    def read_input(self, device: int, address: int, count: int) -> list[int]:
        """FC 04."""
        return list(self._call("read_input", device, address, count))

    def write_coil(self, device: int, address: int, on: bool) -> None:
        """FC 05."""
        self._call("write_coil", device, address, on)

    def write_register(self, device: int, address: int, value: int) -> None:
        """FC 06."""
        self._call("write_register", device, address, value)

    def write_registers(self, device: int, address: int, values: Sequence[int]) -> None:
        """FC 16."""
        self._call("write_registers", device, address, list(values))

    def reopen(self) -> None:
        """Open the lost line again."""
        self._guardian.ask("reopen", name=self._name)

    def close(self) -> None:
        """The guardian lets go of the line when the session has ended."""

    def _call(self, call: str, *args: Any) -> Any:
        return self._guardian.ask("modbus", name=self._name, call=call, args=list(args))
