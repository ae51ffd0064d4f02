"""Velmex VXM: its letters and programs, the end that it tells unasked, zero at its switch; ready is not arrived."""

from __future__ import annotations

from typing import Any

import pytest

from drivers.velmex_vxm import VelmexStage
from labcal.bench.driver_kit.testing import SILENT, Exchange, scripted
from labcal.errors import InstrumentError, LimitError
from labcal.testing.drivers import installed
from labcal.testing.drivers.rig import DriverRig

READY, BUSY = (b"V\r", b"R"), (b"V\r", b"B")
MOVE: Exchange = (b"C,S1M240,IA1M1220,R\r", SILENT)  # 30.5 deg at 6 deg/s of 14 400 steps a turn
AT_30_5: Exchange = (b"X\r", b"+0001220\r")


def stage(wire: list[Exchange], **stated: Any) -> Any:
    return scripted(VelmexStage, wire, **stated)


def later(motor: Any) -> None:
    motor._clock.wait_until(motor._clock.now() + 0.2)


def test_it_is_taken_online_and_asked_for_state_and_position() -> None:
    with stage([(b"F\r", SILENT), READY, (b"X\r", b"-0000042\r")]) as motor:
        assert motor.identify().model == "VXM"


def test_what_answers_otherwise_is_none() -> None:
    with stage([(b"F\r", SILENT), (b"V\r", b"?")]) as motor, pytest.raises(InstrumentError) as caught:
        motor.identify()
    assert caught.value.fault == "wrong reply"


def test_a_move_is_a_program_told_once_and_its_end_no_state() -> None:
    with stage([MOVE, BUSY, (b"V\r", b"^R"), AT_30_5]) as motor:
        motor.move_to(30.5, 6.0)
        later(motor)
        assert motor.moving()
        assert not motor.moving()


@pytest.mark.parametrize("position", [b"\r+0001220\r", b"^\r+0001220\r", b"\n+0001220\r", b"X+0001220\r"])
def test_line_ends_of_what_it_said_before_and_the_letter_that_asks_are_passed_over(position: bytes) -> None:
    with stage([MOVE, (b"V\r", b"^\rR"), (b"X\r", position)]) as motor:
        motor.move_to(30.5, 6.0)
        later(motor)
        assert not motor.moving()


def test_one_that_says_nothing_but_that_it_has_come_to_rest_answers_nothing() -> None:
    with stage([(b"F\r", SILENT), (b"V\r", b"^" * 100)]) as motor, pytest.raises(InstrumentError) as caught:
        motor.identify()
    assert caught.value.fault == "wrong reply"


def test_stopped_at_a_limit_it_has_not_arrived() -> None:
    with stage([MOVE, (b"V\r", b"O^R"), (b"X\r", b"+0001216\r")]) as motor:
        motor.move_to(30.5, 6.0)
        later(motor)
        with pytest.raises(InstrumentError, match=r"-0\.100°") as caught:
            motor.moving()
    assert caught.value.fault == "not arrived"


def test_the_absolute_zero_is_a_place_and_not_a_new_zero() -> None:
    with stage([(b"C,S1M240,IA1M0,R\r", SILENT)]) as motor:
        motor.move_to(-0.001, 6.0)


def test_turned_from_its_panel_it_is_touched() -> None:
    with stage([(b"V\r", b"J")]) as motor, pytest.raises(InstrumentError, match="from its own panel") as caught:
        motor.moving()
    assert caught.value.fault == "touched"


def test_it_homes_to_its_switch_no_faster_than_allowed_and_sets_zero_there_once() -> None:
    wire = [(b"C,S1M80,I1M-0,R\r", SILENT), BUSY, READY, (b"C,IA1M-0,R\r", SILENT), READY, (b"X\r", b"+0000000\r")]
    with stage(wire, home="negative") as motor:
        motor.home(2.0)
        later(motor)
        assert motor.moving()
        assert motor.moving()
        later(motor)
        assert not motor.moving()
        motor.home(2.0)


def test_without_a_switch_it_does_not_move_to_home() -> None:
    with stage([]) as motor:
        motor.home()


@pytest.mark.parametrize("rate", [0.01, 200.0])
def test_a_speed_it_does_not_have_sends_nothing(rate: float) -> None:
    with stage([]) as motor, pytest.raises(LimitError, match="nothing was sent"):
        motor.move_to(1.0, rate)


def test_a_relative_index_is_never_sent_but_to_a_switch() -> None:
    rig: DriverRig = installed("velmex-vxm", forbidden=[]).rig()
    for said in (b"C,S1M80,I1M400,R\r", b"I1M5\r", b"N\r", b"C,S1M80,I1M-0,I1M5,R\r", b"setM1M4\r"):
        with pytest.raises(InstrumentError, match="never sent"):
            rig.driver._link.send(said)


def test_a_stop_on_the_way_home_sets_no_zero() -> None:
    rig: DriverRig = installed("velmex-vxm", forbidden=[], settings={"home": "negative"}).rig()
    rig.driver.identify()
    rig.lab.platform.move(rig.clock.now(), 40.0, 40.0)
    rig.wait(10.0)
    rig.driver.home()
    rig.wait(2.0)
    rig.driver.make_safe()
    rig.wait(3.0)
    assert not rig.driver.moving()
    assert rig.driver.angle_deg() == pytest.approx(rig.angle_deg() + 6.0, abs=0.05)  # as it counted at power-up
