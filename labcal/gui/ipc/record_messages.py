"""What a window asks of a run's record beside its rows."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.gui.ipc.kinds import Command
from labcal.record.left_running import LeftRunning
from labcal.record.told import Told
from labcal.record.turned import TurnBefore


@dataclass(frozen=True, slots=True)
class TellRecord(Command[Told]):
    """What the record of this run tells."""

    run: str


@dataclass(frozen=True, slots=True)
class RunResult:
    """What a finished run came to: the worst verdict measured ("": nothing had a limit), and what is missing."""

    run_id: str
    verdict: str
    left_out: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TellResults(Command[tuple[RunResult, ...]]):
    """What these finished runs came to."""

    runs: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TellTurned(Command[tuple[TurnBefore, ...]]):
    """Where the field was in the turns that this run has recorded."""

    run: str


@dataclass(frozen=True, slots=True)
class LookForLeft(Command[LeftRunning | None]):
    """Whether the last run on the bench of this name goes on in another process, or was cut off."""

    bench: str
