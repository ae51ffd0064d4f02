"""Standa 8SMC5: bytes that the maker's library (libximc) sends, answers with a CRC, homing that ends with a zero."""

from __future__ import annotations

import struct
from typing import Any

import pytest

from drivers.framing.rtu_crc import rtu_crc
from drivers.framing.ximc import ANSWERS, TELLS, packed
from drivers.standa_8smc5 import StandaStage
from labcal.bench.driver_kit.testing import Exchange, scripted
from labcal.errors import InstrumentError, LimitError
from labcal.testing.drivers import installed
from labcal.testing.drivers.rig import DriverRig

HOMED, RUNS, HOME_RUNS, HOME_DONE, HOME_FAILED = 0x20, 0x81, 0x86, 0x06, 0x46
SPEED = (800, 0, 800, 800, 80, 0, 0)  # 10 deg/s of 28 800 steps a turn
ENGINE = (0, 670, 3200, 0, 0xA4, 200, 9, 0)  # a step in 256 parts


def answer(command: str, *values: Any) -> Exchange:
    return command.encode(), command.encode() + packed(struct.pack(ANSWERS[command], *values))


def told(command: str, *values: int) -> Exchange:
    return command.encode() + packed(struct.pack(TELLS[command], *values)), command.encode()


def status(steps: int, parts: int = 0, *, moves: int = 0, command: int = 0x01, flags: int = HOMED) -> Exchange:
    return answer("gets", moves, command, 1, 0, 0, steps, parts, 0, 0, 0, 0, 2400, 0, 500, 250, flags, 0, 8)


PARTS = answer("geng", *ENGINE)
MOVE = [answer("gmov", *SPEED), PARTS, told("smov", *SPEED), answer("gmov", *SPEED), told("move", 80, 128)]


def stage(wire: list[Exchange], **stated: Any) -> Any:
    return scripted(StandaStage, wire, **stated)


def test_the_bytes_of_the_makers_library_are_those_of_this_one() -> None:
    assert rtu_crc(b"123456789") == bytes.fromhex("374B")
    moved = bytes.fromhex("6d6f7665 20030000 8000 cccccccccccc 497f")  # to 800 steps and 128 parts
    assert packed(moved[4:-2]) == moved[4:]
    assert struct.unpack(TELLS["move"], moved[4:-2]) == (800, 128)
    faster = bytes.fromhex("736d6f76 40060000 00 2003 2003 50000000 00 00 cccccccccccccccccc 3fc4")
    assert packed(faster[4:-2]) == faster[4:]
    assert struct.unpack(TELLS["smov"], faster[4:-2]) == (1600, 0, 800, 800, 80, 0, 0)


def test_the_emulator_answers_the_makers_library() -> None:
    rig: DriverRig = installed("standa-8smc5", forbidden=[]).rig()

    def heard(said: bytes, wait_s: float = 0.1) -> bytes:
        rig.emulator.take(rig.clock.now(), said)
        rig.wait(wait_s)
        return b"".join(data for _, data in rig.emulator.emit(rig.clock.now()))

    assert heard(b"geti")[4:18] == b"XIMCSM8SMC5-US"
    assert heard(b"home", 5.0) == b"home"
    assert struct.unpack("<ih", heard(b"gpos")[4:10]) == (240, 0)  # its count is not zero there
    assert heard(b"zero") == b"zero"
    assert heard(bytes.fromhex("6d6f7665 20030000 8000 cccccccccccc 497f"), 30.0) == b"move"
    assert struct.unpack("<ih", heard(b"gpos")[4:10]) == (800, 128)
    assert rig.angle_deg() == pytest.approx(800.5 / 80)
    assert heard(bytes.fromhex("6d6f7665 20030000 8000 cccccccccccc 4980")) == b"errd"
    assert heard(b"what") == b"errc"
    assert heard(b"\0\0\0") == b"\0\0\0"


def test_it_says_who_it_is() -> None:
    with stage([answer("geti", b"XIMC", b"SM", b"8SMC5-US", 2, 3, 4), answer("gser", 17_342)]) as motor:
        who = motor.identify()
    assert (who.model, who.serial, who.firmware) == ("8SMC5-US", "17342", "2.3.4")


