"""From bench.toml to a Bench: every instrument opened, behind its guardian where one is due, and put in its role."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import ExitStack
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import Any, cast

from labcal.bench.bench import Bench, Reopens
from labcal.bench.clock import Clock, RealClock, VirtualClock
from labcal.bench.coils.cage_file import CageCalibration, calibrated
from labcal.bench.coils.polarity import ReversedSupply
from labcal.bench.config import AXES, read_config
from labcal.bench.driver_kit.roles import CoilSupply, DutStream, Instrument, PolarityRelay
from labcal.bench.guardian.client import GuardianClient
from labcal.bench.guardian.modbus import GuardedModbus
from labcal.bench.guardian.proxies import GuardedInstrument, GuardedSupply
from labcal.bench.identification import Identifications, lines_apart
from labcal.bench.listening import temperatures_of
from labcal.bench.loading import Loader, speaks_modbus
from labcal.bench.platform import BenchPlatform
from labcal.bench.simulated_operator import SimulatedOperator
from labcal.errors import InputError, InstrumentError, LimitError


def open_bench(path: Path, *, clock: Clock | None = None, seed: int | None = None, identify: bool = True) -> Bench:
    """Open every instrument of `path` and, with `identify`, ask each who it is before anything else is said to it.

    Use as a context manager: on leaving, all is made safe and let go of.

    `clock`: the real one unless all links are emulated, then a virtual one. `seed` repeats a simulated lab exactly.
    Raises InputError for a bad file, InstrumentError where an instrument cannot be reached or is another.
    """
    begun = Identifications() if identify else None
    bench = load_bench(Path(path), clock, seed, begun)
    if identify:
        with ExitStack() as on_failure:
            on_failure.callback(bench.close)
            bench.identities(begun)
            on_failure.pop_all()
    return bench


def load_bench(path: Path, clock: Clock | None, seed: int | None, begun: Identifications | None = None) -> Bench:
    """Open every instrument of `path` and put it in its role; links are let go of where one of them fails.

    `begun`: with these, who is on a line of the session's own is asked who it is while the guardian begins with zero.
    """
    config, cage = calibrated(read_config(path), path)
    if clock is None:
        clock = VirtualClock(datetime.now(UTC)) if config.simulated else RealClock()
    if isinstance(clock, VirtualClock) and not config.simulated:
        raise InputError("a virtual clock is for a bench whose links are all emulated", file=path)
    loader = Loader(path, config, clock, seed or 0)
    loader.look_over()  # what is wrong with the file is said here, not by another process
    loader.meet_group()
    with ExitStack() as on_failure:
        own = OwnInstruments(loader)
        on_failure.callback(own.close)
        guardian = _guardian(loader, (lambda: None) if begun is None else partial(own.identify, begun))
        if guardian is not None:
            on_failure.callback(guardian.close)
        instruments: dict[str, Instrument] = {}
        for name in config.instruments:
            instruments[name] = own.taken(name) or _instrument(loader, name, guardian)
            on_failure.callback(instruments[name].close)
        bench = _in_roles(loader, instruments, guardian, cage)
        on_failure.pop_all()
        return bench


class OwnInstruments:
    """Those on lines of the session's own, opened before the guardian answers."""

    def __init__(self, loader: Loader) -> None:
        self._loader, self._apart = loader, lines_apart(loader.config)
        self._opened: dict[str, Instrument] | None = None
        self._fault: InputError | InstrumentError | None = None  # of the first that could not be opened

    def identify(self, begun: Identifications) -> None:
        """Open them and begin to ask them who they are, once however often it is called; `taken` raises what fails."""
        if self._opened is not None:
            return
        self._opened = {}
        try:
            for name in self._apart:
                self._opened[name] = self._loader.instrument(name)
        except (InputError, InstrumentError) as fault:
            self._fault = fault
        begun.begin(dict(self._opened), {name: self._apart[name] for name in self._opened}, self._loader.clock)

    def taken(self, name: str) -> Instrument | None:
        """The instrument, from now on another's to close; None where it was not to be opened here."""
        if self._opened is None or name not in self._apart:
            return None
        if name not in self._opened and self._fault is not None:
            raise self._fault
        return self._opened.pop(name, None)

    def close(self) -> None:
        """Let go of those that nobody has taken."""
        with ExitStack() as steps:
            for instrument in (self._opened or {}).values():
                steps.callback(instrument.close)


