"""Thorlabs APT: messages byte for byte, what is told unasked, faults by their bits; rest is not arrival."""

from __future__ import annotations

import struct
from datetime import UTC, datetime
from typing import Any

import pytest

from drivers.thorlabs_apt import AptStage, Settings
from labcal.bench.clock import VirtualClock
from labcal.bench.driver_kit.testing import SILENT, Exchange, scripted
from labcal.bench.links import EmulatedLink
from labcal.errors import InstrumentError
from labcal.testing.drivers import installed
from labcal.testing.drivers.rig import DriverRig

COMPLETED = bytes.fromhex("6404 0E00 81 50 0100 55150200 00000000 00010080")
HOMED_REST, MOVING, HOMING = 0x80000500, 0x80000510, 0x80000310


def tell(said: str) -> Exchange:
    return bytes.fromhex(said), SILENT


def ask(number: int, answer: str) -> Exchange:
    data = bytes.fromhex(answer)
    head = struct.pack("<HHBB", number + 1, len(data), 0x81, 0x50)
    return struct.pack("<HBBBB", number, number > 0xFF, 0, 0x50, 1), head + data


def who(model: bytes = b"K10CR1") -> list[Exchange]:
    data = struct.pack("<I8sH4s60s3H", 55_000_042, model, 16, b"\3\0\1", b"", 1, 3, 1)
    return [tell("1200 00 00 50 01"), ask(0x0005, data.hex())]


def bits(status: int) -> Exchange:
    return ask(0x0429, "0100" + struct.pack("<I", status).hex())


AT_10 = ask(0x0414, "0100 00000000 AC3A0000 55555E04")  # 15 020, 73 291 093: 10 deg/s of a K10CR1
ENABLE = tell("1002 01 01 50 01")
TO_1_DEG = tell("5304 0600 D0 01 0100 55150200")
MOVE = [*who(), AT_10, ENABLE, TO_1_DEG]


def stage(wire: list[Any], **stated: Any) -> Any:
    return scripted(AptStage, wire, **stated)


def test_the_controller_says_who_it_is() -> None:
    with stage(who()) as motor:
        found = motor.identify()
    assert (found.model, found.serial, found.firmware) == ("K10CR1", "55000042", "1.0.3")


def test_another_controller_and_one_whose_stage_is_not_known_are_refused() -> None:
    with stage(who(b"BPC303")) as motor, pytest.raises(InstrumentError, match="BPC303") as caught:
        motor.identify()
    assert caught.value.fault == "another instrument"
    with stage(who(b"KST101")) as motor, pytest.raises(InstrumentError, match="which stage") as caught:
        motor.identify()
    assert caught.value.fault == "wrong set-up"
    with stage([*who(b"KST101"), ask(0x0411, "0100 E8030000")], counts_per_deg=100.0) as motor:
        motor.identify()
        assert motor.angle_deg() == 10.0


def test_a_move_is_told_once_and_what_comes_unasked_is_no_answer() -> None:
    position = ask(0x0411, "0100 55150200")
    wire = [*MOVE, bits(MOVING), (bits(HOMED_REST)[0], COMPLETED + bits(HOMED_REST)[1]), position]
    with stage(wire) as motor:
        motor.identify()
        motor.move_to(1.0, 10.0)
        assert motor.moving()
        motor._clock.wait_until(motor._clock.now() + 1.0)
        assert not motor.moving()


@pytest.mark.parametrize("cut", range(1, len(COMPLETED)))
def test_the_end_of_a_message_whose_beginning_was_dropped_before_the_question_is_passed_over(cut: int) -> None:
    asked, said = bits(MOVING)
    with stage([(asked, COMPLETED[cut:] + said)]) as motor:
        assert motor.moving()


def test_another_velocity_is_told_and_read_back() -> None:
    set_5 = tell("1304 0E00 D0 01 0100 00000000 AC3A0000 AB2A2F02")
    held = ask(0x0414, "0100 00000000 AC3A0000 AB2A2F02")
    with stage([*who(), AT_10, set_5, held, ENABLE, TO_1_DEG]) as motor:
        motor.identify()
        motor.move_to(1.0, 5.0)
    with stage([*who(), AT_10, set_5, AT_10]) as motor:
        motor.identify()
        with pytest.raises(InstrumentError) as caught:
            motor.move_to(1.0, 5.0)
    assert caught.value.fault == "read-back"


def test_it_homes_where_it_does_not_know_its_place_and_no_faster_than_allowed() -> None:
    homing = "0100 0200 0100 {} 55550800"
    slower = tell("4004 0E00 D0 01 " + homing.format("5555BF01"))
    begin = [ENABLE, tell("4304 01 00 50 01")]
    fast, slow = (ask(0x0441, homing.format(velocity)) for velocity in ("55555E04", "5555BF01"))
    with stage([*who(), bits(0x80000100), fast, slower, slow, *begin]) as motor:
        motor.identify()
        motor.home(4.0)
    with stage([bits(HOMED_REST)]) as motor:
        motor.home(4.0)


