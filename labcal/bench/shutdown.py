"""Coils off, with nothing but the supplies and their contacts: whatever else is wrong with the bench."""

from __future__ import annotations

import errno
import json
import os
import signal
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, closing, contextmanager, nullcontext, suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from labcal.bench.coils.at_zero import FREE_S, FROM_HERE, ORDERED, AtZero
from labcal.bench.essentials import AXES, Essentials, essentials, legible
from labcal.bench.guardian.client import (
    Connection,
    answered,
    connections,
    driven_before,
    guarded_benches,
    guarding,
)
from labcal.bench.guardian.wire import zero_of
from labcal.bench.links import ports
from labcal.bench.redundant import outlived
from labcal.errors import InputError, InstrumentError

if TYPE_CHECKING:
    from labcal.bench.config import BenchConfig

    Bench = BenchConfig | Essentials

Meanwhile = Callable[[str], AbstractContextManager[object]]  # given what may be said where it takes long
ENDS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGTSTP") if hasattr(signal, name))
UNTOUCHED = (
    "no guardian drives this bench and no coil was touched. Correct the file and say off again, or switch the supplies "
    "off by hand"
)
OTHERS = (
    "no guardian was started for this file and no coil was touched, but a guardian drives the bench of {}: name that "
    "file, or switch the supplies off by hand"
)


def coils_off(
    path: Path, meanwhile: Meanwhile = nullcontext, once_ordered: Callable[[], None] = lambda: None
) -> list[AtZero]:
    """Bring every coil of `path` to zero and open it, `meanwhile` beside it; one report an axis, faults included.

    The guardian does it where one lives, also while the file cannot be read or names other ports than before; one that
    does not hear is ended, and another takes its place. What no guardian has reported is brought down from here, its
    ports held against everybody meanwhile; of a port that another program holds it is said. Of the file that is read
    which says where the supplies are, line by line where need be and whatever else is wrong with it. Raises InputError
    where no guardian lives and it does not say that. `once_ordered`: called, more than once, where who can hear an
    order of zero by now has it, and somebody else is waited for.
    """
    with _unbroken():
        return _brought_down(path, meanwhile, once_ordered)


@contextmanager
def _unbroken() -> Iterator[None]:
    """Neither Ctrl-C, Ctrl-Z nor a terminal that closes breaks off the way to zero: nobody else might be left."""
    if threading.current_thread() is not threading.main_thread():  # a thread beside it hears no signals
        yield
        return
    before = {number: signal.signal(number, signal.SIG_IGN) for number in ENDS}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _brought_down(path: Path, meanwhile: Meanwhile, once_ordered: Callable[[], None]) -> list[AtZero]:
    """`reported`: how supplies ended, of those that a guardian reported; `asked`: the addresses of those guardians."""
    deadline, reported, asked = time.monotonic() + FREE_S, dict[str, AtZero](), list[object]()
    before, wanting = list[Essentials](), list[OSError]()
    while True:
        late = time.monotonic() > deadline
        with _noting(wanting):
            for guardian, number in _ordered(guarding(path, asked)):
                reported |= _reported_by(guardian, number, asked, meanwhile)
        before += [bench for bench in driven_before(path) if bench not in before]
        stated = _stated(path, needed=not asked and not before)
        benches = [*stated, *before]
        with _noting(wanting):
            ours = {supply for bench in benches for supply in _supplies(bench).values()}
            for guardian, number in _ordered(connections(_links(benches), asked)):
                ended = _reported_by(guardian, number, asked, meanwhile)
                reported |= {supply: end for supply, end in ended.items() if supply in ours}
            left = _left(benches, reported)
            if not left:
                return _in_order(reported, stated)
            free = _free(_links(benches), asked, late=late)
            if free is not None and ports.hold(free):
                return _in_order(reported | _the_rest(path, left, meanwhile), stated)
        if late and wanting:
            raise InstrumentError(
                f"the system gives this process no more ({wanting[-1].strerror}); how the coils are is not known.",
                remedy="Switch the supplies off by hand, or say off again in a new terminal.",
            )
        if late:
            raise InstrumentError("a guardian holds the ports and does not answer.", fault="guardian lost")
        once_ordered()
        time.sleep(0.02)  # a guardian that comes or goes


