"""What a procedure says into the record beside what it measures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from labcal.bench.bench import Bench
from labcal.bench.coils.state import LabState
from labcal.record.stream import BY, NOT_USED, PROCEDURE, Event


def note(bench: Bench, text: str, **data: Any) -> Event:
    """A remark for the record, told from what a person notes."""
    return Event(bench.clock.now(), "note", text, {BY: PROCEDURE, **data})


def not_used(bench: Bench, segments: Sequence[str], reason: str) -> Event:
    """Segments recorded so far that stay in the record and count no more, and why."""
    text = f"not used: {', '.join(segments)}: {reason}"
    return Event(bench.clock.now(), NOT_USED, text, {"segments": list(segments), "reason": reason})


def read_back(bench: Bench, kind: str, before: str = "", state: LabState | None = None, **data: Any) -> Event:
    """An event that says how the coils are, by what was read of them last; `before` opens the sentence."""
    now, state = bench.clock.now(), state or bench.state()
    return Event(now, kind, before + state.sentence(now), data | {"state": state.as_json(now)})


def set_point(bench: Bench, text: str, **data: Any) -> Event:
    """An event that says what the coils were set to, with what was read back."""
    currents = bench.cage.currents_A().tolist()
    data |= {"read_back_A": currents, "state": bench.state().as_json(bench.clock.now())}
    return Event(bench.clock.now(), "set-point", text, data)
