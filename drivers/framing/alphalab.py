"""AlphaLab's readings of 31 bytes: time, x, y, z and magnitude in blocks of six, and an end sign."""

from __future__ import annotations

import math

LENGTH, END = 31, 0x08
NEGATIVE, DECIMALS = 0x08, 0x07


def axes(frame: bytes, allowed: float, part: float) -> list[float] | None:
    """x, y, z [the meter's unit]; None where the end sign is not there, a block has no data, or the magnitude
    differs from that of the axes by more than `allowed` and `part` of it.
    """
    values = [block(frame[k : k + 6]) for k in range(6, 30, 6)]
    x, y, z, magnitude = (math.nan if v is None else v for v in values)
    fits = abs(math.hypot(x, y, z) - magnitude) <= allowed + part * magnitude  # never true of NaN
    return [x, y, z] if frame[LENGTH - 1] == END and fits else None


def block(six: bytes) -> float | None:
    """Sign and decimal places in the second byte, then 32 bits; None where the first says that there is no data."""
    if six[0] == 0:
        return None
    value = int.from_bytes(six[2:], "big") / 10.0 ** (six[1] & DECIMALS)
    return -value if six[1] & NEGATIVE else value
