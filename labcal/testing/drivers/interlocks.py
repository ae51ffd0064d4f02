"""What an interlock promises: it lets current through while it is fed, and no longer."""

from __future__ import annotations

from labcal.errors import InstrumentError
from labcal.testing.drivers.rig import DriverCase, DriverRig
from labcal.testing.require import near, refused, require

OPEN_A = 0.001


def armed(case: DriverCase) -> DriverRig:
    """An interlock that is closed, with 1 A through coil x."""
    rig = case.rig()
    rig.driver.identify()
    rig.driver.arm()
    rig.lab.coils["x"].drive(rig.clock.now(), 1.0, 20.0, True)
    rig.wait(0.5)
    return rig


def fed_it_lets_the_current_through_and_no_longer(case: DriverCase) -> None:
    """Fed every third of its time it stays closed; unfed it falls open by itself."""
    rig = armed(case)
    for _ in range(6):
        text = (
            f"{rig.name}: {rig.coil_A():g} A of 1 A flow although it is fed every third of {rig.driver.watchdog_s} s."
        )
        require(near(abs(rig.coil_A()), 1.0, 0.01), text)
        rig.wait(rig.driver.watchdog_s / 3)
        rig.driver.feed()
    rig.wait(rig.driver.watchdog_s + 0.5)
    text = f"{rig.name} is still closed 0.5 s after its time: the contact itself must fall open, not the program."
    require(abs(rig.coil_A()) < OPEN_A, text)


def fallen_open_it_is_not_closed_again_under_a_set_point(case: DriverCase) -> None:
    """`feed` after it has opened is an error and sends nothing."""
    rig = armed(case)
    rig.wait(rig.driver.watchdog_s + 0.5)
    before = len(rig.sent)
    text = f"{rig.name}.feed() must raise InstrumentError (fault='interlock') once it has fallen open."
    with refused(InstrumentError, text, words="falls open", fault="interlock"):
        rig.driver.feed()
    require(len(rig.sent) == before, f"{rig.name}.feed() sent {rig.sent[before:]!r} to an open contact.")
    require(abs(rig.coil_A()) < OPEN_A, f"{rig.name}.feed() closed a contact that had fallen open.")


def made_safe_it_is_open_at_once(case: DriverCase) -> None:
    """`make_safe` opens it."""
    rig = armed(case)
    rig.driver.make_safe()
    rig.wait(0.3)
    require(abs(rig.coil_A()) < OPEN_A, f"{rig.name} is closed 0.3 s after make_safe(): it opens the contact.")


PROMISES = (
    fed_it_lets_the_current_through_and_no_longer,
    fallen_open_it_is_not_closed_again_under_a_set_point,
    made_safe_it_is_open_at_once,
)
