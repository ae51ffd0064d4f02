"""Newport SMC100: replies with their prefix, states, and errors by letter; ready is not arrived."""

from __future__ import annotations

import pytest

from drivers.newport_smc100 import Smc100Stage
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.errors import InstrumentError, LimitError

VERSION = b"1VE SMC_CC - Controller-driver version  3. 1. 2\r\n"  # as three users of one have written it down
FINE = (b"1TE\r\n", b"1TE@\r\n")
AT_6 = [(b"1VA6.0000\r\n", SILENT), FINE, (b"1VA?\r\n", b"1VA6\r\n")]
MOVE = [*AT_6, (b"1PA30.5000\r\n", SILENT), FINE]


def status(code: bytes) -> tuple[bytes, bytes]:
    return b"1TS\r\n", b"1TS" + code + b"\r\n"


def test_controller_and_stage_say_who_they_are() -> None:
    with scripted(Smc100Stage, [(b"1VE\r\n", VERSION), (b"1ID?\r\n", b"1IDURS50BCC\r\n")]) as stage:
        assert stage.identify().model == "URS50BCC"


def test_another_controller_is_refused() -> None:
    with (
        scripted(Smc100Stage, [(b"1VE\r\n", b"1VE X\r\n"), (b"1ID?\r\n", b"1IDX\r\n")]) as stage,
        pytest.raises(InstrumentError) as caught,
    ):
        stage.identify()
    assert caught.value.fault == "another instrument"


@pytest.mark.parametrize("code", [b"00000A", b"000011"])
def test_it_homes_where_it_is_not_referenced(code: bytes) -> None:
    with scripted(Smc100Stage, [status(code), (b"1OR\r\n", SILENT), FINE]) as stage:
        stage.home()


@pytest.mark.parametrize("code", [b"000032", b"000033", b"000035"])
def test_it_does_not_home_again_where_it_knows_its_reference(code: bytes) -> None:
    with scripted(Smc100Stage, [status(code)]) as stage:
        stage.home()


@pytest.mark.parametrize(("letter", "says"), [(b"H", "not referenced"), (b"G", "beyond its range"), (b"?", "failed")])
def test_a_refused_move_is_said_in_words_and_not_repeated(letter: bytes, says: str) -> None:
    wire = [*MOVE[:-1], (b"1TE\r\n", b"1TE" + letter + b"\r\n")]
    with scripted(Smc100Stage, wire) as stage, pytest.raises(InstrumentError, match=says):
        stage.move_to(30.5, 6.0)


def test_a_move_whose_answer_is_lost_is_not_repeated() -> None:
    with scripted(Smc100Stage, [*MOVE[:-1], (b"1TE\r\n", SILENT)]) as stage, pytest.raises(InstrumentError) as caught:
        stage.move_to(30.5, 6.0)
    assert caught.value.fault == "silent"


def test_ready_off_the_target_is_not_arrived() -> None:
    wire = [*MOVE, status(b"000028"), status(b"00001E"), status(b"000033"), (b"1TP\r\n", b"1TP30.400\r\n")]
    with scripted(Smc100Stage, wire) as stage:
        stage.move_to(30.5, 6.0)
        assert stage.moving()
        assert stage.moving()
        with pytest.raises(InstrumentError, match=r"-0\.100°") as caught:
            stage.moving()
    assert caught.value.fault == "not arrived"


def test_a_garbled_state_or_position_is_asked_for_again_ten_times_at_most() -> None:
    wire = [(b"1TS\r\n", b"1TS00\xff033\r\n"), (b"1TS\r\n", b"TS000033\r\n"), status(b"000033"),
            (b"1TP\r\n", b"1TP3 0.5\r\n"), (b"1TP\r\n", b"1TP.\r\n"), (b"1TP\r\n", b"1TP3.0.5\r\n"),
            (b"1TP\r\n", b"1TP-\r\n"), (b"1TP\r\n", b"1TP30.5\r\n"),
            *[(b"1TP\r\n", b"1TP\x7f0.5\r\n")] * 10]  # fmt: skip
    with scripted(Smc100Stage, wire) as stage:
        assert not stage.moving()
        with pytest.raises(InstrumentError) as caught:
            stage.angle_deg()
    assert caught.value.fault == "wrong reply"


def test_commands_are_60_ms_apart() -> None:
    with scripted(Smc100Stage, [(b"1ST\r\n", SILENT), FINE]) as stage:
        begun_s = stage._clock.now()
        stage.make_safe()
        assert stage._clock.now() - begun_s >= 0.06


def test_ready_on_the_target_is_arrived() -> None:
    wire = [*MOVE, status(b"000033"), (b"1TP\r\n", b"1TP30.500\r\n")]
    with scripted(Smc100Stage, wire) as stage:
        stage.move_to(30.5, 6.0)
        assert not stage.moving()


@pytest.mark.parametrize("code", [b"00003C", b"00000A", b"000014", b"020033"])
def test_disabled_not_referenced_configuration_and_error_bits_end_the_step(code: bytes) -> None:
    with scripted(Smc100Stage, [status(code)]) as stage, pytest.raises(InstrumentError) as caught:
        stage.moving()
    assert caught.value.fault == "stage fault"


def test_it_does_not_home_faster_than_the_dut_may_turn() -> None:
    asked = [status(b"00000A"), (b"1OH?\r\n", b"1OH8\r\n")]
    with scripted(Smc100Stage, [*asked, (b"1OR\r\n", SILENT), FINE]) as stage:
        stage.home(8.0)
    with scripted(Smc100Stage, asked) as stage, pytest.raises(LimitError, match=r"8 deg/s, the DUT's limit is 4 deg/s"):
        stage.home(4.0)
