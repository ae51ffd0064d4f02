"""How the coils on one line come down: who may not answer is written zero first, the others ramp, all are read back."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import cast

from labcal.bench.coils.zero import AtZero, to_zero, write_zero
from labcal.bench.driver_kit.roles import CoilSupply
from labcal.bench.guardian.coil import GuardedCoil
from labcal.errors import InstrumentError

REOPENED = ("silent", "babbles", "out of step", "link lost")  # faults after which the link is opened anew
TIMES_TOLD = 3  # at once, who may not answer: a line that lost one message may lose another; TCP loses none
ANSWER_S = 0.5  # that who may carry current is given to say who it is, and what it holds
SHORT_S = 0.125  # where somebody else on its line was silent: three silent ones take no longer than there is


def line_down(coils: Sequence[GuardedCoil], others: Sequence[str], notify: Callable[[], None]) -> list[AtZero]:
    """All coils of one line to zero; what is asked there meanwhile is given up. Never raises InstrumentError.

    `others`: supplies on other lines, which may answer here where cables were swapped. `notify`: a successor must know.
    """
    line = coils[0].line
    line.gate.close()
    with line.lock, line.gate.passing():
        for coil in coils:
            coil.latch.engage(coil.held_A if coil.energised else None)
        notify()
        for coil in coils:
            if coil.doubt is None:
                _identify(coil, ANSWER_S if all(other.doubt is None for other in coils) else SHORT_S)
        doubted = [coil for coil in coils if coil.doubt is not None]
        _write_zeros(doubted, others)
        ended = dict(_ramped([coil for coil in coils if coil.doubt is None], lossy=bool(doubted)))
        lost = [coil for coil in coils if coil.axis in ended and _link_lost(ended[coil.axis])]
        for coil in lost:
            coil.doubt = ended[coil.axis].fault
        _write_zeros(lost, others)
        ended |= _each_read_back([*doubted, *lost], others)
        for coil in coils:
            coil.settle(ended[coil.axis])
        return list(ended.values())


def _identify(coil: GuardedCoil, within_s: float) -> None:
    """See that the right instrument is at the end of the link, where that is not known yet or nothing flows.

    One that may carry current has so long to answer. Over a TCP connection it is asked for its set-point in any case:
    one that was forgotten at the other end takes every order and is heard by nobody.
    """
    line = coil.line
    hurry_s = line.clock.now() + within_s if coil.energised else float("inf")
    try:
        with line.gate.asking_until(hurry_s):
            if not coil.energised or not line.identified(coil.name):
                line.identify(coil.name)
            if coil.energised and (coil.held_A is None or line.is_connection):
                held_A = coil.bare.set_point()
                coil.held_A = held_A if coil.held_A is None else coil.held_A
    except InstrumentError as fault:
        named = fault.what if coil.name in fault.what else f"{coil.name}: {fault.what}"
        coil.doubt = InstrumentError(named, fault=fault.fault, remedy=fault.remedy)


def _write_zeros(coils: Sequence[GuardedCoil], others: Sequence[str]) -> None:
    """Zero to each of them, then to each again: none waits while another hears it several times.

    Whom the link failed is tried once more, where it came back for one after them.
    """
    took = {coil.axis: _write_zero(coil, others) for coil in coils}
    if any(took.values()):
        took |= {coil.axis: _write_zero(coil, others) for coil in coils if took[coil.axis] is False}
    for _ in range(TIMES_TOLD - 1):
        write_zero({coil.axis: coil.bare for coil in coils if took[coil.axis] and not coil.line.is_connection})


def _write_zero(coil: GuardedCoil, others: Sequence[str]) -> bool | None:
    """Zero at once, whatever it may answer; who is there is asked only where the link was opened anew.

    A TCP connection on which it is silent is opened anew: the next one may be heard. Returns whether the link took it;
    None where there is nothing to write to.
    """
    assert coil.doubt is not None
    forgotten = coil.line.is_connection and coil.line.identified(coil.name) and coil.doubt.fault in REOPENED
    took = _takes_zero(coil, others)
    if took is None or (took and not forgotten):
        return took
    try:
        coil.line.reopen()
    except InstrumentError:
        return False
    return _takes_zero(coil, others)


def _takes_zero(coil: GuardedCoil, others: Sequence[str]) -> bool | None:
    """Whether the link took zero. None where another instrument is there, which was brought to zero, and where the
    file does not say where the supply is: others on the line need their link.
    """
    try:
        if not coil.line.identified(coil.name) and not _may_be_written(coil, others):
            return None
        coil.bare.write_current(0.0)
    except InstrumentError as fault:
        return None if fault.fault == "not reached" else False
    return True


def _write_again(coils: Sequence[GuardedCoil]) -> None:
    """Zero once more, where it is known who is there: such a line loses messages, and who is asked next takes long."""
    for coil in coils:
        if coil.line.identified(coil.name):
            write_zero({coil.axis: coil.bare})


def _may_be_written(coil: GuardedCoil, others: Sequence[str]) -> bool:
    """Whether nobody else answers in its place. Its silence is no reason: it may hear."""
    line = coil.line
    try:
        with line.gate.asking_until(line.clock.now() + ANSWER_S):
            line.identify(coil.name)
    except InstrumentError as fault:
        if fault.fault == "another instrument":
            _quench(coil, others)
            return False
    return True


def _quench(coil: GuardedCoil, others: Sequence[str]) -> None:
    """Another instrument answers: where it is a supply such as this bench has, it hears zero and off, and no more."""
    line = coil.line
    for driver in (line.instrument(coil.name), *line.strangers(others)):
        with suppress(InstrumentError):
            driver.identify()
            supply = cast(CoilSupply, driver)
            write_zero({coil.axis: supply})
            supply.set_current(0.0)
            supply.output(False)
            return


def _ramped(coils: Sequence[GuardedCoil], *, lossy: bool) -> Mapping[str, AtZero]:
    if not coils:
        return {}
    supplies = {coil.axis: coil.bare for coil in coils}
    rates = {coil.axis: coil.rate_A_per_s for coil in coils}
    known = {coil.axis: coil.held_A for coil in coils if coil.energised and coil.held_A is not None}
    return to_zero(supplies, rates, coils[0].line.clock, known_A=known, lossy=lossy)


def _each_read_back(doubted: Sequence[GuardedCoil], others: Sequence[str]) -> dict[str, AtZero]:
    """How each of them ended. Where the lost link comes back, all that are left are written and read once more."""
    ended, left, came_back = dict[str, AtZero](), list(doubted), False
    while left:
        _write_again(left)
        coil = left.pop(0)
        ended[coil.axis] = _read_back(coil)
        if _is_back(coil, ended[coil.axis]) and not came_back:
            came_back = True
            left = [coil for coil in doubted if coil.axis not in ended or ended[coil.axis].current_A is None]
            _write_zeros(left, others)
    return ended


def _read_back(coil: GuardedCoil) -> AtZero:
    """Who was in doubt says who it is, and then that it is at zero."""
    assert coil.doubt is not None
    try:
        coil.line.identify(coil.name)
        doubts = {coil.axis: coil.doubt}
        clock = coil.line.clock
        held = {coil.axis: coil.held_A} if coil.energised and coil.held_A is not None else {}
        rates = {coil.axis: coil.rate_A_per_s}
        end = to_zero({coil.axis: coil.bare}, rates, clock, known_A=held, doubts=doubts)[coil.axis]
    except InstrumentError as fault:
        end = AtZero(coil.axis, None, False, fault)
        if fault.fault != "another instrument":
            with suppress(InstrumentError):
                coil.bare.write_off()
    return end


def _is_back(coil: GuardedCoil, end: AtZero) -> bool:
    """Open the link again for the next try, where it or the supply failed; says whether a lost one is there again."""
    if end.current_A is not None or end.fault is None or end.fault.fault not in REOPENED:
        return False
    try:
        coil.line.reopen()
    except InstrumentError:
        return False
    return _link_lost(end)


def _link_lost(end: AtZero) -> bool:
    return end.current_A is None and end.fault is not None and end.fault.fault == "link lost"
