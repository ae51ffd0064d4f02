"""Who stands on a bench: every instrument is asked on its own, so that one that is silent hides no other."""

from __future__ import annotations

from contextlib import ExitStack, closing
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.config import read_config
from labcal.bench.guardian.client import ask_once, found
from labcal.bench.links import ports
from labcal.bench.loading import Loader
from labcal.bench.roles import Identity
from labcal.errors import InstrumentError


@dataclass(frozen=True, slots=True)
class Greeting:
    """One instrument: who it says it is, or why there is no answer."""

    name: str
    role: str
    link: str
    identity: str = ""
    fault: InstrumentError | None = None


def greet(path: Path) -> list[Greeting]:
    """Ask every instrument of `path` who it is. Raises InputError for a bad file."""
    config = read_config(path)
    loader = Loader(path, config, VirtualClock(datetime.now(UTC)) if config.simulated else RealClock(), 0)
    loader.meet_group()
    with ExitStack() as afterwards:
        afterwards.callback(loader.close)
        return [_greet(loader, name) for name in config.instruments]


def _asked(loader: Loader, name: str) -> Identity:
    """Who answers: through the guardian where one lives and owns the port, else on a link of our own."""
    if name in loader.config.guarded:
        link = loader.config.instruments[name].link
        if (guardian := found([link])) is not None:
            with closing(guardian):
                return Identity(**ask_once(guardian, "identify", name=name))
        ports.refuse_connected([] if loader.config.simulated else [link])
    return loader.instrument(name).identify()


def _greet(loader: Loader, name: str) -> Greeting:
    entry = loader.config.instruments[name]
    try:
        who = _asked(loader, name)
    except InstrumentError as error:
        return Greeting(name, entry.role, entry.link, fault=error)
    words = " ".join(part for part in (who.manufacturer, who.model, who.serial, who.firmware) if part)
    return Greeting(name, entry.role, entry.link, words)
