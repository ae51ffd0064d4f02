"""What a recursion hands on where a recording comes in pieces: its states at the row before, and at the last row."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

State = tuple[Any, ...]


@dataclass(slots=True, eq=False)
class Past:
    """Goes with a scene: its first `own` rows are the piece, the others are there to look ahead at only."""

    own: int
    before: Mapping[str, State] = field(default_factory=dict)  # of each recursion by name; empty: nothing went before
    after: dict[str, State] = field(default_factory=dict)  # the same at the piece's last row: the kernel leaves it here
    until_s: float = -float("inf")  # how far ahead a recursion has to see: the kernel states it
