"""Who is there: instruments whose lines are apart are asked at the same time, those on one line one after another."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from typing import Protocol

from labcal.bench.clock import Clock, RealClock
from labcal.bench.config import BenchConfig
from labcal.bench.driver_kit.roles import Identity
from labcal.errors import InstrumentError

LOOK_S = 0.005  # how often it is seen whether the others have answered
HOLDS_S = 5.0  # so long an answer is true of a link that stayed open: nobody changes plugs as fast
Answers = dict[str, Identity | InstrumentError]


class Identifies(Protocol):
    """What can be asked who it is."""

    def identify(self) -> Identity:
        """Who answers. Raises InstrumentError."""
        ...


class Identifications:
    """Those on lines of the session's own, asked while the guardian still brings the coils to zero: each only once."""

    def __init__(self) -> None:
        self._begun: dict[str, Future[Answers]] = {}

    def begin(self, instruments: Mapping[str, Identifies], apart: Mapping[str, str], clock: Clock) -> None:
        """Ask them, each line in a thread of its own; `apart` as in `identified`. In simulated time nobody is asked."""
        lines = _lines(apart, clock)
        with suppress(RuntimeError):  # no thread to be had: they are asked with the others
            pool = ThreadPoolExecutor(max(len(lines), 1), "identify")
            for names in lines.values():
                self._begun |= dict.fromkeys(names, pool.submit(_apart, clock, instruments, names))
            pool.shutdown(wait=False)

    def instead(self, instruments: Mapping[str, Identifies]) -> dict[str, Identifies]:
        """The same, where those that have answered are not asked again."""
        return {n: AlreadyAsked(n, one, self._begun[n]) if n in self._begun else one for n, one in instruments.items()}


class AlreadyAsked:
    """One that was asked already; where it did not answer then, with a busy computer, it is asked again."""

    def __init__(self, name: str, one: Identifies, begun: Future[Answers]) -> None:
        self._name, self._one, self._begun = name, one, begun

    def identify(self) -> Identity:
        """Its answer, as soon as it is there. Raises InstrumentError."""
        answer = self._begun.result().get(self._name)
        return answer if isinstance(answer, Identity) else self._one.identify()


def identified(instruments: Mapping[str, Identifies], apart: Mapping[str, str], clock: Clock) -> dict[str, Identity]:
    """Each one's identity by name. Raises the InstrumentError of the first, in their order, that is silent or another.

    `apart`: the lines of those that may be asked in a thread of their own. All others are asked here, one after
    another; meanwhile, and until all have answered, this thread alone looks at every line, as waiting does.
    """
    lines = _lines(apart, clock)
    elsewhere = {name for names in lines.values() for name in names}
    with ThreadPoolExecutor(max(len(lines), 1), "identify") as pool:
        begun = [pool.submit(_apart, clock, instruments, names) for names in lines.values()]
        answers = _asked(instruments, (name for name in instruments if name not in elsewhere))
        while not all(one.done() for one in begun):
            clock.wait_until(clock.now() + LOOK_S)
    for one in begun:
        answers |= one.result()
    return {name: _said(answers[name]) for name in instruments}  # one that was not asked comes after one at fault


def lines_apart(config: BenchConfig) -> dict[str, str]:
    """The lines of the session's own instruments that are real ones, and not the guardian's."""
    ours = ((name, one.link) for name, one in config.instruments.items() if one.link not in config.guarded_links)
    return {name: link for name, link in ours if not link.startswith(("emulated://", "manual://"))}


def _lines(apart: Mapping[str, str], clock: Clock) -> dict[str, list[str]]:
    lines: dict[str, list[str]] = {}
    for name, line in apart.items() if isinstance(clock, RealClock) else ():
        lines.setdefault(line, []).append(name)
    return lines


def _apart(clock: Clock, instruments: Mapping[str, Identifies], names: Iterable[str]) -> Answers:
    assert isinstance(clock, RealClock)
    with clock.apart():
        return _asked(instruments, names)


def _asked(instruments: Mapping[str, Identifies], names: Iterable[str]) -> Answers:
    """Their answers, up to the first that is none."""
    answers = Answers()
    for name in names:
        try:
            answers[name] = instruments[name].identify()
        except InstrumentError as fault:
            answers[name] = fault
            break
    return answers


def _said(answer: Identity | InstrumentError) -> Identity:
    if isinstance(answer, InstrumentError):
        raise answer
    return answer
