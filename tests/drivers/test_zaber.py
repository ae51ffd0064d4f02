"""Zaber ASCII: replies matched by id and checksum; idle is not arrived."""

from __future__ import annotations

import pytest

from drivers.framing.zaber import checksum
from drivers.zaber import ZaberStage
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.errors import InstrumentError

TURN = (b"/1 1 01 get limit.cycle.dist\r\n", b"@01 1 01 OK IDLE -- 1536000\r\n")


def said(number: int, text: str) -> bytes:
    return f"@01 1 {number:02d} {text}\r\n".encode()


@pytest.mark.parametrize(("body", "sum_"), [(b"1 0 move abs 10000", "41"), (b"01 0 OK BUSY -- 0", "68")])
def test_the_checksum_is_the_protocols(body: bytes, sum_: str) -> None:
    assert checksum(body) == sum_


def test_a_move_is_absolute_in_microsteps_and_sent_once() -> None:
    speed = round(6 * 1536000 / 360 * 1.6384)
    wire = [TURN, (b"/1 1 02 set maxspeed %d\r\n" % speed, said(2, "OK IDLE -- 0")),
            (b"/1 1 03 move abs 384000\r\n", said(3, "OK BUSY -- 0"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        stage.move_to(90.0, 6.0)


def test_a_move_without_a_reply_is_not_repeated() -> None:
    wire = [
        TURN,
        (b"/1 1 02 set maxspeed 41943\r\n", said(2, "OK IDLE -- 0")),
        (b"/1 1 03 move abs 384000\r\n", SILENT),
    ]
    with scripted(ZaberStage, wire) as stage, pytest.raises(InstrumentError) as caught:
        stage.move_to(90.0, 6.0)
    assert caught.value.fault == "silent"


def test_idle_off_the_target_is_not_arrived() -> None:
    wire = [TURN, (b"/1 1 02 set maxspeed 41943\r\n", said(2, "OK IDLE -- 0")),
            (b"/1 1 03 move abs 384000\r\n", said(3, "OK BUSY -- 0")),
            (b"/1 1 04 get pos\r\n", said(4, "OK BUSY -- 200000")),
            (b"/1 1 05 get pos\r\n", said(5, "OK IDLE -- 380000"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        stage.move_to(90.0, 6.0)
        assert stage.moving()
        with pytest.raises(InstrumentError, match="from its target") as caught:
            stage.moving()
    assert caught.value.fault == "not arrived"


@pytest.mark.parametrize(
    ("warning", "fault"), [("FS", "stage fault"), ("NC", "touched"), ("NI", "touched"), ("WR", "stage fault")]
)
def test_a_warning_ends_the_step(warning: str, fault: str) -> None:
    wire = [
        (b"/1 1 01 get pos\r\n", said(1, f"OK IDLE {warning} 0")),
        (b"/1 1 02 get limit.cycle.dist\r\n", said(2, "OK IDLE -- 1536000")),
    ]
    with scripted(ZaberStage, wire[:1]) as stage, pytest.raises(InstrumentError) as caught:
        stage.moving()
    assert caught.value.fault == fault


@pytest.mark.parametrize(
    "frame",
    [
        b"@01 1 01 OK IDLE -- 0:00\r\n",
        b"@01 1 01 OK ID\xff\xfe -- 0\r\n",
        b"\x00\x00\r\n",
        b"@01 1 01 RJ IDLE -- BADDATA\r\n",
    ],
)
def test_a_bad_checksum_noise_and_a_rejection_are_faults(frame: bytes) -> None:
    with scripted(ZaberStage, [(b"/1 1 01 stop\r\n", frame)]) as stage, pytest.raises(InstrumentError):
        stage.make_safe()


def test_a_late_reply_of_an_older_request_is_passed_over() -> None:
    wire = [(b"/1 1 01 get pos\r\n", said(95, "OK IDLE -- 5") + said(1, "OK IDLE -- 768000")),
            (b"/1 1 02 get limit.cycle.dist\r\n", said(2, "OK IDLE -- 1536000"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        assert stage.angle_deg() == 180.0


@pytest.mark.parametrize("aside", [b"!01 1 IDLE --\r\n", b"#01 1 01 hello\r\n", b"@02 1 01 OK IDLE -- 5\r\n"])
def test_an_alert_an_information_and_another_device_answer_nothing(aside: bytes) -> None:
    wire = [(b"/1 1 01 get pos\r\n", aside + said(1, "OK IDLE -- 768000")),
            (b"/1 1 02 get limit.cycle.dist\r\n", said(2, "OK IDLE -- 1536000") + aside)]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        assert stage.angle_deg() == 180.0


def test_it_homes_no_faster_than_the_dut_may_turn() -> None:
    wire = [(b"/1 1 01\r\n", said(1, "OK IDLE WR 0")),
            (b"/1 1 02 get limit.cycle.dist\r\n", said(2, "OK IDLE WR 1536000")),
            (b"/1 1 03 set maxspeed 27962\r\n", said(3, "OK IDLE WR 0")),
            (b"/1 1 04 home\r\n", said(4, "OK BUSY WR 0"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        stage.home(4.0)


def test_a_line_end_too_much_costs_no_reply() -> None:
    wire = [(b"/1 1 01\r\n", said(1, "OK IDLE -- 0") + b"\n"), (b"/1 1 02 stop\r\n", said(2, "OK IDLE -- 0"))]
    with scripted(ZaberStage, wire) as stage:
        stage.home()
        stage.make_safe()
