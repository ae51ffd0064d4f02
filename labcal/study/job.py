"""One piece of a study: what it rests on, the hash that is its name, and the row that comes of it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

Cell = str | float | int | bool | None
Row = dict[str, Cell]  # of the table: names of columns with their values; a unit stands in the name


@dataclass(frozen=True)
class Job:
    """One job. `settings` are all that its row depends on, as JSON; `labels` the columns that say which it is.

    `places` say where what it reads lies, and are not in the hash: a run keeps its name where its folder moves.
    """

    kind: str
    settings: Mapping[str, Any]
    labels: Mapping[str, Cell] = field(default_factory=dict)
    places: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def key(self) -> str:
        """SHA-256 of kind and settings: the same work has the same name wherever it is done."""
        return hashlib.sha256(canonical([self.kind, dict(self.settings)])).hexdigest()

    @property
    def name(self) -> str:
        """What it is, for people: "seed 3, noise quiet"."""
        return ", ".join(f"{name} {value}" for name, value in self.labels.items()) or self.key[:12]


def canonical(value: Any) -> bytes:
    """JSON with sorted keys and nothing between them; numbers that are no numbers are refused."""
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False, allow_nan=False).encode()
