"""Numbers of an instrument that lie in 16-bit registers: the declaration, and two words as one signed number."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from labcal.bench.instrument import quantity
from labcal.errors import LimitError

HALF_A_COUNT = 0.501


class register(quantity):
    """A number in `unit`, kept at `address` as a count: value = count / `counts`(device), rounded to the nearest.

    The device has `read(address, count)` and `write(address, value)`. Setting behaves as that of `quantity`; what is
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
        return float(device.read(self.address, 1)[0] / self.counts(device))

    def _tell(self, device: Any, value: float) -> None:
        counts = self.counts(device)
        if round(value * counts) > self.top:
            raise LimitError(
                f"{device.name}: {self.label} {value:g} {self.unit} is beyond the {self.top / counts:g} {self.unit} "
                "that its register holds; nothing was sent."
            )
        device.write(self.address, round(value * counts))

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
