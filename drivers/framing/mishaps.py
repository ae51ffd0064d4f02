"""What goes wrong on a line, counted until the record asks: one event a kind, however noisy the line is."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import Literal

from labcal.errors import InstrumentError
from labcal.record.stream import Event

Kind = Literal["gap", "checksum", "bad frame", "overrun", "late", "restart", "lost sync"]


@dataclass
class Mishaps:
    """`total`: samples or frames lost since the start, by kind."""

    source: str
    total: Counter[str] = field(default_factory=Counter)
    _new: dict[str, tuple[float, int, int]] = field(default_factory=dict)

    def note(self, kind: Kind, t_s: float, lost: int = 1) -> None:
        """Something went wrong at `t_s` and cost `lost` samples or frames."""
        since, times, before = self._new.get(kind, (t_s, 0, 0))
        self._new[kind] = since, times + 1, before + lost
        self.total[kind] += lost

    def events(self) -> list[Event]:
        """What was noted since this was asked last, each kind stamped at its first."""
        new, self._new = self._new, {}
        return [
            Event(t, "stream", f"{self.source}: {kind}, {lost} lost", {"fault": kind, "times": times, "lost": lost})
            for kind, (t, times, lost) in new.items()
        ]


def overloaded(source: str) -> InstrumentError:
    """The error for a reading at the end of a sensor's range: a fault, not a value."""
    remedy = "Lower the field, take away what adds to it, or widen its range where it has another."
    return InstrumentError(f"{source}: a reading at full scale.", fault="overloaded", remedy=remedy)
