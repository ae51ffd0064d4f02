"""Coils off, with nothing but the supplies and their contacts: whatever else is wrong with the bench."""

from __future__ import annotations

import os
import time
from contextlib import ExitStack, closing, suppress
from pathlib import Path
from typing import cast

from labcal.bench.clock import Clock, RealClock
from labcal.bench.config import AXES, BenchConfig, read_config
from labcal.bench.guardian.client import Connection, ask_once, found, guarding
from labcal.bench.guardian.wire import zero_of
from labcal.bench.links import ports
from labcal.bench.loading import Loader
from labcal.bench.roles import CoilSupply
from labcal.bench.zero import AtZero, to_zero
from labcal.errors import InputError, InstrumentError

FREE_S = 5.0
UNTOUCHED = (
    "no guardian drives this bench and no coil was touched. Correct the file and say off again, or switch the supplies "
    "off by hand"
)
BY_HAND = "Correct the file and say off again, or switch this supply off by hand."


def coils_off(path: Path, clock: Clock | None = None) -> list[AtZero]:
    """Bring every coil of `path` to zero and open it; one report an axis, faults included.

    The guardian does it where one lives, also while the file cannot be read or names other ports than before; else the
    ports are opened here, and held against everybody meanwhile. Raises InputError where no guardian lives and the file
    does not say where the supplies are.
    """
    deadline = time.monotonic() + FREE_S
    while time.monotonic() < deadline:
        with suppress(OSError):
            if (guardian := guarding(path)) is not None:
                return _asked(guardian)
        config = _readable(path)
        with suppress(InputError):  # the group's folder is not there: it goes on without
            ports.meet(config.safety.group, config.safety.runtime)
        real = config.guarded_links
        with suppress(OSError):
            if (guardian := found(real)) is not None:
                return _asked(guardian)
            if ports.hold(real):
                ports.announce({"pid": os.getpid()})
                try:
                    return _with_own_hands(Loader(path, config, clock or RealClock(), 0))
                finally:
                    ports.let_go()
        time.sleep(0.02)  # a guardian that comes or goes
    raise InstrumentError("a guardian holds the ports and does not answer.", fault="guardian lost")


def _asked(guardian: Connection) -> list[AtZero]:
    with closing(guardian):
        return [zero_of(end) for end in ask_once(guardian, "zero", why=f"labcal bench off, process {os.getpid()}")]


def _readable(path: Path) -> BenchConfig:
    try:
        return read_config(path)
    except InputError as error:
        raise InputError(f"{error.what}; {UNTOUCHED}", file=path, line=error.line, column=error.column) from error
    except OSError as error:
        raise InputError(f"cannot be read ({error.strerror}); {UNTOUCHED}", file=path) from error


def _with_own_hands(loader: Loader) -> list[AtZero]:
    config = loader.config
    limits = dict(zip(AXES, config.cage.limits.ramp_A_per_s, strict=True))
    with ExitStack() as afterwards:
        supplies, unreachable = _reachable(loader, afterwards)
        rates = {axis: min(limits[axis], supply.ramp_A_per_s) for axis, supply in supplies.items()}
        ended = {**unreachable, **to_zero(supplies, rates, loader.clock)}
        for axis, supply in supplies.items():
            if ended[axis].fault is None:
                with suppress(InstrumentError):  # it is at zero; this gives it back to its panel
                    supply.make_safe()
    return [ended[axis] for axis in AXES]


def _reachable(loader: Loader, afterwards: ExitStack) -> tuple[dict[str, CoilSupply], dict[str, AtZero]]:
    """Supplies whose link opens and that answer, without the contacts: zero has no sign."""
    supplies: dict[str, CoilSupply] = {}
    unreachable: dict[str, AtZero] = {}
    for name, entry in loader.config.instruments.items():
        if not entry.role.startswith("coil-"):
            continue
        axis = entry.role[-1]
        try:
            supply = loader.instrument(name)
            afterwards.callback(supply.close)
            supply.identify()
            supplies[axis] = cast(CoilSupply, supply)
        except InstrumentError as error:
            unreachable[axis] = AtZero(axis, None, False, error)
        except InputError as error:  # what is wrong with one supply's entry keeps no other from zero
            unreachable[axis] = AtZero(
                axis, None, False, InstrumentError(f"{error}.", fault="not reached", remedy=BY_HAND)
            )
    return supplies, unreachable
