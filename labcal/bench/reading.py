"""The lab as it is now, read and not set: what each coil carries, who answers, the field, where the platform stands.

For while no run goes on. A port is held for one question and let go of, so that whoever wants it (a run in another
process, `labcal bench off`) has it as soon as that is answered; where a guardian lives on it, the guardian is asked how
its coils ended, and the line is left alone.
"""

from __future__ import annotations

import os
import time
from collections.abc import Collection, Iterator
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib import import_module
from pathlib import Path
from typing import Any, cast

import numpy as np

from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.coils.state import Vector
from labcal.bench.config import BenchConfig, read_config
from labcal.bench.driver_kit.roles import ByHand, CoilSupply, Instrument, Magnetometer, Releasable, RotationPlatform
from labcal.bench.guardian.client import Connection, found
from labcal.bench.guardian.supplies import supplies_of
from labcal.bench.guardian.wire import zero_of
from labcal.bench.line_advice import advised
from labcal.bench.links import ports
from labcal.bench.links.quoting import abridged
from labcal.bench.loading import Loader, speaks_modbus
from labcal.bench.streams.reference import blind, into_cage
from labcal.bench.streams.samples import samples
from labcal.errors import InstrumentError

LISTEN_S = 0.5  # to the reference
ANSWER_S = 2.0  # that a guardian has to say how its coils ended: it waits for no line
IN_USE = ("in use",)  # faults that say nothing against the instrument


@dataclass(frozen=True, slots=True)
class InstrumentReading:
    """One instrument as it was read at `read_s` (monotonic clock). What is None was not read, or is not its to say.

    `fault`: why it did not answer. `held`: another process has it, and nothing was asked. `until`: its guardian has it
    until these supplies are read back at zero.
    """

    name: str
    role: str
    link: str
    identity: str = ""
    fault: InstrumentError | None = None
    held: bool = False
    read_s: float | None = None
    current_A: float | None = None
    zero: bool = False
    field_nT: Vector | None = None
    angle_deg: float | None = None
    moving: bool | None = None
    serial: str = ""
    until: tuple[str, ...] = ()


def read_lab(path: Path, names: Collection[str] = ()) -> list[InstrumentReading]:
    """Read these instruments of the bench `path` (none named: all), one after another. Raises InputError for the file.

    Nothing is set or moved; a supply is given back to its panel, where a person may have to switch it off.
    """
    loader = _loader(path)
    loader.meet_group()
    with closing(loader):
        return [_read(loader, name) for name in loader.config.instruments if not names or name in names]


def prepare_to_read(path: Path) -> None:
    """Load drivers, and the simulated lab where there is one; opens nothing. Raises InputError for the file."""
    loader = _loader(path)
    for name in loader.config.instruments:
        if loader.line_of(name).startswith("emulated://"):
            loader.emulator(name)
        elif speaks_modbus(loader.driver(name)[1]):
            import_module("labcal.bench.links.modbus")


def _loader(path: Path) -> Loader:
    config = read_config(path)
    loader = Loader(path, config, VirtualClock(datetime.now(UTC)) if config.simulated else RealClock(), 0)
    loader.look_over()
    return loader


def _read(loader: Loader, name: str) -> InstrumentReading:
    entry = loader.config.instruments[name]
    try:
        if name in loader.config.guarded and (guardian := found([entry.link])) is not None:
            with closing(guardian):
                return _of_guardian(guardian, loader.config, name)
        with held(loader, name):
            return _asked(loader, name)
    except InstrumentError as fault:
        other = fault.fault in IN_USE
        return InstrumentReading(
            name, entry.role, entry.link, fault=None if other else advised(fault, entry), held=other
        )


