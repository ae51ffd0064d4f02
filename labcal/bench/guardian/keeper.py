"""The coils as the guardian keeps them: limits, ramps, read-back; tripped by whoever says zero."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from threading import Event, RLock
from typing import Any, cast

from labcal.bench.config import AXES, BenchConfig
from labcal.bench.guardian.handover import Handover, Held
from labcal.bench.guardian.heartbeat import Heartbeats
from labcal.bench.guardian.limits import CoilLimit, TogetherLimit
from labcal.bench.guardian.lines import Line, LockedRelay, open_lines, relay_of
from labcal.bench.guardian.memory import Memory
from labcal.bench.polarity import ReversedSupply
from labcal.bench.roles import CoilSupply, Identity
from labcal.bench.zero import AtZero, to_zero
from labcal.errors import InstrumentError

Note = Callable[[str], None]
MODBUS_CALLS = ("read_coils", "read_holding", "read_input", "write_coil", "write_register", "write_registers")


@dataclass
class Coil:
    """One axis: its supply on its line, its limits, and why it may not be energised (None where it may)."""

    axis: str
    name: str
    line: Line
    relay: LockedRelay | None
    current_limit_A: float
    ramp_limit_A_per_s: float
    energised: bool = False
    held_A: float | None = None  # by the bare supply; unknown while a set-point is on its way, and after a fault
    tripped: InstrumentError | None = None  # told to the session until it sets zero itself
    unresolved: InstrumentError | None = None  # why zero is not confirmed

    @property
    def bare(self) -> CoilSupply:
        """The supply without its contacts: zero has no sign. Raises InstrumentError where its link does not open."""
        return cast(CoilSupply, self.line.instrument(self.name))

    @cached_property
    def signed(self) -> CoilSupply:
        """The supply with a sign: bipolar by itself, or behind reversing contacts."""
        if self.relay is None or not self.relay.reverses(self.axis):
            return self.bare
        return ReversedSupply(self.axis, self.bare, self.relay, self.line.clock)

    @cached_property
    def limit(self) -> CoilLimit:
        """Current and ramp."""
        return CoilLimit(self.axis, self.current_limit_A, self.rate_A_per_s)

    @property
    def rate_A_per_s(self) -> float:
        """The fastest ramp that cage and supply bear."""
        return min(self.ramp_limit_A_per_s, self.bare.ramp_A_per_s)


class Guardian:
    """All coils of a bench. Orders come from any thread; each line is used by one at a time."""

    def __init__(self, path: Path, config: BenchConfig, note: Note, handed: Handover | None = None) -> None:
        self._lines = open_lines(path, config)
        self._note = note
        self.heartbeats = Heartbeats(config, self._lines, note)
        relay = relay_of(config, self._lines)
        names = {str(entry.role): name for name, entry in config.instruments.items()}
        limits = config.cage.limits
        self.coils: dict[str, Coil] = {
            axis: Coil(axis, name := names[f"coil-{axis}"], self._lines[name], relay, most, rate)
            for axis, most, rate in zip(AXES, limits.current_A, limits.ramp_A_per_s, strict=True)
        }
        self._together = TogetherLimit(config, Memory(config.guarded_links))
        self._zeroing = RLock()
        self._exchanges_s = 0.0  # how long zero takes where nothing flows: three supplies on one slow line take longest
        self.changed = Event()  # what is handed over to a successor
        self._inherit(handed or Handover())

    def facts(self) -> dict[str, dict[str, float | bool | str]]:
        """What the session must know of each axis. Raises InstrumentError where a link does not open."""
        return {
            axis: {
                "name": coil.name,
                "bipolar": coil.signed.bipolar,
                "has_contacts": isinstance(coil.signed, ReversedSupply),
                "zero_current_A": coil.signed.zero_current_A,
                "can_open": coil.signed.can_open,
                "ramp_A_per_s": coil.signed.ramp_A_per_s,
            }
            for axis, coil in self.coils.items()
        }

    def identify(self, name: str) -> Identity:
        """Who answers as `name`."""
        return self._lines[name].identify(name)

    def reopen(self, name: str) -> None:
        """Open the lost link of `name` again."""
        self._line_of(name).reopen()

    def modbus(self, name: str, call: str, args: list[Any]) -> Any:
        """One exchange for an instrument of the session that shares a line with a supply. Raises InstrumentError."""
        if call not in MODBUS_CALLS or name in self._lines:
            raise InstrumentError(f"{name}: {call} is not for the session to ask.", fault="forbidden")
        return self._line_of(name).modbus(name, call, args)

    def _line_of(self, name: str) -> Line:
        lines = self._lines.values()
        return next(line for line in lines if line.url == line.loader.line_of(name))

    def set_current(self, axis: str, current_A: float) -> None:
        """Set and read back. Raises LimitError, or InstrumentError where the coil was taken to zero meanwhile.

        Zero is always accepted, and says that the session knows of the zero before.
        """
        coil = self.coils[axis]
        if current_A != 0:
            self.heartbeats.refuse()
        with coil.line.lock:
            if current_A == 0:
                coil.tripped = None
            self._refuse(coil)
            coil.limit.refuse(current_A, coil.line.clock.now())
            self._together.refuse(self._held_A() | {axis: current_A})
            self._holds(coil, None, coil.energised or current_A != 0)
            coil.signed.set_current(current_A)
            coil.limit.was_set(current_A, coil.line.clock.now())
            self._holds(coil, current_A if coil.bare.bipolar else abs(current_A), coil.energised)

    def set_point(self, axis: str) -> float:
        """The signed set-point, read back [A]."""
        return self._asked(axis, lambda supply: supply.set_point())

    def measure_current(self, axis: str) -> float:
        """The signed delivered current [A]."""
        return self._asked(axis, lambda supply: supply.measure_current())

    def output(self, axis: str, on: bool) -> None:
        """Close or open the output, confirmed. Closing is refused while zero is not confirmed."""
        coil = self.coils[axis]
        if on:
            self.heartbeats.refuse()
        with coil.line.lock:
            if on:
                self._refuse(coil)
                if coil.unresolved is not None:
                    raise coil.unresolved
                self._holds(coil, coil.held_A, True)
            elif abs(left := coil.bare.measure_current()) >= coil.bare.zero_current_A:
                raise InstrumentError(
                    f"coil {axis}: {left:.4g} A still flows; its output is not opened under current.",
                    fault="not zero",
                    remedy="Ramp it to zero first; or `labcal bench off`.",
                )
            coil.signed.output(on)

    def zero(self, why: str, *, by_session: bool = False, fault: InstrumentError | None = None) -> list[AtZero]:
        """Every coil to zero and open, all lines at once; what was found is noted. Never raises InstrumentError.

        Where it was not the session that asked, it is told so, or told `fault`, at its next order.
        """
        for coil in self.coils.values() if not by_session else ():
            coil.tripped = fault or InstrumentError(
                f"coil {coil.axis} was taken to zero: {why}.",
                fault="taken to zero",
                remedy="See guardian.log; what was measured since then was measured without this coil.",
            )
        with self._zeroing:
            self._note(f"to zero: {why}")
            begun, at_rest = time.monotonic(), not self.energised
            ended = self._down(list(self.coils.values()))
            if at_rest:
                self._exchanges_s = time.monotonic() - begun
            self.changed.set()
            self._note("read back: " + "; ".join(map(_read_back, ended)))
        return ended

    def look_at_duty(self) -> None:
        """Zero where a winding has borne enough, whatever the session believes."""
        hot = self._together.hot(self._held_A(), time.monotonic())
        if hot is not None and self.energised:
            self.zero(hot.what, fault=hot)

    def try_again(self) -> None:
        """Try once more what did not come to zero: the link is opened again and the instrument asked who it is."""
        with self._zeroing:
            for end in self._down([coil for coil in self.coils.values() if coil.unresolved is not None]):
                if end.current_A is not None:
                    self._note(f"at last: {_read_back(end)}")

    def handover(self) -> Handover:
        """What a successor must know; waits for no line."""
        coils = {axis: Held(c.held_A, c.energised, c.line.known(c.name)) for axis, c in self.coils.items()}
        return Handover(self._exchanges_s, coils)

    def give_back(self) -> None:
        """Give every supply that is at zero back to its panel. Never raises InstrumentError."""
        for coil in self.coils.values():
            with coil.line.lock, suppress(InstrumentError):  # it is at zero: what fails now is told to nobody
                if coil.unresolved is None and not coil.energised:
                    coil.bare.make_safe()

    def close(self) -> None:
        """Give every supply that is at zero back to its panel, and let go of every line."""
        self.give_back()
        for line in self._lines.values():
            line.close()

    @property
    def energised(self) -> bool:
        """Whether any coil may carry current."""
        return any(coil.energised for coil in self.coils.values())

    @property
    def way_down_s(self) -> float:
        """How long the way to zero takes from here: the ramp, and the exchanges on the lines as last measured."""
        ramps = [coil.limit.ramp_down_s for coil in self.coils.values() if coil.energised]
        return max(ramps, default=0.0) + self._exchanges_s

    @property
    def unresolved(self) -> dict[str, InstrumentError]:
        """Axes whose zero is not confirmed, and why."""
        return {axis: coil.unresolved for axis, coil in self.coils.items() if coil.unresolved is not None}

    def _inherit(self, handed: Handover) -> None:
        self._exchanges_s = handed.exchanges_s
        for axis, coil in self.coils.items():
            held = handed.coils.get(axis, Held())
            coil.held_A, coil.energised = held.held_A, held.energised
            if held.who is not None:
                coil.line.expect(coil.name, held.who)

    def _holds(self, coil: Coil, held_A: float | None, energised: bool) -> None:
        coil.held_A, coil.energised = held_A, energised
        self.changed.set()

    def _held_A(self) -> dict[str, float]:
        return {axis: coil.limit.level_A if coil.energised else 0.0 for axis, coil in self.coils.items()}

    def _refuse(self, coil: Coil) -> None:
        if coil.tripped is not None:
            raise coil.tripped

    def _asked(self, axis: str, ask: Callable[[CoilSupply], float]) -> float:
        coil = self.coils[axis]
        with coil.line.lock:
            self._refuse(coil)
            return ask(coil.signed)

    def _down(self, coils: Sequence[Coil]) -> list[AtZero]:
        lines = {coil.line.url: coil.line for coil in coils}
        on_line = [[coil for coil in coils if coil.line is line] for line in lines.values()]
        with ThreadPoolExecutor(max(1, len(on_line))) as together:
            return [end for ended in together.map(_line_down, on_line) for end in ended]


def _read_back(end: AtZero) -> str:
    current = "unknown" if end.current_A is None else f"{end.current_A:+.4f} A"
    return f"coil {end.axis} {current}, {end.words}"


def _line_down(coils: Sequence[Coil]) -> list[AtZero]:
    with coils[0].line.lock:
        ready, faults = dict[str, Coil](), dict[str, AtZero]()
        hurry = any(coil.energised for coil in coils)
        for coil in coils:
            try:
                _connect(coil, hurry)
                ready[coil.axis] = coil
            except InstrumentError as fault:
                faults[coil.axis] = AtZero(coil.axis, None, False, fault)
        supplies = {axis: coil.bare for axis, coil in ready.items()}
        rates = {axis: coil.rate_A_per_s for axis, coil in ready.items()}
        known = {axis: coil.held_A for axis, coil in ready.items() if hurry and coil.held_A is not None}
        ended: Mapping[str, AtZero] = {**faults, **to_zero(supplies, rates, coils[0].line.clock, known_A=known)}
        for coil in coils:
            _settle(coil, ended[coil.axis])
        return list(ended.values())


def _connect(coil: Coil, hurry: bool) -> None:
    """See that the right instrument is at the end of the link, where in doubt; late replies go with the link."""
    if coil.unresolved is not None:
        coil.line.reopen()
    if coil.unresolved is not None or not hurry or not coil.line.greeted(coil.name):
        coil.line.identify(coil.name)


def _settle(coil: Coil, end: AtZero) -> None:
    coil.unresolved = end.fault if end.current_A is None else None
    coil.held_A = None
    if coil.unresolved is None:
        coil.energised, coil.held_A = False, 0.0
        coil.limit.at_zero()
