"""AlphaLab's readings of 31 bytes: time, x, y, z and magnitude in blocks of six, and an end sign."""

from __future__ import annotations

import math
from collections.abc import Mapping

from labcal.bench.links import quoted
from labcal.errors import InstrumentError

LENGTH, END = 31, 0x08
NEGATIVE, DECIMALS = 0x08, 0x07
NO_DATA = 0x40
NT = {"MG": 100.0, "MILLIGAUSS": 100.0, "G": 1e5, "GAUSS": 1e5, "UT": 1000.0, "MICROTESLA": 1000.0, "NT": 1.0,
      "NANOTESLA": 1.0}  # fmt: skip


def axes(frame: bytes, allowed: float, part: float) -> list[float] | None:
    """x, y, z [the meter's unit]; None where the end sign is not there, a block has no data, or the magnitude
    differs from that of the axes by more than `allowed` and `part` of it.
    """
    values = [block(frame[k : k + 6]) for k in range(6, 30, 6)]
    x, y, z, magnitude = (math.nan if v is None else v for v in values)
    fits = abs(math.hypot(x, y, z) - magnitude) <= allowed + part * magnitude  # never true of NaN
    return [x, y, z] if frame[LENGTH - 1] == END and fits else None


def block(six: bytes) -> float | None:
    """Sign and decimal places in the second byte, then 32 bits; None where the first says that there is no data.

    Of two programs that read it, one takes 0 for that and the other the bit 40h.
    """
    if six[0] == 0 or six[0] & NO_DATA:
        return None
    value = int.from_bytes(six[2:], "big") / 10.0 ** (six[1] & DECIMALS)
    return -value if six[1] & NEGATIVE else value


def unit_nT(name: str, pairs: Mapping[str, str], stated_nT: float) -> float:
    """The unit [nT] that a list of the meter `name` states; 0 where it states none.

    Raises InstrumentError (wrong set-up) for a unit that is not known, or not `stated_nT` where that is not 0.
    """
    unit = next((value for key, value in pairs.items() if "UNIT" in key), None)
    nT = 0.0 if unit is None else NT.get(unit.upper(), math.nan)
    if nT and nT != (stated_nT or nT):
        why = f"and nT_per_unit is {stated_nT:g}" if stated_nT else "a unit that labcal does not know"
        raise InstrumentError(
            f"{name}: it sends {quoted(unit or '')}, {why}.",
            fault="wrong set-up",
            remedy="Set milligauss on the meter, or take nT_per_unit out of its settings.",
        )
    return nT