def _of_guardian(guardian: Connection, config: BenchConfig, name: str) -> InstrumentReading:
    """Its current as the guardian reads it now, else how its coil ended by the guardian's last word.

    One that it drives, or that is no coil, is left to it.
    """
    entry = config.instruments[name]
    ours = supplies_of(config).get(entry.role[-1]) if entry.role.startswith("coil-") else None
    theirs = {supply: axis for axis, supply in dict(guardian.card.get("supplies") or {}).items()}
    ends = [zero_of(end) for end in _said(guardian, "ends") or []]
    end = next((end for end in ends if ours is not None and end.axis == theirs.get(ours)), None)
    silent = {end.axis for end in ends if end.current_A is None}
    until = tuple(one for axis, supply in supplies_of(config).items() if theirs.get(supply) in silent
                  for one, said in config.instruments.items() if said.role == f"coil-{axis}")  # fmt: skip
    if end is None:
        return InstrumentReading(name, entry.role, entry.link, held=True, until=until)
    if end.current_A is None:
        return InstrumentReading(name, entry.role, entry.link, fault=end.fault, read_s=end.read_s)
    current_A, zero, read_s = _read_by(guardian, end.axis) or (end.current_A, True, end.read_s)
    return InstrumentReading(name, entry.role, entry.link, read_s=read_s, current_A=current_A, zero=zero, until=until)


def _read_by(guardian: Connection, axis: str) -> tuple[float, bool, float] | None:
    """What that coil carries now [A], whether that counts as zero, and when; None where the guardian cannot say."""
    facts, current_A = _said(guardian, "facts"), _said(guardian, "read", axis=axis)
    if facts is None or current_A is None:
        return None
    return float(current_A), abs(current_A) < facts[axis]["zero_current_A"], time.monotonic()


def _said(guardian: Connection, order: str, **what: str) -> Any:
    """Its answer; None where it is busy, fails at it, or is gone: it is not ended for a question."""
    with suppress(OSError):
        number, deadline = guardian.order(order, **what), time.monotonic() + ANSWER_S
        while time.monotonic() < deadline:
            if (reply := guardian.reply(number, 0.05)) is not None:
                return reply.get("value")
    return None


@contextmanager
def held(loader: Loader, name: str) -> Iterator[None]:
    """Its line, for as long as it takes. Raises InstrumentError (in use) where another process has it."""
    line = loader.line_of(name)
    if "://" not in line or line.startswith(("emulated://", "manual://")):
        yield
        return
    ports.refuse_connected([line])
    if not ports.hold([line]):
        raise InstrumentError(f"{line}: another process has this port.", fault="in use")
    ports.announce({"pid": os.getpid(), ports.BRIEF: True})
    try:
        yield
    finally:
        loader.masters.pop(line, None)
        if (link := loader.links.pop(line, None)) is not None:
            link.close()
        ports.let_go(in_doubt=True)  # what a guardian that died had driven here stays known


def _asked(loader: Loader, name: str) -> InstrumentReading:
    """Who answers, and what it reads now."""
    entry, instrument = loader.config.instruments[name], loader.instrument(name)
    who = instrument.identify()
    identity = abridged(" ".join(filter(None, (who.manufacturer, who.model, who.serial, who.firmware))))
    field, (current_A, zero), (angle, moving) = None, _current(instrument), _angle(instrument)
    if entry.role == "reference" and not blind(loader.config.reference):
        field = _field(loader, cast(Magnetometer, instrument))
    return InstrumentReading(
        name, entry.role, entry.link, identity, None, False, time.monotonic(), current_A, zero, field, angle, moving,
        abridged(who.serial),
    )  # fmt: skip


def _current(instrument: Instrument) -> tuple[float | None, bool]:
    """What a supply delivers [A], and whether that counts as zero; then it is given back to its panel."""
    if not isinstance(instrument, CoilSupply):
        return None, False
    current_A = instrument.measure_current()
    if isinstance(instrument, Releasable):
        instrument.release()
    return current_A, abs(current_A) < instrument.zero_current_A


def _angle(instrument: Instrument) -> tuple[float | None, bool | None]:
    """Where a platform with a motor stands [deg], and whether it moves."""
    if isinstance(instrument, RotationPlatform) and not isinstance(instrument, ByHand):
        return instrument.state()
    return None, None


def _field(loader: Loader, sensor: Magnetometer) -> Vector | None:
    """The median of what the reference sends now (3,) [nT, C]."""
    sensor.start()
    try:
        rows = samples(sensor.read_until(loader.clock.now() + LISTEN_S), "reference").values
    finally:
        sensor.stop()
    if not len(rows):
        return None
    x, y, z = np.median(into_cage(rows, loader.config.reference), axis=0).tolist()
    return x, y, z