@contextmanager
def _noting(wanting: list[OSError]) -> Iterator[None]:
    """A guardian that is gone is no matter; that the system has no handle or no memory left is kept in `wanting`."""
    try:
        yield
    except OSError as error:
        if error.errno in (errno.EMFILE, errno.ENFILE, errno.ENOMEM):
            wanting.append(error)


def _stated(path: Path, *, needed: bool) -> Sequence[Bench]:
    """What the file states, nothing where it cannot be read; where it is `needed`, what of it can be read at all.

    Raises InputError where that is no supply's place either.
    """
    stated: list[Bench] = []
    try:
        stated.append(_readable(path))
    except InputError:
        if needed and not (stated := _legible(path)):
            raise
    for bench in stated[:1]:
        with suppress(InputError):  # the group's folder is not there: it goes on without
            ports.meet(bench.safety.group, bench.safety.runtime)
    return stated


def _legible(path: Path) -> list[Bench]:
    try:
        return [*legible(path)]
    except OSError:
        return []


def _links(benches: Sequence[Bench]) -> list[str]:
    return list(dict.fromkeys(link for bench in benches for link in bench.guarded_links))


def _left(benches: Sequence[Bench], reported: Mapping[str, AtZero]) -> list[tuple[Bench, list[str]]]:
    """Of each bench the axes whose supplies nobody has reported, each supply once; what is missing is the first's."""
    left: list[tuple[Bench, list[str]]] = []
    known = {*reported}
    for number, bench in enumerate(benches):
        named = bench.axes if number and isinstance(bench, Essentials) else AXES
        supplies = _supplies(bench)
        left.append((bench, [axis for axis in named if supplies[axis] not in known]))
        known |= {*supplies.values()}
    return [(bench, axes) for bench, axes in left if axes]


def _supplies(bench: Bench) -> dict[str, str]:
    """The supply of each axis; of one that is emulated, named twice or not at all, a name that nobody else has."""
    from labcal.bench.guardian.supplies import supplies_of

    named = dict[str, str]()
    for axis, supply in supplies_of(bench).items():
        if supply not in named.values():
            named[axis] = supply
    return {axis: f"{axis} of {id(bench)}" for axis in AXES} | named


def _ordered(guardians: Iterable[Connection]) -> list[tuple[Connection, int]]:
    """Each with the number of its order: all of them have it before any is waited for."""
    ordered = list[tuple[Connection, int]]()
    for guardian in guardians:
        with suppress(ConnectionError):  # it is gone; who comes after it is looked for again
            ordered.append((guardian, guardian.order("zero", why=f"labcal bench off, process {os.getpid()}")))
    return ordered


def _reported_by(guardian: Connection, number: int, asked: list[object], meanwhile: Meanwhile) -> dict[str, AtZero]:
    """How those coils ended that a living guardian holds, by supply.

    The guardian of another bench file may hold only some of these supplies, and know them as other axes. One that does
    not answer keeps nobody from the rest.
    """
    asked.append(guardian.card["address"])
    theirs = {str(axis): str(supply) for axis, supply in dict(guardian.card.get("supplies") or {}).items()}
    try:
        with closing(guardian), meanwhile(ORDERED):
            ended = [zero_of(end) for end in answered(guardian, number)]
    except OSError:
        asked.pop()
        raise
    except InstrumentError as fault:
        ended = [AtZero(axis, None, False, fault) for axis in theirs or AXES]
    return {theirs.get(end.axis, f"{end.axis} of {guardian.card['address']}"): end for end in ended}


