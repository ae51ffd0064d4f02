"""The segments of a run by the turn that they are of: about which body axis, in which sense of the field. No Qt."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.gui.viewmodels.number_format import MINUS, TURN, step_title


@dataclass(frozen=True, slots=True, eq=False)
class Turn:
    """`rows` (n,): which readings are of it. `axis`: "x", "y", "z", or "" of what is no turn; `down`: against it."""

    name: str
    axis: str
    down: bool
    rows: NDArray[np.bool_]


def turns_of(segments: Sequence[str], index: NDArray[np.float64]) -> list[Turn]:
    """Those that readings are of, x first; turns of one axis and sense are one."""
    groups: dict[tuple[str, bool], list[int]] = {}
    for at in sorted({int(one) for one in index}):
        found = TURN.match(segments[at])
        groups.setdefault((found[1], found[2] == "-") if found else ("", False), []).append(at)
    ordered = sorted(groups.items(), key=lambda one: (one[0][0] or "~", one[0][1]))
    return [Turn(_name(*key, [segments[at] for at in ats]), *key, np.isin(index, ats)) for key, ats in ordered]


def _name(axis: str, down: bool, segments: Sequence[str]) -> str:
    if len(segments) == 1:
        return step_title(segments[0])
    return f"{axis} {MINUS if down else '+'} ({len(segments)})" if axis else f"… ({len(segments)})"
