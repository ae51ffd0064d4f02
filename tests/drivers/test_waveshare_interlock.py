"""A relay as interlock: pulses and no more, each asked for only while the contact is closed."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest
from frames import read, rtu, wrote
from pydantic import TypeAdapter, ValidationError

from drivers.emulators.waveshare_interlock import InterlockEmulator
from drivers.waveshare_interlock import Settings, WaveshareInterlock
from labcal.bench.clock import VirtualClock
from labcal.bench.links import EmulatedLink
from labcal.bench.links.modbus import ModbusLink
from labcal.bench.testing import SILENT, scripted
from labcal.errors import InstrumentError
from labcal.twin import open_twin

SECOND, HOLD, OFF = (wrote(f"0105 {rest}") for rest in ("0202 000A", "0202 001E", "0002 0000"))
ASK = rtu("0101 0002 0001")
CLOSED, OPEN = (ASK, rtu("0101 0101")), (ASK, rtu("0101 0100"))
PROVED = [OFF, OPEN, SECOND, SECOND, CLOSED, OPEN]
ARMED = [*PROVED, HOLD, CLOSED]


def test_the_frame_of_the_tests_is_that_of_the_wiki() -> None:
    assert rtu("0105 0200 0007") == bytes.fromhex("0105020000078DB0")


def test_it_is_proved_then_closed_for_as_long_as_is_stated_then_prolonged_and_opened() -> None:
    with scripted(WaveshareInterlock, [*ARMED, CLOSED, HOLD, OFF, OPEN], relay=2) as interlock:
        interlock.arm()
        interlock.feed()
        interlock.disarm()


def test_a_contact_that_is_found_open_is_not_closed_again() -> None:
    with scripted(WaveshareInterlock, [*ARMED, OPEN], relay=2) as interlock:
        interlock.arm()
        with pytest.raises(InstrumentError, match="opened by itself") as caught:
            interlock.feed()
        with pytest.raises(InstrumentError, match="falls open"):
            interlock.feed()
    assert caught.value.fault == "interlock"


def test_a_beat_that_would_come_too_late_is_not_sent_though_the_contact_was_seen_closed() -> None:
    with scripted(WaveshareInterlock, [*ARMED, CLOSED], relay=2) as interlock:
        interlock.arm()
        interlock._clock.wait_until(interlock._ends_s - 0.15)
        with pytest.raises(InstrumentError, match="falls open"):
            interlock.feed()


def test_a_beat_without_an_answer_is_a_fault_and_is_not_repeated() -> None:
    with scripted(WaveshareInterlock, [*ARMED, CLOSED, (HOLD[0], SILENT)], relay=2) as interlock:
        interlock.arm()
        with pytest.raises(InstrumentError) as caught:
            interlock.feed()
    assert caught.value.fault == "silent"


def test_a_contact_that_does_not_close_or_open_is_a_fault() -> None:
    with (
        scripted(WaveshareInterlock, [*PROVED, HOLD, OPEN], relay=2) as interlock,
        pytest.raises(InstrumentError, match="does not close"),
    ):
        interlock.arm()
    with (
        scripted(WaveshareInterlock, [OFF, CLOSED], relay=2) as interlock,
        pytest.raises(InstrumentError, match="does not open"),
    ):
        interlock.disarm()


def test_made_safe_before_it_was_armed_nothing_is_sent() -> None:
    with scripted(WaveshareInterlock, []) as interlock:
        interlock.make_safe()


def test_an_old_firmware_is_another_instrument() -> None:
    wire = [read("0103 8000 0001", [100])]
    with scripted(WaveshareInterlock, wire) as interlock, pytest.raises(InstrumentError) as caught:
        interlock.identify()
    assert caught.value.fault == "another instrument"


@pytest.mark.parametrize("stated", [{"watchdog_s": 1.9}, {"watchdog_s": 61}, {"relay": 32}, {"relay": -1}])
def test_what_the_board_cannot_do_is_refused_when_it_is_stated(stated: dict[str, float]) -> None:
    with pytest.raises(ValidationError):
        TypeAdapter(Settings).validate_python(stated)


@pytest.mark.parametrize(
    ("fault", "says"),
    [({"retriggers": False}, "although it is heard in time"), ({"endless": True}, "does not fall open by itself")],
)
def test_a_board_whose_pulses_cannot_hold_a_heartbeat_is_found_out_before_it_is_armed(
    fault: dict[str, bool], says: str
) -> None:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    emulator = InterlockEmulator(open_twin({}, 1), {"interlock": {}}, Settings())
    for name, value in fault.items():
        setattr(emulator, name, value)
    interlock = WaveshareInterlock("guard", ModbusLink(EmulatedLink("emulated://", emulator, clock), clock), clock,
                                   Settings())  # fmt: skip
    with pytest.raises(InstrumentError, match=says) as caught:
        interlock.arm()
    assert caught.value.fault == "interlock"
    with pytest.raises(InstrumentError):
        interlock.feed()
