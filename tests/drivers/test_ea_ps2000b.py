"""EA PS 2000 B: telegrams byte for byte, remote control, refusals, trips, what is never sent."""

from __future__ import annotations

from typing import Any

import pytest

from drivers.ea_ps2000b import EaPs2000B
from labcal.bench.driver_kit.testing import SILENT, Exchange, scripted
from labcal.errors import InstrumentError, LimitError
from labcal.testing.drivers import installed


def summed(hexadecimal: str) -> bytes:
    body = bytes.fromhex(hexadecimal)
    return body + bytes(divmod(sum(body), 256))


def text(number: str, said: bytes) -> Exchange:
    return summed(f"7F00{number}"), summed(f"{0x80 + len(said):02x}00{number}{said.hex()}00")


OK = summed("8000FF00")
NOMINAL = (summed("730003"), summed("83000341200000"))  # 10 A
REMOTE = (bytes.fromhex("F1 00 36 10 10 01 47"), bytes.fromhex("80 00 FF 00 01 7F"))
WHO = [text("00", b"PS 2042-10B"), text("01", b"2884030001"), text("08", b"EA-Elektro-Auto"), text("09", b"V3.04")]


def ps(wire: list[Any], **stated: Any) -> Any:
    return scripted(EaPs2000B, wire, **stated)


def test_who_it_is() -> None:
    with ps([*WHO, NOMINAL]) as supply:
        who = supply.identify()
    assert (who.model, who.serial, who.manufacturer) == ("PS 2042-10B", "2884030001", "EA-Elektro-Auto")


def test_another_instrument_and_one_that_delivers_less_are_refused() -> None:
    with ps([text("00", b"PSI 9080-60"), *WHO[1:]]) as supply, pytest.raises(InstrumentError, match="not a PS 2000"):
        supply.identify()
    with (
        ps([*WHO, NOMINAL], max_current_A=12.0) as supply,
        pytest.raises(InstrumentError, match="delivers 10 A") as caught,
    ):
        supply.identify()
    assert caught.value.fault == "wrong set-up"  # of another instrument's fault it would be told no zero


def test_a_current_is_a_share_of_its_nominal_one_and_is_read_back() -> None:
    told = (summed("F10033 0500"), OK)  # 1280 of 25600: 0.5 A of 10 A
    back = (summed("710033"), summed("810033 0500"))
    again = (summed("F10033 0A00"), OK)
    with ps([REMOTE, NOMINAL, told, back, again, (back[0], summed("810033 0A00"))]) as supply:
        supply.set_current(0.5)
        supply.set_current(1.0)


def test_its_output_goes_on_with_its_voltage_set() -> None:
    volts = (summed("730002"), summed("83000242280000"))  # 42 V
    wire = [REMOTE, volts, (summed("F10032 2F9E"), OK), (summed("710032"), summed("810032 2F9E")),
            (summed("F10036 0101"), OK), (summed("750047"), summed("850047 01 05 0000 0000"))]  # fmt: skip
    with ps(wire) as supply:
        supply.output(True)


def test_a_set_that_reads_back_otherwise_is_told() -> None:
    wire = [REMOTE, NOMINAL, (summed("F10033 0500"), OK), (summed("710033"), summed("810033 0000"))]
    with ps(wire) as supply, pytest.raises(InstrumentError, match="reads back 0 A") as caught:
        supply.set_current(0.5)
    assert caught.value.fault == "read-back"


def test_what_it_refuses_is_said_and_remote_control_is_taken_anew() -> None:
    wire = [REMOTE, NOMINAL, (summed("F10033 0500"), summed("8000FF09")), REMOTE, (summed("F10033 0000"), OK),
            (summed("710033"), summed("810033 0000"))]  # fmt: skip
    with ps(wire) as supply:
        with pytest.raises(InstrumentError, match="not under remote control") as caught:
            supply.set_current(0.5)
        supply.set_current(0.0)
    assert caught.value.fault == "refused"


def test_zero_that_waits_for_nothing_needs_nothing_asked_before() -> None:
    wire = [(REMOTE[0], SILENT), (summed("F10033 0000"), SILENT), (REMOTE[0], SILENT), (summed("F10036 0100"), SILENT)]
    with ps(wire) as supply:
        supply.write_current(0.0)
        supply.write_off()


def test_a_wrong_checksum_is_no_value() -> None:
    state = summed("850047 01 05 0000 0500")
    for bad in (state[:-1] + b"\0", state[:7] + b"\7" + state[8:]):
        with ps([(summed("750047"), bad)]) as supply, pytest.raises(InstrumentError) as caught:
            supply.measure_current()
        assert caught.value.fault == "wrong reply"


@pytest.mark.parametrize("amps", [3.01, -0.1])
def test_a_current_beyond_its_limit_sends_nothing(amps: float) -> None:
    with ps([]) as supply, pytest.raises(LimitError, match="nothing was sent"):
        supply.set_current(amps)


@pytest.mark.parametrize(("bit", "kind"), [(4, "over-voltage"), (5, "over-current"), (7, "over-temperature")])
def test_a_trip_is_named(bit: int, kind: str) -> None:
    rig = installed("ea-ps2000b", forbidden=[]).rig()
    rig.driver.identify()
    rig.driver.output(True)
    rig.driver.set_current(1.0)
    rig.wait(0.5)
    assert rig.coil_A() == pytest.approx(1.0, abs=0.001)
    rig.emulator.trip(rig.clock.now(), bit)
    rig.wait(1.0)
    with pytest.raises(InstrumentError, match=f"its {kind} protection tripped"):
        rig.driver.measure_current()


def test_the_panel_has_it_back_last() -> None:
    rig = installed("ea-ps2000b", forbidden=[]).rig()
    rig.driver.identify()
    rig.driver.output(True)
    rig.driver.make_safe()
    assert rig.sent[-1] == summed("F10036 1000")


def test_acknowledgements_that_nobody_waited_for_do_not_answer_the_next_question() -> None:
    zero = (summed("F10033 0000"), OK)
    off = (bytes.fromhex("F1 00 36 01 00 01 28"), OK)
    back = (summed("710033"), summed("810033 0000"))
    with ps([REMOTE, zero, REMOTE, off, back, NOMINAL]) as supply:
        supply.write_current(0.0)
        supply.write_off()
        assert supply.set_point() == 0.0