def _in_order(reported: Mapping[str, AtZero], stated: Sequence[Bench]) -> list[AtZero]:
    """The ends, each by the axis that the file gives its supply; whom it does not name is of an earlier session."""
    axes = {supply: axis for bench in stated[:1] for axis, supply in _supplies(bench).items()}
    named = [
        replace(end, axis=axes[supply]) if supply in axes else _of_earlier(end, _port(supply)) if axes else end
        for supply, end in reported.items()
    ]
    return sorted(named, key=lambda end: end.axis)


def _of_earlier(end: AtZero, port: str) -> AtZero:
    return replace(end, axis=f"{end.axis} at {port}", earlier_at=port)


def _port(supply: str) -> str:
    try:
        return str(json.loads(supply)[0])
    except (ValueError, IndexError, TypeError, KeyError):
        return "another supply"


def _free(urls: Sequence[str], asked: Sequence[object], *, late: bool) -> list[str] | None:
    """The ports that nobody holds; None while who holds another may be a guardian that comes or goes, until `late`."""
    cards = {url: ports.holder(url) for url in urls}
    known = (card is None or "program" in card or card.get("address") in asked for card in cards.values())
    return [url for url, card in cards.items() if card is None] if late or all(known) else None


def _the_rest(path: Path, left: Sequence[tuple[Bench, list[str]]], meanwhile: Meanwhile) -> dict[str, AtZero]:
    """Bring down with own hands what no guardian has reported; the ports that could be had are held meanwhile."""
    ports.announce({"pid": os.getpid()})
    in_doubt = True
    try:
        ended = outlived(partial(_with_own_hands, path, left))
        with meanwhile(FROM_HERE):
            supplies = [_supplies(bench)[axis] for bench, axes in left for axis in axes]
            ends = dict(zip(supplies, ended(), strict=True))
        in_doubt = any(end.current_A is None for end in ends.values())
        return ends
    finally:
        ports.let_go(in_doubt=in_doubt)


def _readable(path: Path) -> Bench:
    try:
        if (found := essentials(path)) is not None:
            return found
        from labcal.bench.config import read_config  # all of it, which takes longest to load

        return read_config(path)
    except InputError as error:
        raise InputError(f"{error.what}; {_untouched()}", file=path, line=error.line, column=error.column) from error
    except OSError as error:
        raise InputError(f"cannot be read ({error.strerror}); {_untouched()}", file=path) from error


def unread(path: Path) -> str:
    """Why the file says nothing of its supplies now; "" where it does."""
    try:
        if essentials(path) is None:
            from labcal.bench.config import read_config

            read_config(path)
    except InputError as error:
        return str(error)
    except OSError as error:
        return f"{path}: cannot be read ({error.strerror})"
    return ""


def _untouched() -> str:
    """That nothing was done, and what may be: somebody may have meant the file of another guardian that lives."""
    benches = guarded_benches()
    return OTHERS.format(" and of ".join(benches)) if benches else UNTOUCHED


def _with_own_hands(path: Path, left: Sequence[tuple[Bench, list[str]]]) -> list[AtZero]:
    """A guardian within this process for each bench, for one zero of these coils of it; their ends in this order."""
    from labcal.bench.guardian.controller import Guardian  # what is not lost where one lives already
    from labcal.bench.guardian.logbook import note, written

    ended = list[AtZero]()
    for bench, axes in left:
        guardian = Guardian(path, bench, note)
        for axis in [axis for axis in guardian.coils if axis not in axes]:
            del guardian.coils[axis]
        try:
            done = {end.axis: end for end in guardian.zero(f"labcal bench off, process {os.getpid()}")}
        finally:
            guardian.close()
        ended += [done.get(axis) or _unnamed(path, axis) for axis in axes]
    written(at_most_s=2.0)
    return ended


def _unnamed(path: Path, axis: str) -> AtZero:
    """The end of a coil whose supply the file does not name."""
    what = f"not reached: {path} names no supply for coil {axis}."
    remedy = "Correct the file and say off again, or switch this supply off by hand."
    return AtZero(axis, None, False, InstrumentError(what, fault="not reached", remedy=remedy))
