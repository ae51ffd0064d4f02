"""Zaber ASCII: replies matched by id and checksum; idle is not arrived."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from drivers.emulators.zaber import ZaberEmulator
from drivers.framing.zaber import checksum
from drivers.zaber import Settings, ZaberStage
from labcal.bench.clock import VirtualClock
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.bench.links import EmulatedLink
from labcal.errors import InstrumentError
from labcal.twin import open_twin

SPEED_6 = round(6 * 1536000 / 360 * 1.6384)


def said(number: int, text: str) -> bytes:
    return f"@01 1 {number:02d} {text}\r\n".encode()


TURN = (b"/1 1 01 get limit.cycle.dist\r\n", said(1, "OK IDLE -- 1536000"))
VERSION = (b"/1 1 02 get version\r\n", said(2, "OK IDLE -- 7.38"))
OLD = (b"/1 1 02 get version\r\n", said(2, "OK IDLE -- 6.28"))
MOVE = b"/1 1 03 move abs 384000 %d\r\n" % SPEED_6


@pytest.mark.parametrize(("body", "sum_"), [(b"1 0 move abs 10000", "41"), (b"01 0 OK BUSY -- 0", "68")])
def test_the_checksum_is_the_protocols(body: bytes, sum_: str) -> None:
    assert checksum(body) == sum_


def test_a_move_is_absolute_in_microsteps_at_a_speed_of_its_own_and_sent_once() -> None:
    wire = [TURN, VERSION, (MOVE, said(3, "OK BUSY -- 0")),
            (b"/1 1 04 move abs 0 %d\r\n" % SPEED_6, said(4, "OK BUSY -- 0"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        stage.move_to(90.0, 6.0)
        stage.move_to(0.0, 6.0)


def test_older_firmware_is_told_its_speed_only_where_it_has_another() -> None:
    wire = [TURN, OLD, (b"/1 1 03 get maxspeed\r\n", said(3, "OK IDLE -- 99999")),
            (b"/1 1 04 set maxspeed %d\r\n" % SPEED_6, said(4, "OK IDLE -- 0")),
            (b"/1 1 05 move abs 384000\r\n", said(5, "OK BUSY -- 0")),
            (b"/1 1 06 get maxspeed\r\n", said(6, f"OK IDLE -- {SPEED_6}")),
            (b"/1 1 07 move abs 0\r\n", said(7, "OK BUSY -- 0"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        stage.move_to(90.0, 6.0)
        stage.move_to(0.0, 6.0)


def test_a_move_without_a_reply_is_not_repeated() -> None:
    with (
        scripted(ZaberStage, [TURN, VERSION, (MOVE, SILENT)]) as stage,
        pytest.raises(InstrumentError) as caught,
    ):
        stage.move_to(90.0, 6.0)
    assert caught.value.fault == "silent"


def test_idle_off_the_target_is_not_arrived() -> None:
    wire = [TURN, VERSION, (MOVE, said(3, "OK BUSY -- 0")),
            (b"/1 1 04 get pos\r\n", said(4, "OK BUSY -- 200000")),
            (b"/1 1 05 get pos\r\n", said(5, "OK IDLE -- 380000"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        stage.move_to(90.0, 6.0)
        assert stage.moving()
        with pytest.raises(InstrumentError, match="from its target") as caught:
            stage.moving()
    assert caught.value.fault == "not arrived"


def test_of_a_move_that_was_cut_short_its_place_tells_and_its_own_stop_is_no_fault() -> None:
    wire = [TURN, VERSION, (MOVE, said(3, "OK BUSY -- 0")), (b"/1 1 04 get pos\r\n", said(4, "OK IDLE NI 200000")),
            (b"/1 1 05 stop\r\n", said(5, "OK BUSY NI 0")),
            (b"/1 1 06 get pos\r\n", said(6, "OK IDLE NI 200500"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        stage.move_to(90.0, 6.0)
        with pytest.raises(InstrumentError, match="from its target"):
            stage.moving()
        stage.make_safe()
        assert not stage.moving()


@pytest.mark.parametrize(
    ("warning", "fault"), [("FS", "stage fault"), ("FT", "stage fault"), ("NC", "touched"), ("WR", "stage fault")]
)
def test_a_warning_ends_the_step(warning: str, fault: str) -> None:
    wire = [(b"/1 1 01 get pos\r\n", said(1, f"OK IDLE {warning} 0"))]
    with scripted(ZaberStage, wire) as stage, pytest.raises(InstrumentError) as caught:
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


@pytest.mark.parametrize("flags", ["01 WR", "01 WH", "01 NC", "01 NI", "02 NC NI"])
def test_it_homes_where_its_place_is_unknown_or_its_knob_was_turned(flags: str) -> None:
    wire = [(b"/1 1 01 warnings\r\n", said(1, f"OK IDLE {flags[3:5]} {flags}")),
            (b"/1 1 02 home\r\n", said(2, "OK BUSY -- 0"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        stage.home()


@pytest.mark.parametrize("flags", ["01 FS", "02 FS WR", "01 FT", "01 FB", "02 FE NC"])
def test_what_it_reports_is_acknowledged_and_it_homes(flags: str) -> None:
    wire = [(b"/1 1 01 warnings\r\n", said(1, f"OK IDLE {flags[3:5]} {flags}")),
            (b"/1 1 02 warnings clear\r\n", said(2, f"OK IDLE WR {flags}")),
            (b"/1 1 03 home\r\n", said(3, "OK BUSY WR 0"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        stage.home()


@pytest.mark.parametrize("flags", ["00", "01 WM", "01 ND"])
def test_it_does_not_home_again_where_it_knows_its_place(flags: str) -> None:
    with scripted(ZaberStage, [(b"/1 1 01 warnings\r\n", said(1, f"OK IDLE -- {flags}"))]) as stage:
        stage.home()


def test_a_list_of_flags_that_is_none_is_a_fault() -> None:
    with (
        scripted(ZaberStage, [(b"/1 1 01 warnings\r\n", said(1, "OK IDLE -- 5"))]) as stage,
        pytest.raises(InstrumentError, match="warnings"),
    ):
        stage.home()


def test_while_it_homes_its_place_is_not_known_yet() -> None:
    wire = [(b"/1 1 01 get pos\r\n", said(1, "OK BUSY WR 9")), (b"/1 1 02 get pos\r\n", said(2, "OK IDLE WR 9"))]
    with scripted(ZaberStage, wire) as stage:
        assert stage.moving()
        with pytest.raises(InstrumentError, match="WR"):
            stage.moving()


@pytest.mark.parametrize(("held", "told"), [(83886, True), (27962, False), (20000, False)])
def test_it_homes_no_faster_than_the_dut_may_turn(held: int, told: bool) -> None:
    wire = [(b"/1 1 01 warnings\r\n", said(1, "OK IDLE WR 01 WR")),
            (b"/1 1 02 get limit.cycle.dist\r\n", said(2, "OK IDLE WR 1536000")),
            (b"/1 1 03 get maxspeed\r\n", said(3, f"OK IDLE WR {held}")),
            *[(b"/1 1 04 set maxspeed 27962\r\n", said(4, "OK IDLE WR 0"))] * told,
            (b"/1 1 %02d home\r\n" % (4 + told), said(4 + told, "OK BUSY WR 0"))]  # fmt: skip
    with scripted(ZaberStage, wire) as stage:
        stage.home(4.0)


def test_a_line_end_too_much_costs_no_reply() -> None:
    wire = [(b"/1 1 01 warnings\r\n", said(1, "OK IDLE -- 00") + b"\n"), (b"/1 1 02 stop\r\n", said(2, "OK IDLE -- 0"))]
    with scripted(ZaberStage, wire) as stage:
        stage.home()
        stage.make_safe()


def emulated(firmware: str = "7.38") -> tuple[ZaberStage, ZaberEmulator, VirtualClock]:
    clock, emulator = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), ZaberEmulator(open_twin({}, 1), {}, Settings())
    emulator.held["version"] = firmware
    return ZaberStage("stage", EmulatedLink("emulated://x", emulator, clock), clock, Settings()), emulator, clock


def rested(stage: ZaberStage, clock: VirtualClock) -> float:
    while stage.moving():
        clock.wait_until(clock.now() + 0.1)
    return stage.angle_deg()


@pytest.mark.parametrize("what", ["turn_knob", "stall"])
def test_a_stage_that_was_turned_or_stalled_homes_and_goes_on(what: str) -> None:
    stage, emulator, clock = emulated()
    stage.home()
    rested(stage, clock)
    stage.move_to(30.0, 10.0)
    clock.wait_until(clock.now() + 1.0)
    getattr(emulator, what)(clock.now(), *[50.0] * (what == "turn_knob"))
    with pytest.raises(InstrumentError, match="warning"):
        rested(stage, clock)
    stage.home()
    assert rested(stage, clock) == pytest.approx(0.0, abs=0.01)
    stage.move_to(30.0, 10.0)
    assert rested(stage, clock) == pytest.approx(30.0, abs=0.01)


@pytest.mark.parametrize(("firmware", "written"), [("7.38", 0), ("6.28", 1)])
def test_ten_moves_at_one_speed_write_its_memory_once_at_most(firmware: str, written: int) -> None:
    stage, emulator, clock = emulated(firmware)
    stage.home()
    for k in range(10):
        stage.move_to(3.0 * k, 10.0)
        rested(stage, clock)
    assert emulator.written == written
