"""What a bench needs of an instrument, as small Protocols. A driver fits by having the methods, not by inheriting."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol, runtime_checkable

if TYPE_CHECKING:
    from labcal.record.header import ChannelSpec as ChannelSpec  # drivers declare theirs with the roles
    from labcal.record.stream import Block, Event


def __getattr__(name: str) -> Any:
    """`ChannelSpec`, when it is asked for: a supply that is to be switched off waits for no record."""
    if name != "ChannelSpec":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from labcal.record.header import ChannelSpec

    return ChannelSpec


@dataclass(frozen=True, slots=True)
class Identity:
    """Who answered."""

    manufacturer: str
    model: str
    serial: str
    firmware: str = ""


@runtime_checkable
class Instrument(Protocol):
    """Everything with a plug."""

    name: str  # its name in bench.toml

    def identify(self) -> Identity:
        """Ask who it is. Raises InstrumentError when it is silent or is another instrument."""
        ...

    def make_safe(self) -> None:
        """Bring it to rest: current zero and output open, motion stopped, stream ended. Safe to call twice."""
        ...

    def close(self) -> None:
        """Let go of the link."""
        ...


@runtime_checkable
class CoilSupply(Instrument, Protocol):
    """One coil axis. Currents in ampere; the sign is meaningful only where `bipolar`."""

    bipolar: bool
    zero_current_A: float  # |read-back| below this is zero
    can_open: bool  # off really opens the circuit
    ramp_A_per_s: float  # fastest safe ramp

    def set_current(self, current_A: float) -> None:
        """Set and read back. Raises LimitError beyond the limits, and then nothing was sent."""
        ...

    def set_point(self) -> float:
        """The set-point that the supply holds, read back [A]."""
        ...

    def measure_current(self) -> float:
        """The delivered current [A]."""
        ...

    def output(self, on: bool) -> None:
        """Close or open the output, confirmed by read-back."""
        ...


@runtime_checkable
class Unacknowledged(CoilSupply, Protocol):
    """A supply that can be written to without its reply being waited for: one that answers late hears zero in time."""

    def write_current(self, current_A: float) -> None:
        """Put the set-point on the line and return; what the supply says to it is dropped. Refused beyond limits."""
        ...

    def write_off(self) -> None:
        """Put "output off" on the line and return."""
        ...


@runtime_checkable
class Releasable(Protocol):
    """What goes over to remote control when it is spoken to, and can be given back to its own panel."""

    def release(self) -> None:
        """Give it back; nothing else about it changes."""
        ...


@runtime_checkable
class PolarityRelay(Instrument, Protocol):
    """Reversing contacts that turn unipolar supplies into signed coil axes. Never switched under current."""

    def reverses(self, axis: str) -> bool:
        """Whether contacts are wired into the coil `axis` ("x", "y", "z")."""
        ...

    def set_polarity(self, axis: str, sign: int) -> None:
        """Switch to +1 or -1, confirmed by reading the contacts back."""
        ...

    def polarity(self, axis: str) -> int:
        """+1 or -1, read back."""
        ...


@runtime_checkable
class Watched(Protocol):
    """What switches off by itself where it is not heard in time: a supply with a watchdog, or an interlock."""

    watchdog_s: float  # after so long a silence; 0 where it has none, or it is not used

    def feed(self) -> None:
        """Be heard: at least every third of `watchdog_s`. Raises InstrumentError where it is silent or has opened."""
        ...


@runtime_checkable
class Interlock(Instrument, Watched, Protocol):
    """A contact that lets the coils' currents through for `watchdog_s` after each beat, and falls open without."""

    def arm(self) -> None:
        """Close it, with the coils at zero. Raises InstrumentError where it would not fall open by itself."""
        ...

    def disarm(self) -> None:
        """Open it now."""
        ...


@runtime_checkable
class RotationPlatform(Instrument, Protocol):
    """The platform that turns the DUT; angles are the contract's: right-handed about the platform axis, degrees."""

    motorised: bool
    max_rate_deg_per_s: float

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Find the reference position if it is not known, no faster than this; refused where that cannot be seen to."""
        ...

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move; it goes on while streams are read. Refused beyond the cable-wrap limit."""
        ...

    def moving(self) -> bool:
        """Whether it moves; after a move, False means arrived and confirmed, else InstrumentError."""
        ...

    def angle_deg(self) -> float:
        """The angle now, read back."""
        ...

    def state(self) -> tuple[float, bool]:
        """The angle now and whether it moves, in as few questions as the instrument allows; raises nothing else."""
        ...


@runtime_checkable
class ByHand(RotationPlatform, Protocol):
    """A platform without a motor: `move_to` raises a question, and the technician's answer ends the move."""

    u_reading_deg: float  # standard uncertainty of what the dial reads

    def question(self) -> str:
        """What the technician is asked to do."""
        ...

    def confirm(self, answer: str) -> None:
        """The dial's reading, nothing for the angle asked for, or "abort". Raises InstrumentError for all else."""
        ...


@runtime_checkable
class Magnetometer(Instrument, Protocol):
    """A stream of samples: the reference, or the DUT. A driver starts no thread and parses what has arrived."""

    def start(self) -> None:
        """Begin the stream (or the polling)."""
        ...

    def read_until(self, t_s: float) -> list[Block]:
        """All samples that arrived up to `t_s` on the bench's clock; waits for them. Parses, never skips."""
        ...

    def events(self) -> list[Event]:
        """What the stream lost since this was asked last: gaps, wrong checksums, broken frames, overruns."""
        ...

    def stop(self) -> None:
        """End the stream."""
        ...


@runtime_checkable
class Pollable(Magnetometer, Protocol):
    """A magnetometer that sends nothing by itself: a sample is there only if it is read when one is due."""

    def due_s(self) -> float:
        """When it is to be asked next, on the bench's clock; inf before `start` and after `stop`."""
        ...


@runtime_checkable
class Steady(Magnetometer, Protocol):
    """A magnetometer that sends by itself at a rate that its maker states: it is missed by that."""

    period_s: float  # between two messages

    @property
    def spoilt(self) -> int:
        """How many messages came since `start` that were no good: they tell nothing, but that it is there."""
        ...


@runtime_checkable
class Paced(Magnetometer, Protocol):
    """A magnetometer that can be set how fast to sample."""

    rate_hz: float

    def rates_hz(self) -> tuple[float, ...]:
        """What its line bears, the slowest first."""
        ...

    def set_rate(self, rate_hz: float) -> None:
        """Sample at one of these from now on; a stream that goes on begins again."""
        ...


@runtime_checkable
class DutStream(Magnetometer, Protocol):
    """The device under test: a magnetometer that may send housekeeping beside its readings."""

    @property
    def channels(self) -> tuple[ChannelSpec, ...]:
        """The housekeeping columns of its "channel" blocks."""
        ...
