"""What a recursion hands on where a recording comes in pieces: its states at the row before, and at the last row.

Where nothing went before nobody knows its state. What that leaves uncertain is found by letting it begin elsewhere: off
by one standard deviation (`astray`), by what the channel may have been (`ends`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

State = tuple[Any, ...]
ANYWHERE = 3**-0.5  # the standard deviation of a state that lies anywhere between −1 and 1


@dataclass(slots=True, eq=False)
class Past:
    """Goes with a scene: its first `own` rows are the piece, the others are there to look ahead at only."""

    own: int
    before: Mapping[str, State] = field(default_factory=dict)  # of each recursion by name; empty: nothing went before
    after: dict[str, State] = field(default_factory=dict)  # the same at the piece's last row: the kernel leaves it here
    until_s: float = -float("inf")  # how far ahead a recursion has to see: the kernel states it
    astray: float = 0.0  # how far off a state begins that nothing went before, in its standard deviations
    ends: Mapping[str, tuple[float, float]] = field(default_factory=dict)  # between which each channel was seen
