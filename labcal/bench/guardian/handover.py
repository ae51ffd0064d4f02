"""What a guardian hands to the one that stands by: that it lives, what the coils hold, and who answers for them.

It goes over the standby's pipe after every change and five times a second, one JSON line each; `DONE` ends it.
"""

from __future__ import annotations

import json
import queue
import threading
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from labcal.bench.roles import Identity

HUNG_S = 1.5
DONE = "done"


@dataclass(frozen=True, slots=True)
class Held:
    """One axis: its supply's set-point [A] (without the contacts' sign; None where it is not known) and who it is."""

    held_A: float | None = None
    energised: bool = False
    who: Identity | None = None


@dataclass(frozen=True, slots=True)
class Handover:
    """What a successor need not find out. `exchanges_s`: how long zero takes where nothing flows."""

    exchanges_s: float = 0.0
    coils: Mapping[str, Held] = field(default_factory=dict)

    def line(self) -> str:
        """As one line of text."""
        return json.dumps(asdict(self))


def handover_of(line: str) -> Handover:
    """What such a line says; nothing is known where it is cut or spoilt."""
    try:
        said = json.loads(line)
        return Handover(float(said["exchanges_s"]), {axis: _held(coil) for axis, coil in said["coils"].items()})
    except (ValueError, KeyError, TypeError, AttributeError):
        return Handover()


def _held(said: dict[str, Any]) -> Held:
    who = said["who"] and Identity(**said["who"])
    level_A = None if said["held_A"] is None else float(said["held_A"])
    return Held(level_A, bool(said["energised"]), who)


def stand_by(said: Iterable[str], hung_s: float = HUNG_S) -> tuple[str, Handover]:
    """Listen to a guardian until it is `DONE`, has "ended" without that word, or is "silent" and must be replaced.

    Returns which of these, and what it handed over last.
    """
    lines: queue.Queue[str | None] = queue.Queue()

    def listen() -> None:
        for line in said:
            lines.put(line.strip())
        lines.put(None)

    threading.Thread(target=listen, daemon=True).start()
    last = ""
    try:
        while (line := lines.get(timeout=hung_s)) is not None:
            if line == DONE:
                return DONE, Handover()
            last = line
    except queue.Empty:
        return "silent", handover_of(last)
    return "ended", handover_of(last)
