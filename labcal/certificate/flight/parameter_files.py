"""Parameters of autopilots read back: what their first compass is corrected by, as A and b of `labcal.…foreign`.

PX4 (1.11 and later) corrects b = S (m − o) [gauss], ArduPilot b = S s (m + o) [milligauss]; S is symmetric, s
`COMPASS_SCALE`. A line names its parameter and then its value, apart by commas, blanks or tabs, as QGroundControl and
Mission Planner write them. What stands there beside and is not taken is named.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from labcal.errors import InputError

NAME = re.compile(r"[A-Z][A-Z0-9_]{2,31}")
APART = re.compile(r"[,;\s]+")


@dataclass(frozen=True, slots=True)
class Autopilot:
    """How its parameters are called: of each axis offset, diagonal and off-diagonal (xy, xz, yz), and what is left."""

    unit: str
    offsets: tuple[str, ...]
    diagonal: tuple[str, ...]
    off_diagonal: tuple[str, ...]
    offset_is_added: bool
    left: Mapping[str, str]  # by the beginning of a name: what it does
    scale: str = ""


AUTOPILOTS = {
    "px4": Autopilot(
        "G",
        tuple(f"CAL_MAG0_{a}OFF" for a in "XYZ"),
        tuple(f"CAL_MAG0_{a}SCALE" for a in "XYZ"),
        tuple(f"CAL_MAG0_{a}ODIAG" for a in "XYZ"),
        False,
        {
            "CAL_MAG0_ROT": "the sensor's turn on the board",
            **{f"CAL_MAG0_{a}COMP": "what follows the power" for a in "XYZ"},
        },
    ),
    "ardupilot": Autopilot(
        "mG",
        tuple(f"COMPASS_OFS_{a}" for a in "XYZ"),
        tuple(f"COMPASS_DIA_{a}" for a in "XYZ"),
        tuple(f"COMPASS_ODI_{a}" for a in "XYZ"),
        True,
        {
            "COMPASS_ORIENT": "the sensor's turn on the board",
            **{f"COMPASS_MOT_{a}": "what follows throttle or current" for a in "XYZ"},
        },
        "COMPASS_SCALE",
    ),
}


def parameters(content: bytes, kind: str) -> dict[str, Any]:
    """A, b and unit that a parameter file states, and under `left` what is not taken. Raises InputError."""
    pilot, stated = AUTOPILOTS[kind], _values(content)
    if missing := [name for name in pilot.offsets if name not in stated]:
        raise InputError(f"{missing[0]} is missing: expected the parameters of {kind}'s first compass, one a line")
    d = [stated.get(name, 1.0) for name in pilot.diagonal]
    x, y, z = (stated.get(name, 0.0) for name in pilot.off_diagonal)
    d = d if any(d) else [1.0] * 3  # ArduPilot's own word for none
    scale = (stated.get(pilot.scale, 0.0) or 1.0) if pilot.scale else 1.0
    matrix = [scale * v for v in (d[0], x, y, x, d[1], z, y, z, d[2])]
    sign = -1.0 if pilot.offset_is_added else 1.0
    left = [f"{name} = {stated[name]:g}: {what}" for name, what in pilot.left.items() if stated.get(name)]
    return {"A": matrix, "b": [sign * stated[name] for name in pilot.offsets], "unit": pilot.unit, "left": left}


def _values(content: bytes) -> dict[str, float]:
    """Every parameter that is one of a compass, by name."""
    try:
        lines = content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        raise InputError("is no text of parameters") from None
    stated = dict[str, float]()
    for number, line in enumerate(lines, start=1):
        words = [word for word in APART.split(line.partition("#")[0].strip()) if word]
        place = next((i for i, word in enumerate(words) if NAME.fullmatch(word)), None)
        if place is None or not words[place].startswith(("CAL_MAG0_", "COMPASS_")):
            continue
        name = words[place]
        if name in stated:
            raise InputError(f"line {number}: states {name} twice")
        stated[name] = _number(words[place + 1 :], name, number)
    return stated


def _number(rest: list[str], name: str, line: int) -> float:
    try:
        value = float(rest[0])
    except (IndexError, ValueError):
        raise InputError(f"line {line}: {name} has no number behind it") from None
    if not math.isfinite(value):
        raise InputError(f"line {line}: {name} is not finite")
    return value
