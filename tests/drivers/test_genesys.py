"""A Genesys in its manual's bytes: addressed, acknowledged, refused by number; several on one line."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from drivers.emulators.genesys import FOLDBACK, GenesysEmulator
from drivers.genesys import GenesysSupply, Settings
from labcal.bench.clock import VirtualClock
from labcal.bench.driver_kit.testing import SILENT, Exchange, scripted
from labcal.bench.links import EmulatedLink, SharedWire
from labcal.errors import InstrumentError
from labcal.twin import open_twin

ADR: Exchange = (b"ADR 6\r", b"OK\r")
REM: Exchange = (b"RMT REM\r", b"OK\r")


def told(text: bytes, reply: bytes = b"OK") -> list[Exchange]:
    return [ADR, REM, (text + b"\r", reply + b"\r")]


def test_who_it_is() -> None:
    wire = [ADR, (b"IDN?\r", b"LAMBDA,GEN40-38\r"), (b"SN?\r", b"19K5512A\r"), (b"REV?\r", b"REV:1U:4.3\r")]
    with scripted(GenesysSupply, wire) as supply:
        who = supply.identify()
    assert (who.manufacturer, who.model, who.serial, who.firmware) == ("TDK-Lambda", "GEN40-38", "19K5512A", "1U:4.3")


@pytest.mark.parametrize(
    ("said", "why"),
    [(b"LAMBDA,GEN600-1.3", "it delivers 1.3 A, and 3 A are stated"), (b"LAMBDA, GEN6-100", "it delivers 6 V"),
     (b"Agilent Technologies,N5741A,US1,A", "not a Genesys")],
)  # fmt: skip
def test_another_is_refused(said: bytes, why: str) -> None:
    with scripted(GenesysSupply, [ADR, (b"IDN?\r", said + b"\r")]) as supply:
        with pytest.raises(InstrumentError, match=why) as caught:
            supply.identify()
        assert caught.value.fault == ("another instrument" if b"Agilent" in said else "wrong set-up")


def test_nobody_at_its_address_is_silence() -> None:
    with scripted(GenesysSupply, [ADR, (b"IDN?\r", SILENT)]) as supply, pytest.raises(InstrumentError) as caught:
        supply.identify()
    assert caught.value.fault == "silent"


def test_a_set_is_acknowledged_and_read_back_as_it_was_told() -> None:
    with scripted(GenesysSupply, [*told(b"PC 1.2500"), (b"PC?\r", b"1.2500\r")]) as supply:
        supply.set_current(1.25)


def test_what_it_refuses_is_said_in_words() -> None:
    wire = [*told(b"FLD 0"), (b"FLD?\r", b"OFF\r"), *told(b"AST 0"), (b"AST?\r", b"OFF\r"), *told(b"PV 20.000", b"E01")]
    with scripted(GenesysSupply, wire) as supply:
        with pytest.raises(InstrumentError, match="E01: the voltage is above its range, or above 95 %") as caught:
            supply.output(True)
        assert caught.value.fault == "refused"


def test_a_call_for_service_is_no_answer() -> None:
    with scripted(GenesysSupply, [ADR, (b"MC?\r", b"!06\r0.4990\r")]) as supply:
        assert supply.measure_current() == 0.499


def test_answers_that_nobody_waited_for_are_no_later_answer() -> None:
    wire = [(b"ADR 6\r", b"OK\r"), (b"RMT REM\r", b"OK\r"), (b"PC 0.0000\r", [b"", b"", b"", b"OK\r"]),
            ADR, (b"MC?\r", b"0.0010\r")]  # fmt: skip
    with scripted(GenesysSupply, wire) as supply:
        supply.write_current(0.0)
        assert supply.measure_current() == 0.001


@pytest.mark.parametrize(
    ("faults", "kind"), [(b"08", "foldback"), (b"10", "over-voltage"), (b"A0", "Shut Off and Enab")]
)
def test_a_trip_is_named(faults: bytes, kind: str) -> None:
    wire = [*told(b"PC 1.0000"), (b"PC?\r", b"1.0000\r"), (b"MC?\r", b"0.0000\r"), (b"FLT?\r", faults + b"\r")]
    with scripted(GenesysSupply, wire) as supply:
        supply.set_current(1.0)
        with pytest.raises(InstrumentError, match=f"its {kind}") as caught:
            supply.measure_current()
    assert caught.value.fault == "tripped"


def test_two_on_one_line_each_hear_their_own_and_foldback_is_switched_off_before_a_current_flows() -> None:
    lab, clock = open_twin({}, 1), VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    settings = {name: Settings(address=number) for name, number in (("x", 6), ("y", 7))}
    ends = {name: GenesysEmulator(lab, {f"coil-{name}": {}}, one) for name, one in settings.items()}
    line = EmulatedLink("emulated://pair", SharedWire(list(ends.values())), clock)
    supplies = {name: GenesysSupply(name, line, clock, one) for name, one in settings.items()}
    ends["x"]._on["FLD"] = True  # by a user before us
    for supply in supplies.values():
        supply.identify()
        supply.output(True)
    supplies["x"].set_current(1.0)
    supplies["y"].set_current(2.0)
    clock.wait_until(clock.now() + 3.0)
    assert [round(supply.measure_current(), 2) for supply in supplies.values()] == [1.0, 2.0]
    ends["x"].trip(clock.now(), FOLDBACK)
    clock.wait_until(clock.now() + 3.0)
    with pytest.raises(InstrumentError, match="its foldback protection tripped"):
        supplies["x"].measure_current()
    for supply in supplies.values():
        supply.make_safe()
    assert [supply.set_point() for supply in supplies.values()] == [0.0, 0.0]
    assert [end._on["OUT"] for end in ends.values()] == [False, False]
