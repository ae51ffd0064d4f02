"""An instrument as 16-bit registers: who asks for them, a number among them, two of them as one signed number."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import quantity
from labcal.errors import LimitError

if TYPE_CHECKING:
    from labcal.bench.links.modbus import ModbusLink

HALF_A_COUNT = 0.501


class Registers:
    """The registers and coils of one device on a Modbus line; `gap_s` is the least time between two requests."""

    def __init__(self, link: ModbusLink, clock: Clock, device: int, gap_s: float) -> None:
        self._link, self._clock, self._device, self._gap_s, self._free_s = link, clock, device, gap_s, 0.0

    def read(self, address: int, count: int) -> list[int]:
        """FC 03."""
        return self._in_turn().read_holding(self._device, address, count)

    def write(self, address: int, value: int) -> None:
        """FC 06, sent once."""
        self._in_turn().write_register(self._device, address, value)

    def write_block(self, address: int, values: Sequence[int]) -> None:
        """FC 16, sent once."""
        self._in_turn().write_registers(self._device, address, values)

    def switch(self, address: int, on: bool) -> None:
        """FC 05, sent once."""
        self._in_turn().write_coil(self._device, address, on)

    def write_unacknowledged(self, address: int, value: int) -> None:
        """FC 06; the reply is dropped, or is late."""
        self._in_turn().write_register_unacknowledged(self._device, address, value)

    def switch_unacknowledged(self, address: int, on: bool) -> None:
        """FC 05; the reply is dropped, or is late."""
        self._in_turn().write_coil_unacknowledged(self._device, address, on)

    def close(self) -> None:
        """Let go of the line."""
        self._link.close()

    def _in_turn(self) -> ModbusLink:
        self._clock.wait_until(self._free_s)
        self._free_s = self._clock.now() + self._gap_s
        return self._link


class register(quantity):
    """A number in `unit`, kept at `address` as a count: value = count / `counts`(device), rounded to the nearest.

    The device has `registers`. Setting behaves as that of `quantity`; what is
    read back may differ by the rounding only. A value that needs more than `top` counts raises LimitError.
    """

    def __init__(
        self,
        address: int,
        *,
        unit: str,
        doc: str,
        counts: Callable[[Any], float] = lambda device: 1.0,
        limits: Callable[[Any], tuple[float, float]] | None = None,
        top: int = 0xFFFF,
    ) -> None:
        super().__init__(f"{address}", f"{address}" if limits else "", unit=unit, doc=doc, limits=limits)
        self.address, self.counts, self.top = address, counts, top

    def _ask(self, device: Any) -> float:
        return float(device.registers.read(self.address, 1)[0] / self.counts(device))

    def _command(self, device: Any, value: float) -> None:
        device.registers.write(self.address, self._count(device, value))

    def _send(self, device: Any, value: float) -> None:
        count = self._count(device, value) if value else 0  # of any model: zero does not wait for who answers
        device.registers.write_unacknowledged(self.address, count)

    def _count(self, device: Any, value: float) -> int:
        counts = self.counts(device)
        if round(value * counts) > self.top:
            raise LimitError(
                f"{device.name}: {self.label} {value:g} {self.unit} is beyond the {self.top / counts:g} {self.unit} "
                "that its register holds; nothing was sent."
            )
        return round(value * counts)

    def _agrees(self, device: Any, value: float, held: float) -> bool:
        return abs(held - value) <= HALF_A_COUNT / self.counts(device)


def words(value: int) -> list[int]:
    """A signed 32-bit number as two registers, high word first. Raises LimitError beyond 32 bits."""
    if not -(2**31) <= value < 2**31:
        raise LimitError(f"{value} does not fit into 32 bits; nothing was sent.")
    return list(divmod(value & 0xFFFFFFFF, 0x10000))


def signed(pair: Sequence[int]) -> int:
    """Two registers, high word first, as a signed 32-bit number."""
    high, low = pair
    value = high << 16 | low
    return value - (value >> 31 << 32)
