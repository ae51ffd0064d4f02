"""The supplies at a question, with the coils at zero: one that gives no answer is waited for, as others are."""

from __future__ import annotations

from contextlib import suppress

import numpy as np
from numpy.typing import NDArray

from labcal.bench.coils.cage import Cage
from labcal.bench.streams.reconnect import AWAY
from labcal.bench.streams.watch import RestPoll
from labcal.errors import InstrumentError


def currents_or_away(cage: Cage, look: RestPoll, now_s: float, *, waited_for: bool) -> NDArray[np.float64] | None:
    """Measured signed currents (3,); None where a supply is away while it is `waited_for`: `look` asks it on.

    To wait is as safe as to end the run: no order reaches that supply either way, its guardian lives on, and hands are
    kept off as long as its coil is not read back at zero.
    """
    if not waited_for or not any(look.wrong(supply.name) for supply in cage.supplies.values()):
        try:
            return cage.currents_A()
        except InstrumentError as fault:
            if not waited_for or fault.fault not in AWAY:
                raise
            look.gone(_failed(cage), fault, now_s)  # which is not waited for once more
    for axis, supply in cage.supplies.items():
        if look.wrong(supply.name):
            continue
        try:
            cage.read(axis)
        except InstrumentError as fault:
            if fault.fault not in AWAY:
                raise
            look.gone(supply.name, fault, now_s)
    return None


def _failed(cage: Cage) -> str:
    """The supply of the coil that was just not read."""
    return next(cage.supplies[coil.axis].name for coil in cage.coils() if coil.fault)


def zero_anew(cage: Cage, name: str) -> None:
    """Zero to the supply of this name once it answers again: its guardian tells the loss with that, and then no more.

    Raises InstrumentError where it cannot be read back.
    """
    for axis in (axis for axis, supply in cage.supplies.items() if supply.name == name):
        with suppress(InstrumentError):
            cage.zero()
        cage.read(axis)
