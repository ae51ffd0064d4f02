"""The coils as the guardian keeps them: limits, ramps, read-back; tripped by whoever says zero."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from threading import Event, RLock
from typing import TYPE_CHECKING, Any, cast

from labcal.bench.coils.at_zero import BY_WORD, AtZero
from labcal.bench.coils.polarity import ReversedSupply
from labcal.bench.driver_kit.roles import CoilSupply, Identity, Releasable
from labcal.bench.essentials import AXES
from labcal.bench.guardian.coil import GuardedCoil
from labcal.bench.guardian.descent import line_down
from labcal.bench.guardian.handover import Handover, Held
from labcal.bench.guardian.heartbeat import Heartbeats
from labcal.bench.guardian.line_workers import LineWorkers
from labcal.bench.guardian.owned_lines import OwnedLine, open_lines, relay_of
from labcal.errors import InputError, InstrumentError

if TYPE_CHECKING:
    from labcal.bench.config import BenchConfig
    from labcal.bench.essentials import Essentials
    from labcal.bench.guardian.limits_together import TogetherLimit

Note = Callable[[str], None]
MODBUS_CALLS = ("read_coils", "read_holding", "read_input", "write_coil", "write_register", "write_registers")


class Guardian:
    """All coils of a bench. Orders come from any thread; each line is used by one at a time.

    The essentials of a bench are enough to bring its coils to zero, and for nothing else.
    """

    def __init__(
        self, path: Path, config: BenchConfig | Essentials, note: Note, handed: Handover | None = None
    ) -> None:
        self._config = config
        self._lines = open_lines(path, config)
        self._note = note
        relay = relay_of(config, self._lines)
        names = {str(entry.role): name for name, entry in config.instruments.items()}
        limits = config.cage.limits
        self.coils: dict[str, GuardedCoil] = {
            axis: GuardedCoil(axis, name := names[f"coil-{axis}"], self._lines[name], relay, most, rate)
            for axis, most, rate in zip(AXES, limits.current_A, limits.ramp_A_per_s, strict=True)
            if f"coil-{axis}" in names
        }
        self._zeroing = RLock()
        self._workers = LineWorkers(len({coil.line.url for coil in self.coils.values()}))
        self._ended = dict[str, AtZero]()  # how each axis was last brought to zero
        self.broken: Exception | None = None  # why this guardian cannot go on; its successor can
        self._exchanges_s = 0.0  # how long zero takes where nothing flows: three supplies on one slow line take longest
        self.changed = Event()  # what is handed over to a successor
        self.notify: Callable[[], None] = self.changed.set  # it, before anything else is done
        self._inherit(handed or Handover())

    @cached_property
    def heartbeats(self) -> Heartbeats:
        """What instruments wait for."""
        return Heartbeats(self._config, self._lines, self._note)

    @cached_property
    def _together(self) -> TogetherLimit:
        """Field and duty: nothing that a way to zero asks for, and slow to load."""
        from labcal.bench.guardian.duty import DutyRecord
        from labcal.bench.guardian.limits_together import TogetherLimit

        return TogetherLimit(cast("BenchConfig", self._config), DutyRecord(self._config.guarded_links))

    def load_supplies(self) -> None:
        """Load their drivers before another thread loads anything; what is wrong is said on the way to zero."""
        for coil in self.coils.values():
            with suppress(InputError):
                coil.line.loader.driver(coil.name)

    def load(self, config: BenchConfig | Essentials) -> None:
        """What a session needs and a zero does not, of the whole bench: by one thread, before the first order."""
        self._config = config
        _ = self._together, self.heartbeats

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

    def identify(self, name: str, within_s: float = 0.0) -> Identity:
        """Who answers as `name`, or answered within the last `within_s`."""
        return self._lines[name].identify(name, within_s)

    def meet_others(self) -> None:
        """Ask those whose line no supply is on who they are, while zero waits for the supplies; silence comes again."""
        of_coils = {coil.line.url for coil in self.coils.values()}
        for name, line in self._lines.items():
            if line.url not in of_coils:
                with suppress(InstrumentError):
                    line.identify(name)

    def reopen(self, name: str) -> None:
        """Open the lost link of `name` again."""
        self._line_of(name).reopen()

    def modbus(self, name: str, call: str, args: list[Any]) -> Any:
        """One exchange for an instrument of the session that shares a line with a supply. Raises InstrumentError."""
        if call not in MODBUS_CALLS or name in self._lines:
            raise InstrumentError(f"{name}: {call} is not for the session to ask.", fault="forbidden")
        return self._line_of(name).modbus(name, call, args)

    def _line_of(self, name: str) -> OwnedLine:
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
            if coil.unresolved is not None:
                raise coil.unresolved
            if current_A:
                coil.release()
            self.changed.set()
            coil.set_current(current_A)
            self.changed.set()

    def set_point(self, axis: str) -> float:
        """The signed set-point, read back [A]."""
        return self._asked(axis, lambda supply: supply.set_point())

    def measure_current(self, axis: str) -> float:
        """The signed delivered current [A]."""
        return self._asked(axis, lambda supply: supply.measure_current())

    def read(self, axis: str) -> float:
        """The same of a coil that was taken to zero, for who only looks: it is given back to its panel after it."""
        coil = self.coils[axis]
        if coil.unresolved is not None:
            raise coil.unresolved
        with coil.line.lock:
            current_A = coil.bare.measure_current()
            if not coil.energised and isinstance(coil.bare, Releasable):
                coil.bare.release()
        return current_A

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
                coil.release()
                coil.energised = True
                self.changed.set()
            with coil.doubting():
                if not on and abs(left := coil.bare.measure_current()) >= coil.bare.zero_current_A:
                    raise InstrumentError(
                        f"coil {axis}: {left:.4g} A still flows; its output is not opened under current.",
                        fault="not zero",
                        remedy="Ramp it to zero first; or `labcal bench off`.",
                    )
                coil.signed.output(on)

    def order_zero(self, why: str, *, by_session: bool = False, fault: InstrumentError | None = None) -> None:
        """Stop whatever is under way on any line, and let nothing up again; waits for nobody.

        Where it was not the session that asked, it hears so, or `fault`, at its next order.
        """
        for coil in self.coils.values() if not by_session else ():
            coil.tripped = fault or InstrumentError(
                f"zero was ordered for all coils: {why}.",
                fault="taken to zero",
                remedy="See guardian.log; what was measured since then was measured without them.",
            )
        for coil in self.coils.values():
            coil.line.gate.close(why)

    def zero(self, why: str, *, by_session: bool = False, fault: InstrumentError | None = None) -> list[AtZero]:
        """Every coil to zero and open, all lines at once; what was found is noted. Never raises InstrumentError.

        A session that asks again while nothing more can be done hears what stands: what does not answer is tried
        again all the time, and nobody waits for that twice.
        """
        self.order_zero(why, by_session=by_session, fault=fault)
        with self._zeroing:
            self._note(f"to zero: {why}")
            begun, at_rest = time.monotonic(), not self.energised
            standing = self.unresolved if by_session and not self.in_hand else {}
            ended = self._down([coil for axis, coil in self.coils.items() if axis not in standing])
            ended += [AtZero(a, None, False, left, asked_s=self.coils[a].asked_s) for a, left in standing.items()]
            ended.sort(key=lambda end: AXES.index(end.axis))
            if at_rest:
                self._exchanges_s = time.monotonic() - begun
            self.changed.set()
            self._note_ends(ended)
        return ended

    def _note_ends(self, ended: Sequence[AtZero]) -> None:
        """What was read back, and apart from that what was not, or not at zero."""
        known = [end for end in ended if end.current_A is not None]
        if known:
            self._note(f"{BY_WORD}, read back: {'; '.join(map(_read_back, known))}")
        if left := [end for end in ended if end.current_A is None]:
            self._note(f"NOT confirmed at zero: {'; '.join(end.why_left for end in left)}")

    def look_at_duty(self) -> None:
        """Zero where a winding has borne enough, whatever the session believes."""
        hot = self._together.hot(self._held_A(), time.monotonic())
        if hot is not None and self.energised:
            self.zero(hot.what, fault=hot)

    def try_again(self) -> None:
        """Zero once more to what was not read back there; a lost link is opened again."""
        with self._zeroing:
            left = [coil for coil in self.coils.values() if coil.unresolved is not None]
            for coil in left:
                coil.line.gate.close(f"zero of coil {coil.axis} is not confirmed, and tried again")
            for end in self._down(left):
                if end.current_A is not None:
                    self._note(f"at last, {BY_WORD}: {_read_back(replace(end, fault=None))}")

    def ends(self) -> list[AtZero]:
        """How each axis ended that was brought to zero and not let up since; waits for no line."""
        ended = [self._ended.get(axis) for axis, coil in self.coils.items() if coil.latch.most_A is not None]
        return [end for end in ended if end is not None]

    def handover(self) -> Handover:
        """What a successor must know; waits for no line."""
        return Handover(self._exchanges_s, {axis: coil.held for axis, coil in self.coils.items()}, self.way_down_s)

    def give_back(self) -> None:
        """Give every supply that is at zero back to its panel, all lines at once. Never raises InstrumentError."""
        self._workers.each(_given_back, _by_line(self.coils.values()))

    def close(self) -> None:
        """Give every supply that is at zero back to its panel, and let go of every line."""
        self.give_back()
        for line in self._lines.values():
            line.close()
        self._workers.let_go()

    @property
    def energised(self) -> bool:
        """Whether any coil may carry current."""
        return any(coil.energised for coil in self.coils.values())

    @property
    def in_hand(self) -> bool:
        """Whether any coil may carry current that zero was not ordered for; the others are tried again and again."""
        return any(coil.energised and coil.unresolved is None for coil in self.coils.values())

    @property
    def way_down_s(self) -> float:
        """How long the way to zero takes from here: the ramp, and the exchanges on the lines as last measured."""
        ramps = [coil.ramp_down_s for coil in self.coils.values() if coil.energised]
        return max(ramps, default=0.0) + self._exchanges_s

    @property
    def unresolved(self) -> dict[str, InstrumentError]:
        """Axes whose zero is not confirmed, and why."""
        return {axis: coil.unresolved for axis, coil in self.coils.items() if coil.unresolved is not None}

    def _inherit(self, handed: Handover) -> None:
        self._exchanges_s = handed.exchanges_s
        for axis, coil in self.coils.items():
            coil.inherit(handed.coils.get(axis, Held()))

    def _held_A(self) -> dict[str, float]:
        return {axis: coil.limit.level_A if coil.energised else 0.0 for axis, coil in self.coils.items()}

    def _refuse(self, coil: GuardedCoil) -> None:
        if coil.tripped is not None:
            raise coil.tripped

    def _asked(self, axis: str, ask: Callable[[CoilSupply], float]) -> float:
        coil = self.coils[axis]
        with coil.line.lock:
            self._refuse(coil)
            if coil.unresolved is not None:  # it is asked again and again; who waits for it here would wait in vain
                raise coil.unresolved
            with coil.doubting():
                return ask(coil.signed)

    def _down(self, coils: Sequence[GuardedCoil]) -> list[AtZero]:
        """Each line its own way, so that a silent instrument delays no other line."""
        try:
            ended = [end for ended in self._workers.each(self._line_down, _by_line(coils)) for end in ended]
        except Exception as error:  # out of memory, of handles, or a fault of our own: another process takes over
            self.broken = error
            raise
        self._ended |= {end.axis: end for end in ended}
        return ended

    def _line_down(self, coils: Sequence[GuardedCoil]) -> list[AtZero]:
        others = [coil.name for coil in self.coils.values() if coil not in coils]
        return line_down(coils, others, self.notify)


def _by_line(coils: Iterable[GuardedCoil]) -> list[list[GuardedCoil]]:
    """The coils of each line."""
    lines = dict[str, list[GuardedCoil]]()
    for coil in coils:
        lines.setdefault(coil.line.url, []).append(coil)
    return list(lines.values())


def _given_back(coils: Sequence[GuardedCoil]) -> None:
    for coil in coils:
        with coil.line.lock, suppress(InstrumentError):  # it is at zero: what fails now is reported to nobody
            if coil.unresolved is None and not coil.energised:
                coil.bare.make_safe()


def _read_back(end: AtZero) -> str:
    return f"coil {end.axis} {end.current_A:+.4f} A, {end.words}"
