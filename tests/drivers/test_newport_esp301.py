"""Newport ESP301: degrees confirmed, one absolute move, errors in words, done is not arrived."""

from __future__ import annotations

import pytest

from drivers.newport_esp301 import Esp301Stage
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.errors import InstrumentError

FINE = (b"TB?\r", b"0, 451322, NO ERROR DETECTED\r\n")
AT_6 = [(b"1VA6.0000\r", SILENT), FINE, (b"1VA?\r", b"6.0000\r\n")]
MOVE = [*AT_6, (b"1PA30.5000\r", SILENT), FINE]


def known(version: bytes = b"ESP301 Version 3.0.1 6/1/99", unit: bytes = b"7") -> list[tuple[bytes, bytes]]:
    return [(b"VE?\r", version + b"\r\n"), (b"1ID?\r", b"URS100BPP, SN1263\r\n"), (b"1SN?\r", unit + b"\r\n")]


def test_controller_and_stage_say_who_they_are() -> None:
    with scripted(Esp301Stage, known()) as stage:
        who = stage.identify()
    assert (who.model, who.serial) == ("URS100BPP", "1263")


@pytest.mark.parametrize(
    ("version", "unit", "fault"),
    [(b"SMC_CC_2.0.1", b"7", "another instrument"), (b"ESP301 Version 3", b"2", "wrong set-up")],
)
def test_another_controller_or_an_axis_in_millimetres_is_refused(version: bytes, unit: bytes, fault: str) -> None:
    with scripted(Esp301Stage, known(version, unit)) as stage, pytest.raises(InstrumentError) as caught:
        stage.identify()
    assert caught.value.fault == fault


def test_a_move_is_absolute_and_sent_once() -> None:
    with scripted(Esp301Stage, MOVE) as stage:
        stage.move_to(30.5, 6.0)


def test_a_move_whose_answer_is_lost_is_not_repeated() -> None:
    with scripted(Esp301Stage, [*MOVE[:-1], (b"TB?\r", SILENT)]) as stage, pytest.raises(InstrumentError) as caught:
        stage.move_to(30.5, 6.0)
    assert caught.value.fault == "silent"


def test_a_rate_that_is_not_taken_ends_the_move_before_it_begins() -> None:
    wire = [*AT_6[:2], (b"1VA?\r", b"10.0000\r\n")]
    with scripted(Esp301Stage, wire) as stage, pytest.raises(InstrumentError) as caught:
        stage.move_to(30.5, 6.0)
    assert caught.value.fault == "read-back"


def test_done_off_the_target_is_not_arrived() -> None:
    wire = [*MOVE, (b"1MD?\r", b"0\r\n"), FINE, (b"1MD?\r", b"1\r\n"), FINE,
            (b"1TP\r", b"30.4000\r\n")]  # fmt: skip
    with scripted(Esp301Stage, wire) as stage:
        stage.move_to(30.5, 6.0)
        assert stage.moving()
        with pytest.raises(InstrumentError, match=r"-0\.100°") as caught:
            stage.moving()
    assert caught.value.fault == "not arrived"


def test_done_on_the_target_is_arrived() -> None:
    wire = [*MOVE, (b"1MD?\r", b"1\r\n"), FINE, (b"1TP\r", b"30.4990\r\n")]
    with scripted(Esp301Stage, wire) as stage:
        stage.move_to(30.5, 6.0)
        assert not stage.moving()


@pytest.mark.parametrize(
    ("code", "says"),
    [(b"113, 1, MOTOR", "motor is off"), (b"103, 1, X", "following error"), (b"106, 1, X", r"soft limit \+"),
     (b"4, 1, EMERGENCY STOP ACTIVATED", "EMERGENCY STOP"), (b"\xff\xfe", "error")],
)  # fmt: skip
def test_an_error_is_said_in_words(code: bytes, says: str) -> None:
    wire = [*MOVE[:-1], (b"TB?\r", code + b"\r\n")]
    with scripted(Esp301Stage, wire) as stage, pytest.raises(InstrumentError, match=says):
        stage.move_to(30.5, 6.0)


def test_it_homes_once_a_connection_with_its_motor_on() -> None:
    wire = [(b"1MO\r", SILENT), FINE, (b"1OR1\r", SILENT), FINE, *known(), (b"1MO\r", SILENT), FINE,
            (b"1OR1\r", SILENT), FINE]  # fmt: skip
    with scripted(Esp301Stage, wire) as stage:
        stage.home()
        stage.home()
        stage.identify()  # after a lost link the controller may have been without power
        stage.home()


def test_it_homes_no_faster_than_the_dut_may_turn() -> None:
    wire = [(b"1OL?\r", b"1.0\r\n"), (b"1OH?\r", b"10\r\n"), (b"1OH4.0000\r", SILENT), FINE, (b"1OH?\r", b"4\r\n"),
            (b"1MO\r", SILENT), FINE, (b"1OR1\r", SILENT), FINE]  # fmt: skip
    with scripted(Esp301Stage, wire) as stage:
        stage.home(4.0)
    wire = [(b"1OL?\r", b"5\r\n"), (b"1OL4.0000\r", SILENT), FINE, (b"1OL?\r", b"5\r\n")]
    with scripted(Esp301Stage, wire) as stage, pytest.raises(InstrumentError, match="OL reads back 5 deg/s"):
        stage.home(4.0)
