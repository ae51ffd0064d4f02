"""What a guardian hands to the one that stands by: that it lives, what the coils hold, and who answers for them.

It goes over the standby's pipe after every change and five times a second, one JSON line each; `DONE` ends it.
"""

from __future__ import annotations

import json
import queue
import threading
import time
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from labcal.bench.driver_kit.roles import Identity
from labcal.bench.essentials import AXES

TO_ZERO_S = 2.0  # from the last sign of life to zero
READ_BACK_S = 0.35  # of that, for the read-back
AT_REST_S = 1.5
LATE_S = 0.2  # nobody who runs freely wakes so late
DONE = "done"


@dataclass(frozen=True, slots=True)
class Held:
    """One axis: the least that its supply may hold [A] (without the contacts' sign; None where it is not known), who
    it is, and whether it was on its way to zero.
    """

    held_A: float | None = None
    energised: bool = False
    who: Identity | None = None
    falling: bool = False


@dataclass(frozen=True, slots=True)
class Handover:
    """What a successor need not find out. `exchanges_s`: how long zero takes where nothing flows; `way_down_s`: how
    long it takes from here, and how soon a guardian that hangs must be replaced.
    """

    exchanges_s: float = 0.0
    coils: Mapping[str, Held] = field(default_factory=dict)
    way_down_s: float = 0.0

    def line(self) -> str:
        """As one line of text."""
        return json.dumps(asdict(self))


def unknown() -> Handover:
    """Of a guardian that had no time to hand anything over: any coil may carry any current."""
    return Handover(coils={axis: Held(None, energised=True) for axis in AXES})


def handover_of(line: str) -> Handover:
    """What such a line says; `unknown` where it is cut or spoilt."""
    try:
        said = json.loads(line)
        coils = {axis: _held(coil) for axis, coil in said["coils"].items()}
        return Handover(float(said["exchanges_s"]), coils, float(said["way_down_s"]))
    except (ValueError, KeyError, TypeError, AttributeError):
        return unknown()


def _held(said: dict[str, Any]) -> Held:
    who = said["who"] and Identity(**said["who"])
    level_A = None if said["held_A"] is None else float(said["held_A"])
    return Held(level_A, bool(said["energised"]), who, bool(said["falling"]))


def patience(way_down_s: float) -> float:
    """How long a session, or a guardian, may be silent with coils on [s]: what two seconds leave after the way down."""
    return min(0.8, max(0.3, TO_ZERO_S - READ_BACK_S - way_down_s))


def stand_by(said: Iterable[str], hung_s: float | None = None) -> tuple[str, Handover]:
    """Listen to a guardian until it is `DONE`, has "ended" without that word, or is "silent" and must be replaced.

    Returns which of these, and what it handed over last. How long it may be silent depends on what the coils hold
    (or is `hung_s`). Who wakes late was itself kept from listening, and listens once more before it judges.
    """
    lines: queue.Queue[str | None] = queue.Queue()

    def listen() -> None:
        for line in said:
            lines.put(line.strip())
        lines.put(None)

    threading.Thread(target=listen, daemon=True).start()
    last = ""
    while True:
        wait_s = _may_be_silent_s(last) if hung_s is None else hung_s
        begun = time.monotonic()
        try:
            line = lines.get(timeout=wait_s)
        except queue.Empty:
            if time.monotonic() - begun > wait_s + LATE_S:
                continue
            return "silent", handover_of(last)
        if line is None:
            return "ended", handover_of(last)
        if line == DONE:
            return DONE, Handover()
        last = line


def _may_be_silent_s(last: str) -> float:
    """Of a guardian with its coils at rest longer: nothing flows that could wait for it."""
    handed = handover_of(last) if last else Handover()
    return patience(handed.way_down_s) if any(coil.energised for coil in handed.coils.values()) else AT_REST_S
