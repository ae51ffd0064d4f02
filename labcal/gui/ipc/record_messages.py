"""What a window asks of a run's record beside its rows."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.gui.ipc.kinds import Command
from labcal.record.told import Told


@dataclass(frozen=True, slots=True)
class TellRecord(Command[Told]):
    """What the record of this run tells."""

    run: str
