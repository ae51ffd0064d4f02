"""What a coil supply promises: it sets, reads back, refuses, and comes to zero whatever is lost."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any

from labcal.bench.driver_kit.roles import Unacknowledged, Watched
from labcal.errors import InstrumentError, LimitError
from labcal.testing.drivers.rig import DriverCase, DriverRig
from labcal.testing.require import near, refused, require

SETTLES_S = 0.5
AT_ONCE_S = 0.6  # for two orders whose answers are lost
WATCHED_S = 4
RAMPS_IN_S = 1.5  # from full current to zero


def identified(case: DriverCase, **stated: Any) -> DriverRig:
    """A supply that has said who it is."""
    rig = case.rig(**stated)
    rig.driver.identify()
    return rig


def too_much_A(rig: DriverRig) -> float:
    """More than it may be set to."""
    return max(99.0, 2.0 * float(rig.settings.max_current_A))


def some_A(rig: DriverRig, most_A: float) -> float:
    """A current that it can carry, `most_A` where it can."""
    return float(min(most_A, rig.settings.max_current_A / 2))


def on_at(rig: DriverRig, current_A: float) -> None:
    """The output closed and a current set that has settled."""
    rig.driver.output(True)
    rig.driver.set_current(current_A)
    rig.wait(SETTLES_S)


def it_sets_reads_back_and_measures(case: DriverCase) -> None:
    """What is set is what it holds, what it measures, and what flows in the coil."""
    rig = identified(case)
    wanted = some_A(rig, 0.5)
    rig.driver.set_current(0.0)
    on_at(rig, wanted)
    set_point, measured = rig.driver.set_point(), rig.driver.measure_current()
    after = f"after set_current({wanted:g})"
    fine, coarse = case.resolution_A, 10 * case.resolution_A
    require(near(set_point, wanted, fine), f"{rig.name}.set_point() is {set_point:g} A {after}: read what it holds.")
    flows = rig.coil_A()
    require(
        near(flows, wanted, fine), f"{flows:g} A flow in the simulated coil {after}: the emulator calls coil.drive."
    )
    require(near(measured, wanted, coarse), f"{rig.name}.measure_current() is {measured:g} A {after}.")


def bipolar_it_drives_either_way(case: DriverCase) -> None:
    """A negative current is held, measured, and flows."""
    rig = identified(case)
    if not rig.driver.bipolar:
        return
    wanted = -some_A(rig, 0.5)
    try:
        on_at(rig, wanted)
    except LimitError as error:
        text = f"{rig.name} is bipolar and refuses set_current({wanted:g}) ({error.what})"
        raise AssertionError(f"{text}: limits=lambda s: (-s.max_current_A, s.max_current_A).") from error
    held, measured, flows = rig.driver.set_point(), rig.driver.measure_current(), rig.coil_A()
    kept = all(near(seen, wanted, 10 * case.resolution_A) for seen in (held, measured, flows))
    text = f"{rig.name} holds {held:g} A and measures {measured:g} A, and {flows:g} A flow"
    require(kept, f"{text} after set_current({wanted:g}): the sign goes over the line both ways.")


def each_unit_has_a_serial_number_of_its_own(case: DriverCase) -> None:
    """Two that say the same number are taken for one at two links; an instrument that has no number says none."""
    here, there = (case.rig(coil=coil).driver.identify() for coil in ("x", "y"))
    text = f"The emulator of {case.driver.__name__} says serial number {here.serial!r} at coil x and at coil y"
    differs = here.serial != there.serial or not here.serial.strip(" 0")
    require(differs, f"{text}: make it from the role, or three on one bench are refused as the same instrument.")


def with_all_its_answers_lost_it_hears_zero_and_off_at_once(case: DriverCase) -> None:
    """The orders of zero and off wait for no answer."""
    rig = identified(case)
    wanted = some_A(rig, 0.5)
    on_at(rig, wanted)
    text = f"{rig.name} lacks write_current or write_off (Unacknowledged in labcal/bench/driver_kit/roles.py)."
    require(isinstance(rig.driver, Unacknowledged), text)
    with answers_lost(rig):
        begun_s = rig.clock.now()
        text = f"{rig.name}.write_current({too_much_A(rig):g}) must raise LimitError, answers or not."
        with refused(LimitError, text):
            rig.driver.write_current(too_much_A(rig))
        with waits_for_nothing(rig):
            rig.driver.write_current(0.4 * wanted)
            rig.driver.write_current(0.0)
        took_s = rig.clock.now() - begun_s
        rig.wait(0.3)
        text = f"{rig.coil_A():g} A still flow after {rig.name}.write_current(0): it must reach the line unasked."
        require(near(rig.coil_A(), 0.0, case.resolution_A), text)
        with waits_for_nothing(rig):
            rig.driver.write_off()
    text = f"{rig.name}.write_current waited {took_s:.2f} s for answers: put the order on the line and return."
    require(took_s < AT_ONCE_S, text)
    rig.wait(1.0)
    rig.line.flush()
    require(rig.driver.set_point() == 0.0, f"{rig.name} holds {rig.driver.set_point():g} A after write_current(0).")
    require(getattr(rig.driver, "enabled", 0) == 0, f"The output of {rig.name} is on after write_off().")


@contextmanager
def waits_for_nothing(rig: DriverRig) -> Iterator[None]:
    """An order inside that fails for want of an answer has waited for one."""
    try:
        yield
    except InstrumentError as error:
        text = f"{rig.name}.write_current or write_off waits for an answer ({error.what})"
        raise AssertionError(f"{text}: put the order on the line and return.") from error


@contextmanager
def answers_lost(rig: DriverRig) -> Iterator[None]:
    """All that the emulator says is lost on the line."""
    end: Any = rig.line._emulator
    emit = end.emit
    end.emit = lambda until_s: (emit(until_s), [])[1]
    yield
    end.emit = emit


def after_orders_that_waited_for_nothing_it_confirms_zero(case: DriverCase) -> None:
    """A late answer to an order of zero or off is no answer to the next command or question."""
    rig = identified(case)
    on_at(rig, some_A(rig, 0.5))
    text = f"{rig.name} lost its place after write_current(0) and write_off()"
    todo = (
        "An answer to write() comes after it has returned: the next query() or command() drops it first, by "
        "wait_for_quiet of labcal.bench.links.line (see drivers/framing/genesys.py)."
    )
    try:
        for order in (partial(rig.driver.write_current, 0.0), rig.driver.write_off):
            order()
            rig.driver.set_current(0.0)
        rig.driver.output(False)
        held_A = rig.driver.set_point()
        rig.wait(SETTLES_S)
        left_A = rig.driver.measure_current()
    except InstrumentError as error:
        raise AssertionError(f"{text}: {error.what} {todo}") from error
    require(held_A == 0.0, f"{text}: set_point() is {held_A:g} A. {todo}")
    require(near(left_A, 0.0, 10 * case.resolution_A), f"{text}: measure_current() is {left_A:g} A. {todo}")


def it_refuses_what_is_too_much_and_sends_nothing(case: DriverCase) -> None:
    """A set-point beyond its limits is an error with the number in it, and no byte."""
    rig = identified(case)
    before, much = len(rig.sent), too_much_A(rig)
    text = f"{rig.name}.set_current({much:g}) must raise LimitError that says '{much:g} A' and 'nothing was sent'."
    with refused(LimitError, text, words=rf"{much:g} A.*nothing was sent"):
        rig.driver.set_current(much)
    if not rig.driver.bipolar:
        with refused(LimitError, f"{rig.name}.set_current(-0.1) must raise LimitError: it is not bipolar."):
            rig.driver.set_current(-0.1)
    require(len(rig.sent) == before, f"{rig.name} sent {rig.sent[before:]!r} for what it refused: refuse it before.")


def made_safe_it_has_no_current_and_its_panel_back(case: DriverCase) -> None:
    """`make_safe` sets zero, opens the output, and only then gives the panel back."""
    rig = identified(case)
    on_at(rig, some_A(rig, 1.0))
    rig.driver.make_safe()
    if case.to_panel:
        text = f"{rig.name}.make_safe() must end with {case.to_panel!r}, and say it nowhere before"
        ends = rig.sent[-1].startswith(case.to_panel)
        require(ends and not any(s.startswith(case.to_panel) for s in rig.sent[:-1]), f"{text}; it sent {rig.sent!r}.")
    rig.wait(SETTLES_S)
    measured, flows, set_point = rig.driver.measure_current(), rig.coil_A(), rig.driver.set_point()
    text = f"{rig.name}.make_safe() leaves {measured:g} A measured, {flows:g} A in the coil, {set_point:g} A set"
    safe = near(measured, 0.0, rig.driver.zero_current_A) and near(flows, 0.0, rig.driver.zero_current_A)
    require(safe and set_point == 0.0, f"{text}: it sets zero and opens the output.")


def it_ramps_its_full_current_in_time(case: DriverCase) -> None:
    """A coil is at zero soon, and "zero" is small."""
    rig = identified(case)
    ramp, most, zero = rig.driver.ramp_A_per_s, rig.settings.max_current_A, rig.driver.zero_current_A
    text = f"{rig.name} ramps {ramp:g} A/s, so {most:g} A take {most / ramp:.1f} s: at most {RAMPS_IN_S} s"
    require(most / ramp <= RAMPS_IN_S, f"{text}; raise ramp_A_per_s or lower max_current_A.")
    require(0 < zero < 0.1, f"zero_current_A of {rig.name} is {zero:g}: above 0 and below 0.1 A.")


def a_watchdog_takes_it_to_zero_when_it_is_not_heard(case: DriverCase) -> None:
    """Where its settings name `watchdog_s` it has `feed`, holds while fed and falls to zero when not; else neither."""
    known = {f.name for f in dataclasses.fields(case.types["settings"])}
    watched = isinstance(case.rig().driver, Watched)
    text = f"{case.driver.__name__} has `feed` and `watchdog_s` if and only if its Settings name `watchdog_s`."
    require(watched == ("watchdog_s" in known), text)
    if not watched:
        return
    require(case.rig().driver.watchdog_s == 0, f"watchdog_s of {case.driver.__name__} is 0 unless it is stated.")
    rig = identified(case, watchdog_s=WATCHED_S)
    wanted = some_A(rig, 1.0)
    rig.driver.set_current(0.0)
    on_at(rig, wanted)
    for _ in range(6):
        rig.wait(WATCHED_S / 3)
        text = f"{rig.name}: {rig.coil_A():g} A flow although its watchdog is fed every third of its time."
        require(near(abs(rig.coil_A()), wanted, 10 * case.resolution_A), text)
        rig.driver.feed()
    rig.wait(WATCHED_S + SETTLES_S)
    text = f"{rig.name}: {rig.coil_A():g} A flow {SETTLES_S} s after its watchdog's time: switch it on in identify()."
    require(abs(rig.coil_A()) < case.resolution_A, text)


def given_back_to_its_panel_it_is_left_alone(case: DriverCase) -> None:
    """What feeds the watchdog of a supply that was made safe sends nothing."""
    if not isinstance(case.rig().driver, Watched):
        return
    rig = case.rig(watchdog_s=WATCHED_S)
    rig.driver.output(True)
    rig.driver.make_safe()
    before = len(rig.sent)
    rig.driver.feed()
    require(len(rig.sent) == before, f"{rig.name}.feed() sent {rig.sent[before:]!r} after make_safe(): send nothing.")


PROMISES = (
    it_sets_reads_back_and_measures,
    bipolar_it_drives_either_way,
    each_unit_has_a_serial_number_of_its_own,
    with_all_its_answers_lost_it_hears_zero_and_off_at_once,
    after_orders_that_waited_for_nothing_it_confirms_zero,
    it_refuses_what_is_too_much_and_sends_nothing,
    made_safe_it_has_no_current_and_its_panel_back,
    it_ramps_its_full_current_in_time,
    a_watchdog_takes_it_to_zero_when_it_is_not_heard,
    given_back_to_its_panel_it_is_left_alone,
)
