"""What the window asks of a lab that no run drives: how it is now. Nothing is set by it."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.gui.ipc import answers
from labcal.gui.ipc.bench_facts import Triple
from labcal.gui.ipc.kinds import Command
from labcal.gui.ipc.wire import Fault


@dataclass(frozen=True, slots=True)
class InstrumentRead:
    """One instrument as it was read at `read_s` (monotonic clock). None was not read, or is not its to say.

    `held`: another process has it, and nothing was asked. `until`: the supplies that its guardian has it for.
    """

    name: str
    role: str
    link: str
    identity: str = ""
    fault: Fault | None = None
    held: bool = False
    read_s: float | None = None
    current_A: float | None = None
    zero: bool = False
    field_nT: Triple | None = None
    angle_deg: float | None = None
    moving: bool | None = None
    serial: str = ""
    until: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class CheckZero(Command[answers.Doubt]):
    """Take the coils of a bench to zero, and measure again the zero that is in doubt."""

    bench: str


@dataclass(frozen=True, slots=True)
class Identify(Command[answers.Identified]):
    """Ask every instrument of a bench who it is."""

    bench: str


@dataclass(frozen=True, slots=True)
class EarlierAreGone(Command[bool]):
    """`who` says that the supplies of an earlier session on a bench, at these ports, are there no more."""

    bench: str
    ports: tuple[str, ...]
    who: str


@dataclass(frozen=True, slots=True)
class PrepareToRead(Command[bool]):
    """Load what reading the instruments of a bench takes; no link is opened, for a run has them."""

    bench: str


@dataclass(frozen=True, slots=True)
class ReadLab(Command[tuple[InstrumentRead, ...]]):
    """Read these instruments of a bench, all where none is named."""

    bench: str
    names: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class FindSimulatedBench(Command[str]):
    """The bench file of the simulated lab."""
