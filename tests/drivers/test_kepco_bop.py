"""Kepco BOP: a signed current, current mode before the output, and an off that does not open."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from drivers.emulators.kepco_bop import KepcoEmulator
from drivers.kepco_bop import KepcoBop, Settings
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.zero import to_zero
from labcal.bench.driver_kit.testing import SILENT, UNPLUGGED, scripted
from labcal.bench.links import EmulatedLink
from labcal.errors import InstrumentError, LimitError
from labcal.twin import open_twin

OK = (b"SYST:ERR?\n", b'0,"No error"\n')
REMOTE = [(b"SYST:REM ON\n", SILENT), OK]


def told(text: bytes, ask: bytes, reply: bytes) -> list[tuple[bytes, bytes | None]]:
    return [(text + b"\n", SILENT), OK, (ask + b"\n", reply + b"\r\n")]


SWITCHED_ON = [
    (b"OUTP?\n", b"0\n"),
    *REMOTE,
    *told(b"FUNC:MODE CURR", b"FUNC:MODE?", b"1"),
    *told(b"VOLT 20.000", b"VOLT?", b"20.000"),
    *told(b"CURR 0.0000", b"CURR?", b"0.0000"),
    *told(b"OUTP 1", b"OUTP?", b"1"),
]


def test_the_output_goes_on_in_current_mode_at_zero_with_its_compliance() -> None:
    with scripted(KepcoBop, [*SWITCHED_ON, (b"FUNC:MODE?\n", b"1\n")]) as supply:
        supply.output(True)


def test_a_supply_that_regulates_voltage_is_a_fault() -> None:
    wire = [*SWITCHED_ON, (b"FUNC:MODE?\n", b"0\n")]
    with scripted(KepcoBop, wire) as supply, pytest.raises(InstrumentError) as caught:
        supply.output(True)
    assert caught.value.fault == "wrong mode"


@pytest.mark.parametrize("amps", [-1.25, 2.5])
def test_a_current_has_a_sign(amps: float) -> None:
    with scripted(KepcoBop, [*REMOTE, *told(b"CURR %.4f" % amps, b"CURR?", b"%+.4E" % amps)]) as supply:
        supply.set_current(amps)


@pytest.mark.parametrize("amps", [3.01, -3.01, float("nan")])
def test_beyond_the_limit_nothing_is_sent(amps: float) -> None:
    with scripted(KepcoBop, []) as supply, pytest.raises(LimitError, match="nothing was sent"):
        supply.set_current(amps)


def test_a_read_back_of_the_other_sign_is_a_fault() -> None:
    wire = [*REMOTE, *told(b"CURR 0.5000", b"CURR?", b"-0.5000")]
    with scripted(KepcoBop, wire) as supply, pytest.raises(InstrumentError) as caught:
        supply.set_current(0.5)
    assert caught.value.fault == "read-back"


def test_what_it_refuses_is_said_in_its_words() -> None:
    wire = [*REMOTE, (b"CURR 0.5000\n", SILENT), (b"SYST:ERR?\n", b'-222,"Data out of range"\n')]
    with scripted(KepcoBop, wire) as supply, pytest.raises(InstrumentError, match="Data out of range"):
        supply.set_current(0.5)


def test_it_is_put_under_remote_control_once_and_again_after_a_fault() -> None:
    lost = [(b"CURR 0.2000\n", SILENT), (b"SYST:ERR?\n", b'-221,"Settings conflict"\n')]
    wire = [*REMOTE, *told(b"CURR 0.1000", b"CURR?", b"9.989E-2"), *lost,
            *REMOTE, *told(b"CURR 0.2000", b"CURR?", b"1.998E-1")]  # fmt: skip
    with scripted(KepcoBop, wire) as supply:
        supply.set_current(0.1)
        with pytest.raises(InstrumentError, match="Settings conflict"):
            supply.set_current(0.2)
        supply.set_current(0.2)


def test_on_the_way_to_zero_remote_control_is_asked_for_each_time() -> None:
    wire = [(b"SYST:REM ON\n", SILENT), (b"CURR 0.0000\n", SILENT), (b"SYST:REM ON\n", SILENT), (b"OUTP 0\n", SILENT)]
    with scripted(KepcoBop, wire) as supply:
        supply.write_current(0.0)
        supply.write_off()


def test_a_card_that_knows_no_remote_control_is_a_setting() -> None:
    wire = [*told(b"CURR 0.1000", b"CURR?", b"0.1"), (b"CURR 0.0000\n", SILENT)]
    with scripted(KepcoBop, wire, remote=False) as supply:
        supply.set_current(0.1)
        supply.write_current(0.0)


def test_what_a_network_card_echoes_is_no_answer() -> None:
    wire = [(b"SYST:REM ON\n", b"SYST:REM ON\r\n"), (b"SYST:ERR?\n", b'SYST:ERR?\r\n0,"No error"\r\n'),
            (b"CURR 0.1000\n", SILENT),  # its echo comes late
            (b"SYST:ERR?\n", [b"CURR 0.1000\r\n", b"SYST:ERR?\r\n", b'0,"No error"\r\n']),
            (b"CURR?\n", b"CURR?\r\n9.989E-2\r\n")]  # fmt: skip
    with scripted(KepcoBop, wire) as supply:
        supply.set_current(0.1)


def test_a_real_card_pads_its_name() -> None:
    said = b"KEPCO,BIT 4886 36-12  08-04-2023,H249977,4.04-1.82\r\n"
    with scripted(KepcoBop, [(b"*IDN?\n", said), OK]) as supply:
        who = supply.identify()
    assert (who.model, who.serial, who.firmware) == ("BIT 4886 36-12 08-04-2023", "H249977", "4.04-1.82")


@pytest.mark.parametrize("echoes", [False, True])
def test_the_emulated_supply_does_nothing_until_it_is_under_remote_control(echoes: bool) -> None:
    clock, lab = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), open_twin({}, 1)
    emulator = KepcoEmulator(lab, {"coil-x": {}}, Settings())
    emulator.echoes = echoes
    link = EmulatedLink("emulated://x", emulator, clock)
    local, remote = KepcoBop("x", link, clock, Settings(remote=False)), KepcoBop("x", link, clock, Settings())
    with pytest.raises(InstrumentError, match="Settings conflict"):
        local.set_current(0.5)
    remote.set_current(0.5)


def test_in_echo_mode_a_changed_character_is_a_fault() -> None:
    ask, echoes = b"MEAS:CURR?\n", "emulated://bop?echo=1"
    with scripted(KepcoBop, [(ask, [b"MEAS:", b"CURR?\n", b"0.4990\n"])], link=echoes) as supply:
        assert supply.measure_current() == 0.499
    with (
        scripted(KepcoBop, [(ask, b"MEAS:CUR2?\n0.4990\n")], link=echoes) as supply,
        pytest.raises(InstrumentError, match="came back"),
    ):
        supply.measure_current()


@pytest.mark.parametrize(
    ("reply", "fault"),
    [
        (SILENT, "silent"),
        (b"0.49", "silent"),
        (b"\xff\x00?\n", "wrong reply"),
        (b"\x15\n", "refused"),
        (UNPLUGGED, "link lost"),
    ],
)
def test_silence_half_a_reply_noise_overrun_and_unplug_are_named(reply: bytes | str | None, fault: str) -> None:
    with scripted(KepcoBop, [(b"MEAS:CURR?\n", reply)]) as supply, pytest.raises(InstrumentError) as caught:
        supply.measure_current()
    assert caught.value.fault == fault


def test_another_maker_is_refused() -> None:
    with scripted(KepcoBop, [(b"*IDN?\n", b"RIGOL,DP832,1,2\n")]) as supply, pytest.raises(InstrumentError) as caught:
        supply.identify()
    assert caught.value.fault == "another instrument"


def test_zero_is_reported_as_not_open() -> None:
    clock, lab = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), open_twin({}, 1)
    emulator = KepcoEmulator(lab, {"coil-x": {}}, Settings())
    supply = KepcoBop("x", EmulatedLink("emulated://x", emulator, clock), clock, Settings())
    supply.output(True)
    supply.set_current(-2.0)
    clock.wait_until(clock.now() + 1.0)
    assert supply.measure_current() == pytest.approx(-2.0, abs=0.01)
    assert to_zero({"x": supply}, {"x": 4.0}, clock)["x"].words == "zero, not open"
    assert lab.coils["x"].current.now(clock.now() + 1.0) == pytest.approx(0.0, abs=1e-3)


def test_a_current_that_comes_where_errors_were_asked_for_is_no_refusal() -> None:
    wire = [(b"MEAS:CURR?\n", b"0.0013\n"), *REMOTE, (b"OUTP 0\n", SILENT), (b"SYST:ERR?\n", b"-0.0004\n")]
    with scripted(KepcoBop, wire) as supply:
        supply.measure_current()
        with pytest.raises(InstrumentError, match=r"an answer of an earlier question came to 'SYST:ERR\?': '-0\.0004'"):
            supply.output(False)
