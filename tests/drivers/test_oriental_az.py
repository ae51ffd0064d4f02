"""Oriental AZ: one block starts one absolute move; standing still is not arrived."""

from __future__ import annotations

import pytest
from frames import read, rtu

from drivers.oriental_az import OrientalStage
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.errors import InstrumentError, LimitError

ASK = bytes.fromhex("0103007F0001B5D2")
READY, MOVING, ALARM = (read("0103 007F 0001", [word]) for word in (0x4020, 0x2000, 0x00A0))
OFF_POSITION = read("0103 007F 0001", [0x0020])
BLOCK = rtu(  # data 0, absolute, 30.5° = 1525 steps, 6 deg/s = 300 Hz, twice 10 deg/s² = 500 steps/s², 100 %, start
    "0110 0058 0010 20 00000000 00000001 000005F5 0000012C 000001F4 000001F4 000003E8 00000001"
)
TAKEN = rtu("0110 0058 0010")


def feedback(steps: int, at: str = "00CC") -> tuple[bytes, bytes]:
    return read(f"0103 {at} 0002", list(divmod(steps & 0xFFFFFFFF, 0x10000)))


def test_the_frames_of_the_tests_are_those_of_the_facts() -> None:
    assert READY[0] == ASK


def test_a_move_is_one_block_of_absolute_data() -> None:
    with scripted(OrientalStage, [READY, (BLOCK, TAKEN)]) as stage:
        stage.move_to(30.5, 6.0)


def test_a_move_without_an_answer_is_not_repeated() -> None:
    with scripted(OrientalStage, [READY, (BLOCK, SILENT)]) as stage, pytest.raises(InstrumentError) as caught:
        stage.move_to(30.5, 6.0)
    assert caught.value.fault == "silent"


def test_standing_off_the_target_is_not_arrived() -> None:
    with scripted(OrientalStage, [READY, (BLOCK, TAKEN), MOVING, READY, feedback(1500)]) as stage:
        stage.move_to(30.5, 6.0)
        assert stage.moving()
        stage._clock.wait_until(9.0)
        with pytest.raises(InstrumentError, match=r"-0\.500°") as caught:
            stage.moving()
    assert caught.value.fault == "not arrived"


def test_standing_without_its_in_position_is_not_arrived() -> None:
    with scripted(OrientalStage, [READY, (BLOCK, TAKEN), OFF_POSITION]) as stage:
        stage.move_to(30.5, 6.0)
        stage._clock.wait_until(9.0)
        with pytest.raises(InstrumentError, match="not in position"):
            stage.moving()


def test_a_drive_that_does_not_show_its_move_yet_is_given_its_time() -> None:
    with scripted(OrientalStage, [READY, (BLOCK, TAKEN), READY, READY, feedback(1525)]) as stage:
        stage.move_to(30.5, 6.0)
        assert stage.moving()
        stage._clock.wait_until(9.0)
        assert not stage.moving()


def test_an_alarm_bars_the_move_and_is_said_in_words() -> None:
    with (
        scripted(OrientalStage, [ALARM, read("0103 0080 0002", [0, 0x28])]) as stage,
        pytest.raises(InstrumentError, match="alarm 28h, sensor error") as caught,
    ):
        stage.move_to(30.5, 6.0)
    assert caught.value.fault == "stage fault"


def test_stop_is_a_level_that_is_let_go_of() -> None:
    wire = [(rtu(f"0110 007C 0002 04 0000 00{level}"), rtu("0110 007C 0002")) for level in ("20", "00")]
    with scripted(OrientalStage, wire) as stage:
        stage.make_safe()


def test_a_position_below_zero_has_its_sign() -> None:
    with scripted(OrientalStage, [feedback(-9000)]) as stage:
        assert stage.angle_deg() == -180.0


def test_registers_that_do_not_agree_are_another_instrument() -> None:
    wire = [feedback(500), feedback(77, "0120"), READY]
    with scripted(OrientalStage, wire) as stage, pytest.raises(InstrumentError) as caught:
        stage.identify()
    assert caught.value.fault == "another instrument"


@pytest.mark.parametrize(("angle", "rate"), [(1e9, 6.0), (10.0, 0.001)])
def test_what_does_not_fit_is_refused_and_nothing_is_sent(angle: float, rate: float) -> None:
    with scripted(OrientalStage, []) as stage, pytest.raises(LimitError, match="nothing was sent"):
        stage.move_to(angle, rate)


@pytest.mark.parametrize(
    "hexadecimal",
    [
        "0110 0058 0010 20 00000000 00000002",  # relative
        "0110 007C 0002 04 0000 0040",  # motor free
        "0110 0078 0002 04 0000 0008",
        "0106 007D 0008",
        "0110 018A 0002 04 0000 0001",  # a new zero
        "0117 0058 0010",
    ],
)
def test_relative_moves_free_motor_and_new_zeros_cannot_be_sent(hexadecimal: str) -> None:
    with scripted(OrientalStage, []) as stage, pytest.raises(InstrumentError) as caught:
        stage.registers._link._line.send(rtu(hexadecimal))
    assert caught.value.fault == "forbidden"
