"""What a window asks of a run's record beside its rows."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.gui.ipc.kinds import Command


@dataclass(frozen=True, slots=True)
class Interruption:
    """The step that was broken off, for how long (None: nobody knows), and the steps that were measured again."""

    at: str
    gone_s: float | None
    again: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Told:
    """Each interruption of a run, and its notes."""

    interruptions: tuple[Interruption, ...] = ()
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class TellRecord(Command[Told]):
    """What the record of this run tells."""

    run: str
