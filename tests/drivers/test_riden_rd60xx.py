"""Riden RD60xx: the frames of the facts, scaling by model, and what must never be written."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest
from frames import read, rtu, wrote

from drivers.emulators.riden_rd60xx import RidenEmulator
from drivers.riden_rd60xx import RidenSupply, Settings
from labcal.bench.clock import VirtualClock
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.bench.links import EmulatedLink
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError, LimitError
from labcal.twin import open_twin

STATE = bytes.fromhex("01030008000B85CF")
RD6006 = read("0103 0000 0004", [60062, 0x0001, 0x86A0, 135])


def state(set_A: int, measured_A: int, trip: int = 0) -> bytes:
    return read("0103 0008 000B", [500, set_A, 480, measured_A, 0, 230, 2400, 0, trip, 1, 1])[1]


def test_the_frames_of_the_tests_are_those_of_the_facts() -> None:
    assert rtu("0103 0008 000B") == STATE
    assert rtu("0106 0008 01F4") == bytes.fromhex("0106000801F4081F")
    assert rtu("0106 0012 0001") == bytes.fromhex("010600120001E80F")


@pytest.mark.parametrize(
    ("number", "model", "per_A"),
    [(60060, "RD6006", 1000), (60065, "RD6006P", 10000), (60121, "RD6012", 100), (60181, "RD6018", 100),
     (60241, "RD6024", 100), (60301, "RD6030", 100)],
)  # fmt: skip
def test_the_model_says_how_it_counts(number: int, model: str, per_A: int) -> None:
    wire = [read("0103 0000 0004", [number, 1, 0x86A0, 135]), wrote(f"0106 0009 {per_A // 2:04X}"),
            read("0103 0009 0001", [per_A // 2])]  # fmt: skip
    with scripted(RidenSupply, wire) as supply:
        who = supply.identify()
        supply.set_current(0.5)
    assert (who.model, who.serial, who.firmware) == (model, "00100000", "1.35")


@pytest.mark.parametrize(("current_range", "count"), [(0, 5000), (1, 500)])
def test_the_6012P_counts_by_its_current_range(current_range: int, count: int) -> None:
    wire = [read("0103 0000 0004", [60125, 0, 1, 100]), read("0103 0014 0001", [current_range]),
            wrote(f"0106 0009 {count:04X}"), read("0103 0009 0001", [count])]  # fmt: skip
    with scripted(RidenSupply, wire) as supply:
        supply.identify()
        supply.set_current(0.5)


def test_a_model_that_is_not_known_is_refused() -> None:
    with (
        scripted(RidenSupply, [read("0103 0000 0004", [5005, 0, 1, 100])]) as supply,
        pytest.raises(InstrumentError) as caught,
    ):
        supply.identify()
    assert caught.value.fault == "another instrument"


def test_a_count_is_rounded_and_not_cut() -> None:
    wire = [RD6006, wrote("0106 0009 0121"), read("0103 0009 0001", [0x0121])]
    with scripted(RidenSupply, wire) as supply:
        supply.set_current(0.289)  # 0.289 · 1000 is 288.99999999999994


@pytest.mark.parametrize("amps", [3.001, -0.001, float("nan")])
def test_beyond_the_limit_nothing_is_sent(amps: float) -> None:
    with scripted(RidenSupply, []) as supply, pytest.raises(LimitError, match="nothing was sent"):
        supply.set_current(amps)


def test_a_set_point_beyond_its_register_is_refused() -> None:
    with (
        scripted(RidenSupply, [read("0103 0000 0004", [60065, 0, 1, 100])], max_current_A=9.0) as supply,
        pytest.raises(LimitError, match=r"6\.5535 A"),
    ):
        supply.set_current(8.0)


def test_a_read_back_that_differs_by_one_count_is_a_fault() -> None:
    wire = [RD6006, wrote("0106 0009 01F4"), read("0103 0009 0001", [499])]
    with scripted(RidenSupply, wire) as supply, pytest.raises(InstrumentError) as caught:
        supply.set_current(0.5)
    assert caught.value.fault == "read-back"


def test_before_the_output_goes_on_trips_are_written_and_read_back() -> None:
    wire = [read("0103 0044 0001", [0]), RD6006,
            wrote("0106 0008 07D0"), read("0103 0008 0001", [2000]),
            wrote("0106 0052 0898"), read("0103 0052 0001", [2200]),
            wrote("0106 0053 0CE4"), read("0103 0053 0001", [3300]),
            wrote("0106 0012 0001"), read("0103 0012 0001", [1])]  # fmt: skip
    with scripted(RidenSupply, wire) as supply:
        supply.output(True)


def test_a_supply_that_would_start_by_itself_is_not_switched_on() -> None:
    with (
        scripted(RidenSupply, [read("0103 0044 0001", [1])]) as supply,
        pytest.raises(InstrumentError, match="by itself") as caught,
    ):
        supply.output(True)
    assert caught.value.fault == "wrong set-up"


def test_a_trip_is_named_but_does_not_bar_the_way_to_zero() -> None:
    wire = [(STATE, state(500, 0, trip=2)), (STATE, state(0, 0, trip=2)), RD6006]
    with scripted(RidenSupply, wire) as supply:
        with pytest.raises(InstrumentError, match="over-current") as caught:
            supply.measure_current()
        assert supply.measure_current() == 0.0
    assert caught.value.fault == "tripped"


@pytest.mark.parametrize("address", [*range(54, 63), 19, 48, 68, 80, 114, 115, 256])
def test_calibration_presets_options_and_boot_loader_cannot_be_written(address: int) -> None:
    with scripted(RidenSupply, []) as supply, pytest.raises(InstrumentError) as caught:
        supply.registers.write(address, 5633)
    assert caught.value.fault == "forbidden"


def test_the_emulated_one_answers_a_block_of_84_registers() -> None:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    emulator = RidenEmulator(open_twin({}, 1), {"coil-x": {"address": 1}}, Settings())
    link = ModbusLink(EmulatedLink("emulated://x", emulator, clock), clock)
    whole = link.read_holding(1, 0, 84)
    assert whole[0] == 60062
    assert [whole[k] for k in (3, 8, 9, 18, 82, 83)] == [link.read_holding(1, k, 1)[0] for k in (3, 8, 9, 18, 82, 83)]
    with pytest.raises(InstrumentError):
        link.read_holding(1, 100, 84)


def test_three_supplies_share_one_pair() -> None:
    clock, lab = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), open_twin({}, 1)
    roles = {f"coil-{axis}": {"address": n} for n, axis in enumerate("xyz", 1)}
    link = ModbusLink(EmulatedLink("emulated://pair", RidenEmulator(lab, roles, Settings()), clock), clock)
    supplies = [RidenSupply(axis, link, clock, Settings(address=n)) for n, axis in enumerate("xyz", 1)]
    for n, supply in enumerate(supplies, 1):
        supply.output(True)
        supply.set_current(n / 10)
    assert len({supply.identify().serial for supply in supplies}) == 3
    clock.wait_until(clock.now() + 1.0)
    assert [supply.measure_current() for supply in supplies] == pytest.approx([0.1, 0.2, 0.3], abs=0.002)


def test_a_silent_one_of_several_on_a_line_is_named_by_its_address() -> None:
    wire = [(rtu("0203 0000 0004"), SILENT)]
    says = "address 2 on emulated://script: no valid Modbus reply"
    with scripted(RidenSupply, wire, address=2) as supply, pytest.raises(InstrumentError, match=says):
        supply.identify()
