"""TMCL: frames byte for byte, refusals by status, how modules count speed; standing still is not arrived."""

from __future__ import annotations

import struct
from typing import Any

import pytest

from drivers.framing.tmcl import summed
from drivers.trinamic_tmcl import TmclStage
from labcal.bench.driver_kit.testing import Exchange, scripted
from labcal.errors import InstrumentError, LimitError
from labcal.testing.drivers import installed
from labcal.testing.drivers.rig import DriverRig

NO_SUCH = 3


def said(command: int, kind: int, value: int = 0, answer: int | None = None, status: int = 100) -> Exchange:
    """A request to motor 0 of module 1 and its reply to host 2."""
    body = struct.pack(">BBBBi", 1, command, kind, 0, value)
    back = struct.pack(">BBBBi", 2, 1, status, command, value if answer is None else answer)
    return body + bytes([sum(body) % 256]), back + bytes([sum(back) % 256])


def get(number: int, answer: int, status: int = 100) -> Exchange:
    return said(6, number, 0, answer, status)


WHO = [said(136, 1, 0, 1260 << 16 | 0x0106), get(154, 0, NO_SUCH)]
AT_10 = [said(5, 4, 128_000), get(4, 128_000)]
MOVE = [*AT_10, said(4, 0, 12_800)]  # 1 deg of 4 608 000 microsteps a turn
STANDS = [get(3, 0), said(13, 2, 0, 0)]


def stage(wire: list[Exchange], **stated: Any) -> Any:
    return scripted(TmclStage, wire, **stated)


def later(motor: Any) -> None:
    motor._clock.wait_until(motor._clock.now() + 0.2)


def test_the_manuals_own_bytes() -> None:
    assert said(4, 0, 1000)[0] == summed(1, 4, 0, 0, 1000) == bytes.fromhex("01 04 00 00 00 00 03 E8 F0")
    assert get(1, 0)[0] == bytes.fromhex("01 06 01 00 00 00 00 00 08")
    assert get(1, 711)[1] == bytes.fromhex("02 01 64 06 00 00 02 C7 36")


def test_the_module_says_who_it_is() -> None:
    with stage(WHO) as motor:
        who = motor.identify()
    assert (who.model, who.firmware) == ("TMCM-1260", "1.06")


def test_a_move_is_told_once_and_looked_at() -> None:
    with stage([*MOVE, get(3, 900), *STANDS, get(1, 12_800)]) as motor:
        motor.move_to(1.0, 10.0)
        later(motor)
        assert motor.moving()
        assert not motor.moving()


def test_a_module_with_a_tmc429_is_told_its_own_units() -> None:
    wire = [WHO[0], get(154, 5), said(5, 4, 1048), get(4, 1048), said(4, 0, -12_800)]  # 16 MHz / 2^21 a unit
    with stage(wire) as motor:
        motor.identify()
        motor.move_to(-1.0, 8000 * 360 / 4_608_000)


def test_a_rate_below_one_unit_moves_nothing() -> None:
    with stage([]) as motor, pytest.raises(LimitError, match="nothing was sent"):
        motor.move_to(1.0, 1e-6)


def test_a_speed_that_reads_back_otherwise_moves_nothing() -> None:
    with stage([AT_10[0], get(4, 2047)]) as motor, pytest.raises(InstrumentError) as caught:
        motor.move_to(1.0, 10.0)
    assert caught.value.fault == "read-back"


@pytest.mark.parametrize(("status", "says"), [(4, "does not take the value"), (1, "wrong checksum"), (77, "status 77")])
def test_a_refusal_is_said_in_words(status: int, says: str) -> None:
    with stage([*AT_10, said(4, 0, 12_800, status=status)]) as motor, pytest.raises(InstrumentError) as caught:
        motor.move_to(1.0, 10.0)
    assert says in str(caught.value)
    assert caught.value.fault == "refused"


def test_where_it_stands_short_of_its_target_it_says_what_it_knows() -> None:
    why = [get(10, 1), get(11, 0), get(207, 2), get(208, 0, NO_SUCH)]
    with stage([*MOVE, *STANDS, get(1, 6_400), *why]) as motor:
        motor.move_to(1.0, 10.0)
        later(motor)
        with pytest.raises(InstrumentError, match=r"-0\.500.*right limit switch is closed and its encoder") as caught:
            motor.moving()
    assert caught.value.fault == "not arrived"


def test_it_homes_once_and_no_faster_than_the_dut_may_turn() -> None:
    asked = [*WHO, get(194, 64_000), get(195, 6_400)]
    with stage([*asked, said(13, 0)]) as motor:
        motor.identify()
        motor.home(5.0)
        motor.home(5.0)
    with stage(asked) as motor:
        motor.identify()
        with pytest.raises(LimitError, match="5 deg/s, the DUT's limit is 4 deg/s"):
            motor.home(4.0)


def test_an_older_module_searches_at_a_share_of_its_greatest_speed() -> None:
    asked = [WHO[0], get(154, 0), get(194, 1), get(4, 20), get(195, 2), get(4, 20)]  # 10 units: 2 441 a second
    with stage(asked) as motor:
        motor.identify()
        with pytest.raises(LimitError, match=r"homes at 0\.1907 deg/s"):
            motor.home(0.1)


def test_a_stop_ends_a_search_too_and_one_without_searches_is_stopped_all_the_same() -> None:
    for status in (100, 2):
        with stage([said(3, 0), said(13, 1, status=status)]) as motor:
            motor.make_safe()


def test_the_makers_library_drives_the_emulator() -> None:
    pytest.importorskip("pytrinamic", reason="needs pytrinamic, which is not installed")
    interface = pytest.importorskip("pytrinamic.connections.tmcl_interface").TmclInterface
    module = pytest.importorskip("pytrinamic.modules").TMCM1260
    refused = pytest.importorskip("pytrinamic.tmcl").TMCLReplyStatusError
    rig: DriverRig = installed("trinamic-tmcl", forbidden=[]).rig()

    class Line(interface):  # type: ignore[misc,valid-type]
        def _send(self, host_id: int, module_id: int, data: bytes) -> None:
            rig.emulator.take(rig.clock.now(), bytes(data))

        def _recv(self, host_id: int, module_id: int) -> bytes:
            rig.wait(0.05)
            return b"".join(data for _, data in rig.emulator.emit(rig.clock.now()))

    line = Line()
    assert line.get_version_string() == "1260V106"
    motor = module(line).motors[0]
    motor.linear_ramp.max_velocity = 64_000
    assert motor.linear_ramp.max_velocity == 64_000
    motor.move_to(128_000)
    rig.wait(1.0)
    assert motor.actual_velocity == pytest.approx(64_000, rel=0.01)
    assert not motor.get_position_reached()
    rig.wait(10.0)
    assert (motor.actual_position, motor.actual_velocity, motor.get_position_reached()) == (128_000, 0, 1)
    assert rig.angle_deg() == pytest.approx(10.0)
    motor.rotate(-64_000)
    rig.wait(2.0)
    motor.stop()
    rig.wait(3.0)
    assert motor.actual_velocity == 0
    with pytest.raises(refused, match="Wrong Type"):
        motor.get_axis_parameter(154)
