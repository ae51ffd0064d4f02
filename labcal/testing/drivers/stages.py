"""What a motorised platform promises: it homes no faster than allowed, arrives where it is sent, and says if not."""

from __future__ import annotations

from contextlib import suppress

from labcal.errors import InstrumentError, LimitError
from labcal.testing.drivers.rig import DriverCase, DriverRig
from labcal.testing.require import near, refused, require

HOMING_LIMITS = (25.0, 4.0)  # deg/s that the DUT may turn
TRUE_WITHIN_DEG = 0.02
LONGEST_S = 600.0  # for any move here


def until_still(rig: DriverRig) -> None:
    """Wait until it says that it does not move."""
    begun_s = rig.clock.now()
    while rig.driver.moving():
        rig.wait(0.1)
        require(rig.clock.now() - begun_s < LONGEST_S, f"{rig.name}.moving() is True for {LONGEST_S:.0f} s.")


def homed(case: DriverCase) -> DriverRig:
    """A stage that knows where it is."""
    rig = case.rig()
    rig.driver.identify()
    rig.driver.home()
    until_still(rig)
    return rig


def it_homes_no_faster_than_the_dut_may_turn_or_refuses(case: DriverCase) -> None:
    """`home(limit)` keeps the limit, or raises LimitError and does not move."""
    for limit in HOMING_LIMITS:
        rig = case.rig()
        rig.driver.identify()
        platform = rig.lab.platform
        platform.move(rig.clock.now(), 40.0, 40.0)
        while platform.moving(rig.clock.now()):
            rig.wait(0.1)
        with suppress(LimitError):
            rig.driver.home(limit)
        fastest = _fastest(rig)
        text = f"{rig.name}.home({limit:g}) turned the platform at {fastest:.1f} deg/s: set the homing speed first"
        require(fastest <= limit + 0.01, f"{text}, or raise LimitError.")
        may_rest = limit == min(HOMING_LIMITS) or case.knows_its_place
        text = f"{rig.name}.home({limit:g}) moved nothing: state knows_its_place=True if its encoder is absolute."
        require(fastest > 0 or may_rest, text)


def _fastest(rig: DriverRig) -> float:
    fastest = 0.0
    for _ in range(20):
        before = rig.angle_deg()
        rig.wait(0.2)
        fastest = max(fastest, abs(rig.angle_deg() - before) / 0.2)
    return fastest


def it_arrives_where_it_was_sent_and_says_so(case: DriverCase) -> None:
    """`moving` and `state` say that it moves until it has arrived, then `angle_deg` is the target."""
    rig = homed(case)
    for target in (30.5, -12.25):
        rig.driver.move_to(target, 10.0)
        rig.wait(0.5)
        moving = rig.driver.moving() and rig.driver.state()[1]
        require(moving, f"{rig.name} says that it rests 0.5 s after move_to({target:g}, 10): moving() and state().")
        until_still(rig)
        said, true = rig.driver.angle_deg(), rig.angle_deg()
        text = f"{rig.name} says {said:g} deg and is at {true:g} deg after move_to({target:g}): check units and sign."
        require(near(said, target, rig.settings.tolerance_deg) and near(true, target, TRUE_WITHIN_DEG), text)


def held_it_has_not_arrived(case: DriverCase) -> None:
    """A stage that stops short of its target is a fault, never an arrival."""
    rig = homed(case)
    rig.driver.move_to(60.0, 10.0)
    rig.wait(1.0)
    rig.lab.platform.stop(rig.clock.now())
    rig.wait(3.0)
    text = f"{rig.name}.moving() must raise InstrumentError (fault='not arrived') when it stands short of its target."
    with refused(InstrumentError, text, words="from its target", fault="not arrived"):
        rig.driver.moving()


def made_safe_it_comes_to_rest_on_its_way(case: DriverCase) -> None:
    """`make_safe` stops it where it is."""
    rig = homed(case)
    rig.driver.move_to(90.0, 10.0)
    rig.wait(1.0)
    rig.driver.make_safe()
    rig.wait(4.0)
    require(not rig.driver.moving(), f"{rig.name} moves 4 s after make_safe().")
    angle = rig.driver.angle_deg()
    require(0.5 < angle < 80.0, f"{rig.name} is at {angle:g} deg of 90 after make_safe() on its way: stop it there.")


PROMISES = (
    it_homes_no_faster_than_the_dut_may_turn_or_refuses,
    it_arrives_where_it_was_sent_and_says_so,
    held_it_has_not_arrived,
    made_safe_it_comes_to_rest_on_its_way,
)
