"""What a run's record tells beside its rows: interruptions, and what people noted."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Interruption:
    """`at`: the step that was broken off, "" where none had begun. `gone_s` is None where nobody wrote when it ended.

    `again`: the steps that were begun before it and after it. `timed` is False on a simulated bench: its clock stood.
    """

    at: str
    gone_s: float | None
    again: tuple[str, ...]
    timed: bool = True


@dataclass(frozen=True, slots=True)
class Told:
    """Notes and photographs in the order that they were made, in the words that were typed."""

    interruptions: tuple[Interruption, ...] = ()
    notes: tuple[str, ...] = ()
