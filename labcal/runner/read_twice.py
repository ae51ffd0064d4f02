"""What a coil carries at the end of a run: asked once more where the first answer is a fault."""

from __future__ import annotations

from contextlib import suppress

from labcal.bench.coils.cage import Cage
from labcal.errors import InstrumentError


def read_twice(cage: Cage, axis: str, lost: list[Exception]) -> float | None:
    """The current [A], asked again after an order of zero where the first answer is a fault; None where both are."""
    try:
        return cage.read(axis)
    except InstrumentError as fault:
        lost.append(fault)
    with suppress(InstrumentError):
        cage.supplies[axis].set_current(0.0)
        return cage.read(axis)
    return None