def test_another_instrument_is_refused() -> None:
    with (
        stage([answer("geti", b"ACME", b"SM", b"8SMC5-US", 2, 3, 4)]) as motor,
        pytest.raises(InstrumentError) as caught,
    ):
        motor.identify()
    assert caught.value.fault == "another instrument"


def test_a_move_is_told_once_and_looked_at() -> None:
    with stage([*MOVE, status(40, 3, moves=1, command=RUNS), status(80, 128)]) as motor:
        motor.move_to(1.00625, 10.0)
        assert motor.moving()
        assert not motor.moving()


def test_a_negative_angle_has_negative_parts() -> None:
    with stage([*MOVE[:-1], told("move", -80, -128), status(-80, -128)]) as motor:
        motor.move_to(-1.00625, 10.0)
        assert motor.angle_deg() == pytest.approx(-1.00625)


def test_at_rest_off_the_target_is_not_arrived() -> None:
    with stage([*MOVE, status(72, 0)]) as motor:
        motor.move_to(1.00625, 10.0)
        with pytest.raises(InstrumentError, match=r"-0\.106°") as caught:
            motor.moving()
    assert caught.value.fault == "not arrived"


def test_a_speed_that_reads_back_otherwise_moves_nothing() -> None:
    with stage([*MOVE[:3], answer("gmov", 900, *SPEED[1:])]) as motor, pytest.raises(InstrumentError) as caught:
        motor.move_to(1.0, 10.0)
    assert caught.value.fault == "read-back"


def test_homing_ends_with_its_zero_and_is_done_once() -> None:
    wire = [(b"home", b"home"), status(7, moves=1, command=HOME_RUNS, flags=0), PARTS,
            status(240, command=HOME_DONE), (b"zero", b"zero")]  # fmt: skip
    with stage(wire) as motor:
        motor.home()
        assert motor.moving()
        assert not motor.moving()
        motor.home()


@pytest.mark.parametrize(("command", "flags"), [(HOME_FAILED, HOMED), (HOME_DONE, 0)])
def test_a_reference_that_was_not_found_sets_no_zero(command: int, flags: int) -> None:
    with stage([(b"home", b"home"), status(240, command=command, flags=flags), PARTS]) as motor:
        motor.home()
        with pytest.raises(InstrumentError, match="did not find its reference") as caught:
            motor.moving()
    assert caught.value.fault == "stage fault"


def test_homing_that_was_stopped_sets_no_zero() -> None:
    with stage([(b"home", b"home"), (b"sstp", b"sstp"), status(40, command=0x08, flags=0), PARTS]) as motor:
        motor.home()
        motor.make_safe()
        assert not motor.moving()


def test_it_does_not_home_faster_than_the_dut_may_turn() -> None:
    homing = answer("ghom", 640, 0, 80, 0, 0, 0, 0x172)
    with stage([homing, PARTS, (b"home", b"home")]) as motor:
        motor.home(8.0)
    with stage([homing, PARTS]) as motor, pytest.raises(LimitError, match="8 deg/s, the DUT's limit is 4 deg/s"):
        motor.home(4.0)


@pytest.mark.parametrize(("bit", "says"), [(6, "alarm"), (8, "too hot"), (21, "encoder")])
def test_a_fault_is_said_in_words(bit: int, says: str) -> None:
    with (
        stage([status(0, flags=HOMED | 1 << bit), PARTS]) as motor,
        pytest.raises(InstrumentError, match=says) as caught,
    ):
        motor.moving()
    assert caught.value.fault == "stage fault"


@pytest.mark.parametrize(("word", "says"), [(b"errc", "does not know"), (b"errd", "damaged"), (b"errv", "wrong")])
def test_a_refusal_is_said_in_words(word: bytes, says: str) -> None:
    with stage([(b"sstp", word)]) as motor, pytest.raises(InstrumentError, match=says) as caught:
        motor.make_safe()
    assert caught.value.fault == "refused"
