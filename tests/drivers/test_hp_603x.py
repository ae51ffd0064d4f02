"""An HP 603x in its own bytes: words before numbers, an error register by number, foldback, trips."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from drivers.emulators.hp_603x import FOLDBACK, OVER_VOLTAGE, Hp603xEmulator
from drivers.hp_603x import Hp603x, Settings
from labcal.bench.clock import VirtualClock
from labcal.bench.driver_kit.testing import SILENT, Exchange, scripted
from labcal.bench.links import EmulatedLink
from labcal.errors import InstrumentError, LimitError
from labcal.twin import open_twin

FINE: Exchange = (b"ERR?\n", b"ERR 0\r\n")


def told(text: bytes, error: bytes = b"ERR 0") -> list[Exchange]:
    return [(text + b"\n", None), (b"ERR?\n", error + b"\r\n")]


def emulated(model: str = "6038A") -> tuple[Hp603x, Hp603xEmulator, VirtualClock]:
    lab, clock = open_twin({}, 1), VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    settings = Settings(model=model)
    end = Hp603xEmulator(lab, {"coil-x": {}}, settings)
    return Hp603x("x", EmulatedLink("emulated://x", end, clock), clock, settings), end, clock


def test_who_it_is_as_a_lab_recorded_it() -> None:
    with scripted(Hp603x, [(b"ID?\n", b"ID HP6032A\r\n"), FINE], model="6032A") as supply:
        who = supply.identify()
    assert (who.manufacturer, who.model) == ("HP", "6032A")


@pytest.mark.parametrize("said", [b"ID HP6033A\r\n", b"HEWLETT-PACKARD,6632B,0,A.02.04\r\n", b"HP6624A\r\n"])
def test_another_is_refused(said: bytes) -> None:
    with (
        scripted(Hp603x, [(b"ID?\n", said)]) as supply,
        pytest.raises(InstrumentError, match="not an HP 6038A") as caught,
    ):
        supply.identify()
    assert caught.value.fault == ("wrong set-up" if said == b"ID HP6033A\r\n" else "another instrument")


def test_one_that_does_not_know_the_question_is_silent() -> None:
    with scripted(Hp603x, [(b"ID?\n", SILENT)]) as supply, pytest.raises(InstrumentError) as caught:
        supply.identify()
    assert caught.value.fault == "silent"


@pytest.mark.parametrize("held", [b"ISET 1.2498\r\n", b"ISET   1.25\r\n", b"ISET  1.2525\r\n"])
def test_a_set_point_comes_back_as_the_nearest_of_its_steps(held: bytes) -> None:
    with scripted(Hp603x, [*told(b"ISET 1.2500"), (b"ISET?\n", held)]) as supply:
        supply.set_current(1.25)


def test_a_set_point_two_steps_away_is_another() -> None:
    wire = [*told(b"ISET 1.2500"), (b"ISET?\n", b"ISET 1.2560\r\n")]
    with scripted(Hp603x, wire) as supply, pytest.raises(InstrumentError, match=r"reads back 1\.256 A") as caught:
        supply.set_current(1.25)
    assert caught.value.fault == "read-back"


def test_its_error_register_is_a_refusal_and_a_limit_of_ours_sends_nothing() -> None:
    with scripted(Hp603x, told(b"ISET 1.2500", b"ERR 6")) as supply:
        with pytest.raises(InstrumentError, match="it does not go beyond its soft limits") as caught:
            supply.set_current(1.25)
        assert caught.value.fault == "refused"
        with pytest.raises(LimitError):
            supply.set_current(3.1)


def test_foldback_is_switched_off_before_the_output_goes_on() -> None:
    wire = [*told(b"FOLD 0"), (b"FOLD?\n", b"FOLD 0\r\n"), *told(b"VSET 20.0000"), (b"VSET?\n", b"VSET 19.995\r\n"),
            *told(b"OUT 1"), (b"OUT?\n", b"OUT 1\r\n")]  # fmt: skip
    with scripted(Hp603x, wire) as supply:
        supply.output(True)


@pytest.mark.parametrize(("status", "kind"), [(b"8", "over-voltage"), (b"272", "over-temperature and remote inhibit")])
def test_a_trip_is_named(status: bytes, kind: str) -> None:
    wire = [*told(b"ISET 1.0000"), (b"ISET?\n", b"ISET 1.0000\r\n"), (b"IOUT?\n", b"IOUT 0.0000\r\n"),
            (b"STS?\n", b"STS " + status + b"\r\n")]  # fmt: skip
    with scripted(Hp603x, wire) as supply:
        supply.set_current(1.0)
        with pytest.raises(InstrumentError, match=f"its {kind} protection tripped"):
            supply.measure_current()


def test_what_no_model_delivers_is_refused_in_the_bench_file() -> None:
    with pytest.raises(ValueError, match="max_current_A must be at most 5 A, which is all that a 6035A delivers"):
        Settings(model="6035A", max_current_A=6.0)
    with pytest.raises(ValueError, match="model must be one of 6030A"):
        Settings(model="6632B")


def test_a_current_flows_whatever_foldback_was_before_us_and_a_trip_is_named_and_bars_no_zero() -> None:
    supply, end, clock = emulated()
    end._states["FOLD"] = "2"  # by a user before us: a constant current is a fault
    supply.identify()
    supply.output(True)
    supply.set_current(1.0)
    clock.wait_until(clock.now() + 3.0)
    assert supply.measure_current() == pytest.approx(1.0, abs=0.005)
    end.trip(clock.now(), OVER_VOLTAGE | FOLDBACK)
    clock.wait_until(clock.now() + 3.0)
    with pytest.raises(InstrumentError, match="its over-voltage and foldback protection tripped"):
        supply.measure_current()
    supply.make_safe()
    assert supply.set_point() == 0.0
    assert end._states["OUT"] == "0"
