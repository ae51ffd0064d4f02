"""Coils off, with nothing but the supplies and their contacts: whatever else is wrong with the bench."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, closing, contextmanager, nullcontext, suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from labcal.bench.coils.at_zero import FROM_HERE, ORDERED, AtZero
from labcal.bench.guardian.client import Connection, ask_once, connections, guarded_benches, guarding
from labcal.bench.guardian.wire import zero_of
from labcal.bench.links import ports
from labcal.bench.redundant import outlived
from labcal.errors import InputError, InstrumentError

if TYPE_CHECKING:
    from labcal.bench.config import BenchConfig

Meanwhile = Callable[[str], AbstractContextManager[object]]  # given what may be said where it takes long
AXES = "xyz"
FREE_S = 5.0
ENDS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
UNTOUCHED = (
    "no guardian drives this bench and no coil was touched. Correct the file and say off again, or switch the supplies "
    "off by hand"
)
OTHERS = (
    "no guardian was started for this file and no coil was touched, but a guardian drives the bench of {}: name that "
    "file, or switch the supplies off by hand"
)


def coils_off(path: Path, meanwhile: Meanwhile = nullcontext) -> list[AtZero]:
    """Bring every coil of `path` to zero and open it, `meanwhile` beside it; one report an axis, faults included.

    The guardian does it where one lives, also while the file cannot be read or names other ports than before. What no
    guardian has told of is brought down from here, its ports held against everybody meanwhile; of a port that another
    program holds that is told. Raises InputError where no guardian lives and the file does not say where the supplies
    are.
    """
    with _unbroken():
        return _brought_down(path, meanwhile)


@contextmanager
def _unbroken() -> Iterator[None]:
    """Neither Ctrl-C nor a terminal that closes breaks off the way to zero: nobody else might be left to go on."""
    if threading.current_thread() is not threading.main_thread():  # a thread beside it hears no signals
        yield
        return
    before = {number: signal.signal(number, signal.SIG_IGN) for number in ENDS}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _brought_down(path: Path, meanwhile: Meanwhile) -> list[AtZero]:
    deadline, reported, asked = time.monotonic() + FREE_S, dict[str, AtZero](), list[object]()
    while True:
        late = time.monotonic() > deadline
        with suppress(OSError):
            if not asked and (guardian := guarding(path)) is not None:
                return _asked(guardian, meanwhile)
        config = _readable(path)
        with suppress(InputError):  # the group's folder is not there: it goes on without
            ports.meet(config.safety.group, config.safety.runtime)
        with suppress(OSError):
            reported |= _reported_by_guardians(config, asked, meanwhile)
            if len(reported) == len(AXES):
                return [reported[axis] for axis in AXES]
            free = _free(config.guarded_links, asked, late=late)
            if free is not None and ports.hold(free):
                return _the_rest(path, config, reported, meanwhile)
        if late:
            raise InstrumentError("a guardian holds the ports and does not answer.", fault="guardian lost")
        time.sleep(0.02)  # a guardian that comes or goes


def _reported_by_guardians(config: BenchConfig, asked: list[object], meanwhile: Meanwhile) -> dict[str, AtZero]:
    """How those coils ended that living guardians hold; whom this asks it adds to `asked`.

    The guardian of another bench file may hold only some of these supplies, and know them as other axes. One that does
    not answer keeps nobody from the rest.
    """
    from labcal.bench.guardian.supplies import supplies_of

    reported = dict[str, AtZero]()
    for guardian in connections(config.guarded_links, asked):
        asked.append(guardian.card["address"])
        theirs = dict(guardian.card.get("supplies") or {})
        try:
            ended = {str(theirs.get(end.axis)): end for end in _asked(guardian, meanwhile)}
        except InstrumentError as fault:
            ended = {str(supply): AtZero(axis, None, False, fault) for axis, supply in theirs.items()}
        reported |= {axis: replace(ended[one], axis=axis) for axis, one in supplies_of(config).items() if one in ended}
    return reported


def _free(urls: Sequence[str], asked: Sequence[object], *, late: bool) -> list[str] | None:
    """The ports that nobody holds; None while who holds another may be a guardian that comes or goes, until `late`."""
    cards = {url: ports.holder(url) for url in urls}
    known = (card is None or "program" in card or card.get("address") in asked for card in cards.values())
    return [url for url, card in cards.items() if card is None] if late or all(known) else None


def _the_rest(path: Path, config: BenchConfig, reported: Mapping[str, AtZero], meanwhile: Meanwhile) -> list[AtZero]:
    """Bring down with own hands what no guardian has told of; the ports that could be had are held meanwhile."""
    ports.announce({"pid": os.getpid()})
    try:
        ended = outlived(partial(_with_own_hands, path, config, reported.keys()))
        with meanwhile(FROM_HERE):
            return sorted([*reported.values(), *ended()], key=lambda end: end.axis)
    finally:
        ports.let_go()


def _asked(guardian: Connection, meanwhile: Meanwhile) -> list[AtZero]:
    with closing(guardian), meanwhile(ORDERED):
        return [zero_of(end) for end in ask_once(guardian, "zero", why=f"labcal bench off, process {os.getpid()}")]


def _readable(path: Path) -> BenchConfig:
    from labcal.bench.config import read_config

    try:
        return read_config(path)
    except InputError as error:
        raise InputError(f"{error.what}; {_untouched()}", file=path, line=error.line, column=error.column) from error
    except OSError as error:
        raise InputError(f"cannot be read ({error.strerror}); {_untouched()}", file=path) from error


def _untouched() -> str:
    """That nothing was done, and what may be: somebody may have meant the file of another guardian that lives."""
    benches = guarded_benches()
    return OTHERS.format(" and of ".join(benches)) if benches else UNTOUCHED


def _with_own_hands(path: Path, config: BenchConfig, without: Collection[str]) -> list[AtZero]:
    """A guardian within this process, for one zero of all coils but those `without`."""
    from labcal.bench.guardian.controller import Guardian  # half a second that is not lost where one lives already
    from labcal.bench.guardian.logbook import note, written

    guardian = Guardian(path, config, note)
    for axis in without:
        del guardian.coils[axis]
    try:
        return guardian.zero(f"labcal bench off, process {os.getpid()}")
    finally:
        guardian.close()
        written(at_most_s=2.0)