def _guardian(loader: Loader, meanwhile: Callable[[], None]) -> GuardianClient | None:
    """The guardian of a bench with real supplies or contacts; those of a simulated one die with the session."""
    config = loader.config
    if not config.guarded_links:
        return None
    return GuardianClient(loader.path, config, loader.clock, meanwhile)


def _instrument(loader: Loader, name: str, guardian: GuardianClient | None) -> Instrument:
    if guardian is None:
        return loader.instrument(name)
    if name not in loader.config.guarded:
        shared = loader.line_of(name) in loader.config.guarded_links
        return _sharing(loader, name, guardian) if shared else loader.instrument(name)
    role = loader.config.instruments[name].role
    return GuardedSupply(role[-1], guardian) if role.startswith("coil-") else GuardedInstrument(name, guardian)


def _sharing(loader: Loader, name: str, guardian: GuardianClient) -> Instrument:
    """An instrument on a line that the guardian owns: it speaks Modbus through it."""
    driver, hints, settings = loader.driver(name)
    if not speaks_modbus(hints):
        loader.refuse("this line belongs to a supply; only Modbus instruments share one", ("instruments", name, "link"))
    return cast(Instrument, driver(name, GuardedModbus(name, guardian), loader.clock, settings))


def _in_roles(
    loader: Loader,
    instruments: Mapping[str, Instrument],
    guardian: GuardianClient | None,
    cage: CageCalibration | None,
) -> Bench:
    config = loader.config
    roles: dict[str, Any] = {entry.role: instruments[name] for name, entry in config.instruments.items()}
    _refuse_limits_on_the_unknown(loader, roles["dut"])
    supplies = coil_supplies(roles, loader.clock) if guardian is None else {a: roles[f"coil-{a}"] for a in AXES}
    try:
        return Bench(
            config,
            loader.clock,
            instruments,
            supplies,
            BenchPlatform(roles["platform"], config.platform, config.dut.limits),
            roles["reference"],
            roles["dut"],
            SimulatedOperator(loader.twin, loader.clock) if config.simulated else None,
            {name: _link(loader, name, instrument, guardian) for name, instrument in instruments.items()},
            guardian,
            [axis for axis, supply in supplies.items() if getattr(supply, "has_contacts", False)],
            cage.carry if cage and config.reference.place == "remote" else None,
        )
    except LimitError as error:
        loader.refuse(str(error), ("cage", "limits"))


def _refuse_limits_on_the_unknown(loader: Loader, dut: DutStream) -> None:
    """A limit that nothing can bind would only look like one."""
    if loader.config.dut.limits.temperature_C is not None and not temperatures_of(dut, "dut"):
        loader.refuse("the DUT tells no temperature (a channel temp_…)", ("dut", "limits", "temperature_C"))
    if loader.config.cage.limits.temperature_C is not None and not temperatures_of(dut, "coil"):
        loader.refuse("no channel temp_coil… tells it", ("cage", "limits", "temperature_C"))


def _link(loader: Loader, name: str, instrument: Instrument, guardian: GuardianClient | None) -> Reopens:
    if isinstance(instrument, GuardedInstrument):
        return instrument
    line = loader.line_of(name)
    return loader.links[line] if guardian is None or line in loader.links else GuardedModbus(name, guardian)


def coil_supplies(roles: Mapping[str, Any], clock: Clock) -> dict[str, CoilSupply]:
    """The signed supply of each axis: bipolar by itself, or unipolar behind the reversing contacts of that axis."""
    relay: PolarityRelay | None = roles.get("polarity")
    supplies: dict[str, CoilSupply] = {axis: roles[f"coil-{axis}"] for axis in AXES}
    if relay is None:
        return supplies
    return {
        axis: ReversedSupply(axis, supply, relay, clock) if relay.reverses(axis) else supply
        for axis, supply in supplies.items()
    }
