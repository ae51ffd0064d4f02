"""Who stands on a bench: every instrument is asked on its own, so that one that is silent hides no other."""

from __future__ import annotations

from contextlib import ExitStack, closing, suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.config import read_config
from labcal.bench.driver_kit.identities import one_at_two_links
from labcal.bench.driver_kit.roles import CoilSupply, Identity
from labcal.bench.guardian.client import ask_once, found
from labcal.bench.line_advice import advised
from labcal.bench.links import ports
from labcal.bench.links.quoting import abridged
from labcal.bench.loading import Loader
from labcal.bench.specification import specification_of
from labcal.errors import InstrumentError


@dataclass(frozen=True, slots=True)
class Identified:
    """One instrument: who it says it is, or why there is no answer.

    `flows_A` is what was measured of a coil's supply that no guardian watches; None where that is no current.
    """

    name: str
    role: str
    link: str
    identity: str = ""
    fault: InstrumentError | None = None
    flows_A: float | None = None
    serial: str = ""


def identify_all(path: Path) -> list[Identified]:
    """Ask every instrument of `path` who it is. Raises InputError for a bad file.

    A supply that answers at the links of two coils is a fault of both.
    """
    config = read_config(path)
    specification_of(config, path)  # what is wrong with it is said before a run asks for it
    loader = Loader(path, config, VirtualClock(datetime.now(UTC)) if config.simulated else RealClock(), 0)
    loader.look_over()
    loader.meet_group()
    with ExitStack() as afterwards:
        afterwards.callback(loader.close)
        answers = {name: _answer(loader, name) for name in config.instruments}
        flows_A = {name: _unwatched_current(loader, name) for name, who in answers.items() if isinstance(who, Identity)}
    coils = {
        name: who
        for name, who in answers.items()
        if isinstance(who, Identity) and config.instruments[name].role.startswith("coil-")
    }
    answers |= one_at_two_links(coils, {name: config.instruments[name].link for name in coils})
    return [_identified(loader, name, answer, flows_A.get(name)) for name, answer in answers.items()]


def _asked(loader: Loader, name: str) -> Identity:
    """Who answers: through the guardian where one lives and owns the port, else on a link of our own."""
    if name in loader.config.guarded:
        link = loader.config.instruments[name].link
        if (guardian := found([link])) is not None:
            with closing(guardian):
                return Identity(**ask_once(guardian, "identify", name=name))
        ports.refuse_connected([] if loader.config.simulated else [link])
    return loader.instrument(name).identify()


def _answer(loader: Loader, name: str) -> Identity | InstrumentError:
    try:
        return _asked(loader, name)
    except InstrumentError as error:
        return advised(error, loader.config.instruments[name])


def _unwatched_current(loader: Loader, name: str) -> float | None:
    """The current [A] that a coil's supply delivers where no guardian lives; None where it is none, or not said."""
    entry = loader.config.instruments[name]
    if not entry.role.startswith("coil-"):
        return None
    if (guardian := found([entry.link])) is not None:
        guardian.close()
        return None
    supply = loader.instrument(name)
    with suppress(InstrumentError):
        if isinstance(supply, CoilSupply) and abs(current_A := supply.measure_current()) >= supply.zero_current_A:
            return current_A
    return None


def _identified(
    loader: Loader, name: str, answer: Identity | InstrumentError, flows_A: float | None = None
) -> Identified:
    entry = loader.config.instruments[name]
    if isinstance(answer, InstrumentError):
        return Identified(name, entry.role, entry.link, fault=answer)
    words = (answer.manufacturer, answer.model, answer.serial, answer.firmware)
    said = abridged(" ".join(part for part in words if part))
    return Identified(name, entry.role, entry.link, said, flows_A=flows_A, serial=abridged(answer.serial))
