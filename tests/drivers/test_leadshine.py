"""Leadshine: an absolute path, read back and started once; stopped is not arrived."""

from __future__ import annotations

import pytest
from frames import read, rtu, wrote

from drivers.leadshine import LeadshineStage
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.errors import InstrumentError, LimitError

STATUS, START = bytes.fromhex("010310030001 70CA"), bytes.fromhex("01066002001037C6")
RESTING, RUNNING, STOPPED = (read("0103 1003 0001", [word]) for word in (0x0072, 0x0046, 0x0052))
PULSES = 76_250  # 30.5° · 10 000 · 90 / 360
PATH = [1, *divmod(PULSES, 0x10000), 90, 2000, 2000]  # 6 deg/s is 1 rpm, through the gear 90
HEX = "".join(f"{word:04X}" for word in PATH)
WRITTEN = (rtu(f"0110 6200 0006 0C {HEX}"), rtu("0110 6200 0006"))
MOVE = [WRITTEN, read("0103 6200 0006", PATH), (START, START)]


def positions(commanded: int, motor: int) -> tuple[bytes, bytes]:
    both = (*divmod(commanded & 0xFFFFFFFF, 0x10000), *divmod(motor & 0xFFFFFFFF, 0x10000))
    return read("0103 602A 0004", list(both))


def test_the_frames_of_the_tests_are_those_of_the_facts() -> None:
    assert (RESTING[0], wrote("0106 6002 0010")[0]) == (STATUS, START)


def test_a_move_is_an_absolute_path_read_back_and_started_once() -> None:
    with scripted(LeadshineStage, MOVE) as stage:
        stage.move_to(30.5, 6.0)


def test_a_path_that_reads_back_otherwise_is_not_started() -> None:
    relative = [0x41, *PATH[1:]]
    with (
        scripted(LeadshineStage, [WRITTEN, read("0103 6200 0006", relative)]) as stage,
        pytest.raises(InstrumentError) as caught,
    ):
        stage.move_to(30.5, 6.0)
    assert caught.value.fault == "read-back"


def test_a_start_without_an_answer_is_not_repeated() -> None:
    with scripted(LeadshineStage, [*MOVE[:2], (START, SILENT)]) as stage, pytest.raises(InstrumentError) as caught:
        stage.move_to(30.5, 6.0)
    assert caught.value.fault == "silent"


@pytest.mark.parametrize(
    ("end", "says"),
    [([RESTING, positions(PULSES, PULSES - 1000)], r"-0\.400°"), ([STOPPED], "not complete")],
)
def test_stopped_elsewhere_is_not_arrived(end: list[tuple[bytes, bytes]], says: str) -> None:
    with scripted(LeadshineStage, [*MOVE, RUNNING, *end]) as stage:
        stage.move_to(30.5, 6.0)
        assert stage.moving()
        stage._clock.wait_until(9.0)
        with pytest.raises(InstrumentError, match=says) as caught:
            stage.moving()
    assert caught.value.fault == "not arrived"


def test_stopped_on_its_target_is_arrived() -> None:
    with scripted(LeadshineStage, [*MOVE, RESTING, RESTING, positions(PULSES, PULSES + 3)]) as stage:
        stage.move_to(30.5, 6.0)
        assert stage.moving()  # the drive has not begun to show it
        stage._clock.wait_until(9.0)
        assert not stage.moving()


def test_an_alarm_is_said_with_its_number() -> None:
    wire = [read("0103 1003 0001", [0x0013]), read("0103 2203 0001", [0x0E0])]
    with scripted(LeadshineStage, wire) as stage, pytest.raises(InstrumentError, match="alarm 00E0h") as caught:
        stage.moving()
    assert caught.value.fault == "stage fault"


@pytest.mark.parametrize(("pulses", "motor", "says"), [(4000, 500, "4000 pulses"), (10_000, 90_000, "do not agree")])
def test_a_drive_that_is_set_up_otherwise_is_refused(pulses: int, motor: int, says: str) -> None:
    wire = [read("0103 0001 0001", [pulses]), RESTING, positions(500, motor)]
    with scripted(LeadshineStage, wire) as stage, pytest.raises(InstrumentError, match=says) as caught:
        stage.identify()
    assert caught.value.fault == "wrong set-up"


def test_a_model_with_a_code_for_its_pulses_is_a_setting() -> None:
    wire = [read("0103 0001 0001", [6]), RESTING, positions(-500, -500)]
    with scripted(LeadshineStage, wire, pulses_code=True) as stage:
        assert stage.identify().serial == "address 1"


def test_it_homes_only_where_it_does_not_know_its_reference() -> None:
    with scripted(LeadshineStage, [RESTING, read("0103 1003 0001", [0x0012]), wrote("0106 6002 0020")]) as stage:
        stage.home()
        stage.home()


@pytest.mark.parametrize(("angle", "rate"), [(1e7, 6.0), (10.0, 0.01)])
def test_what_does_not_fit_is_refused_and_nothing_is_sent(angle: float, rate: float) -> None:
    with scripted(LeadshineStage, []) as stage, pytest.raises(LimitError, match="nothing was sent"):
        stage.move_to(angle, rate)


@pytest.mark.parametrize(
    "hexadecimal",
    [
        "0110 6200 0006 0C 0041",  # relative
        "0110 6200 0006 0C 0002",  # velocity
        "0106 1801 2211",  # into its memory
        "0106 1801 4001",  # jog
        "0106 6002 0021",  # a new zero
        "0106 6006 0000",
        "0106 01BF 0002",
    ],
)
def test_other_motion_zeros_limits_and_memory_cannot_be_written(hexadecimal: str) -> None:
    with scripted(LeadshineStage, []) as stage, pytest.raises(InstrumentError) as caught:
        stage.registers._link._line.send(rtu(hexadecimal))
    assert caught.value.fault == "forbidden"


def test_it_does_not_home_faster_than_the_dut_may_turn() -> None:
    asked = [read("0103 1003 0001", [0x0012]), read("0103 600F 0002", [150, 30])]
    with scripted(LeadshineStage, [*asked, wrote("0106 6002 0020")]) as stage:
        stage.home(10.0)
    with (
        scripted(LeadshineStage, asked) as stage,
        pytest.raises(LimitError, match=r"10 deg/s, the DUT's limit is 4 deg"),
    ):
        stage.home(4.0)
