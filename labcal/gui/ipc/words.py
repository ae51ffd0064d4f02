"""What a window says into a run that goes on, at any moment; nothing answers it. One frozen dataclass each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from labcal.gui.ipc.kinds import Word


@dataclass(frozen=True, slots=True)
class Beat(Word):
    """This window is not standing still."""


@dataclass(frozen=True, slots=True)
class LinesTaken(Word):
    """So many lines of the worker this window has taken, in all."""

    lines: int


@dataclass(frozen=True, slots=True)
class Answer(Word):
    """What the person says to the prompt `key`."""

    key: str
    text: str


@dataclass(frozen=True, slots=True)
class Pause(Word):
    """Wait where the next step begins."""


@dataclass(frozen=True, slots=True)
class GoOn(Word):
    """Go on after a pause."""


@dataclass(frozen=True, slots=True)
class Stop(Word):
    """End in order; `later`: coils to zero likewise, and the run is interrupted, to be gone on with."""

    later: bool = False


@dataclass(frozen=True, slots=True)
class Abort(Word):
    """Coils to zero before anything else."""


@dataclass(frozen=True, slots=True)
class HangUp(Word):
    """This window goes, and means to: a run ends with the coils at zero, to be gone on with."""


@dataclass(frozen=True, slots=True)
class Note(Word):
    """A remark into the record; `data` goes with it."""

    text: str
    data: Mapping[str, str] = field(default_factory=dict)
