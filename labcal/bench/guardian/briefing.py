"""What a guardian is given of its bench by whoever starts it: the file may be edited, moved or gone when it counts.

It is the first line of the standard input of a process that is started with `BRIEFED`.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from labcal.bench.essentials import Essentials, of_table

if TYPE_CHECKING:
    from labcal.bench.config import BenchConfig

BRIEFED = "--briefed"
LONGEST = 60_000  # bytes: a pipe takes as many before anybody reads


@dataclass(frozen=True, slots=True)
class Briefing:
    """The bench as it was read: its file as it was named, what stood in it or the essentials of it, its fingerprint."""

    named: Path
    config: BenchConfig | Essentials
    fingerprint: str

    def line(self) -> bytes:
        """As one line; empty where it is longer than a pipe takes: then the file is read."""
        config = cast("BenchConfig", self.config).model_dump(mode="json")
        said = {"named": str(self.named), "config": config, "print": self.fingerprint}
        line = json.dumps(said).encode() + b"\n"
        return line if len(line) <= LONGEST else b"\n"


def briefing_of(line: str) -> Briefing | None:
    """What such a line says; None where it says nothing, or is spoilt."""
    from labcal.bench.config import BenchConfig  # who only says off needs none

    try:
        said: dict[str, Any] = json.loads(line)
        return Briefing(Path(said["named"]), BenchConfig.model_validate(said["config"]), str(said["print"]))
    except (ValueError, KeyError, TypeError):  # pydantic's are ValueErrors
        return None


def essentials_of(line: str) -> Briefing | None:
    """As much of it as a way to zero asks for, in a moment; None where it says too little, or is spoilt."""
    try:
        said: dict[str, Any] = json.loads(line)
        some = of_table(said["config"])
        return Briefing(Path(said["named"]), some, str(said["print"])) if some else None
    except (ValueError, KeyError, TypeError, AttributeError):
        return None