@pytest.mark.parametrize(("bit", "says"), [(14, "lost its way"), (24, "current limit"), (25, "encoder")])
def test_a_fault_is_said_in_words(bit: int, says: str) -> None:
    with stage([bits(HOMED_REST | 1 << bit)]) as motor, pytest.raises(InstrumentError, match=says) as caught:
        motor.moving()
    assert caught.value.fault == "stage fault"


def test_what_it_reports_unasked_as_a_fault_is_one() -> None:
    told = struct.pack("<HHBBHH64s", 0x0081, 68, 0x81, 0x50, 0x0453, 7, b"not while it homes")
    with stage([(bits(0)[0], told)]) as motor, pytest.raises(InstrumentError, match="not while it homes"):
        motor.moving()


def test_at_rest_without_its_place_is_a_fault() -> None:
    with stage([bits(0x80000100)]) as motor, pytest.raises(InstrumentError, match="does not know where"):
        motor.moving()


def test_a_stop_brakes() -> None:
    with stage([tell("6504 01 02 50 01")]) as motor:
        motor.make_safe()


def test_status_updates_that_another_program_has_begun_are_ended() -> None:
    rig: DriverRig = installed("thorlabs-apt", forbidden=[]).rig()
    rig.emulator.take(rig.clock.now(), bytes.fromhex("1100 00 00 50 01"))
    since_s = rig.clock.now()
    rig.wait(1.0)
    updates = rig.emulator.emit(since_s + 0.95)
    assert [data[:2] for _, data in updates] == [b"\x81\x04"] * 9
    rig.driver.identify()
    rig.wait(1.0)
    assert rig.emulator.emit(rig.clock.now()) == []


def test_a_foreign_library_reads_what_the_emulator_says_and_it_hears_what_that_says() -> None:
    foreign = pytest.importorskip("thorlabs_apt_protocol", reason="needs thorlabs-apt-protocol, which is not installed")
    rig: DriverRig = installed("thorlabs-apt", forbidden=[]).rig()
    unpack = foreign.Unpacker()

    def heard(said: bytes, wait_s: float) -> list[Any]:
        rig.emulator.take(rig.clock.now(), said)
        until_s = rig.clock.now() + wait_s
        rig.wait(wait_s)
        unpack.feed(b"".join(data for _, data in rig.emulator.emit(until_s)))
        return list(unpack)

    at = {"dest": 0x50, "source": 1}
    assert heard(foreign.hw_req_info(**at), 0.1)[0].model_number.strip(b"\0") == b"K10CR1"
    homed = heard(foreign.mot_move_home(chan_ident=1, **at), 30.0)
    assert [message.msg for message in homed] == ["mot_move_homed"]
    velocity = {"min_velocity": 0, "acceleration": 15_020, "max_velocity": 73_291_093}
    heard(foreign.mot_set_velparams(chan_ident=1, **velocity, **at), 0.1)
    held = heard(foreign.mot_req_velparams(chan_ident=1, **at), 0.1)[0]
    assert {key: getattr(held, key) for key in velocity} == velocity
    (done,) = heard(foreign.mot_move_absolute(chan_ident=1, position=1_365_333, **at), 30.0)
    assert (done.msg, done.position, done.moving_forward) == ("mot_move_completed", 1_365_333, False)
    state = heard(foreign.mot_req_statusupdate(chan_ident=1, **at), 0.1)[0]
    assert (state.position, state.homed, state.settled) == (1_365_333, True, False)
    heard(foreign.mot_move_absolute(chan_ident=1, position=0, **at), 0.5)
    assert heard(foreign.mot_req_dcstatusupdate(chan_ident=1, **at), 0.1)[0].moving_reverse
    (stopped,) = heard(foreign.mot_move_stop(chan_ident=1, stop_mode=2, **at), 5.0)
    assert stopped.msg == "mot_move_stopped"
    assert 0 < stopped.position < 1_365_333


class Chatters:
    """Tells a hundred times a second that a move is completed, once it has heard anything, and answers nothing."""

    ENDLESS_S = 300.0

    def __init__(self) -> None:
        self._next_s = float("inf")

    def take(self, t_s: float, data: bytes) -> None:
        self._next_s = min(self._next_s, t_s)

    def due_s(self) -> float:
        return self._next_s

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        assert until_s < self.ENDLESS_S, "it is waited for without end"
        told = []
        while self._next_s <= until_s:
            told.append((self._next_s, struct.pack("<HBBBB", 0x0464, 1, 0, 0x01, 0x50)))
            self._next_s += 0.01
        return told


def test_one_that_tells_without_end_and_never_answers_is_given_up() -> None:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    stage = AptStage("it", EmulatedLink("emulated://line", Chatters(), clock), clock, Settings())
    with pytest.raises(InstrumentError, match="tells 100 things unasked and does not answer"):
        stage.angle_deg()
    assert clock.now() < 5.0
