"""EA 9000: percent of nominal, remote control from this line, and the frames of the facts."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime

import pytest
from frames import read, rtu, wrote

from drivers.ea_9000 import EaSupply, Settings
from drivers.emulators.ea_9000 import EaEmulator
from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.links import EmulatedLink, open_link
from labcal.bench.links.modbus import ModbusLink, modbus_link
from labcal.bench.testing import scripted
from labcal.errors import InstrumentError, LimitError
from labcal.twin import open_twin

REMOTE_ON = bytes.fromhex("00050192FF002DFA")
REMOTE, BY_USB = (REMOTE_ON, REMOTE_ON), read("0003 01F9 0002", [0, 0x0803])
HALF = round(0.5 / 60 * 52428)


def text(address: int, words: str) -> tuple[bytes, bytes]:
    padded = words.encode().ljust(40, b"\0")
    return read(f"0003 {address:04X} 0014", [int.from_bytes(padded[k : k + 2]) for k in range(0, 40, 2)])


def known(model: str = "PSI 9080-60 T", amps: str = "4270") -> list[tuple[bytes, bytes]]:
    nominal = read("0003 0079 0004", [0x42A0, 0, int(amps, 16), 0])  # 80.0 V, 60.0 A as IEEE 754
    return [text(1, model), text(21, "EA Elektro-Automatik"), text(151, "2850530001"), nominal]


def test_the_frames_of_the_tests_are_those_of_the_facts() -> None:
    assert rtu("0005 0192 FF00") == REMOTE_ON
    assert rtu("0003 01FB 0003") == bytes.fromhex("000301FB00037417")


def test_type_serial_and_nominal_values_are_read() -> None:
    with scripted(EaSupply, known()) as supply:
        who = supply.identify()
        assert supply.counts == (52428 / 80, 52428 / 60)
    assert (who.manufacturer, who.model, who.serial) == ("EA Elektro-Automatik", "PSI 9080-60 T", "2850530001")


@pytest.mark.parametrize(("model", "amps"), [("PSI 9080-120 T", "4270"), ("DP832", "4270"), ("PSI 9080-60 T", "7FC0")])
def test_a_type_that_contradicts_its_nominal_current_is_not_trusted(model: str, amps: str) -> None:
    with scripted(EaSupply, known(model, amps)) as supply, pytest.raises(InstrumentError) as caught:
        supply.identify()
    assert caught.value.fault == "another instrument"


def test_a_current_is_a_fraction_of_nominal_set_under_remote_control() -> None:
    wire = [*known(), REMOTE, BY_USB, wrote(f"0006 01F5 {HALF:04X}"), read("0003 01F5 0001", [HALF])]
    with scripted(EaSupply, wire) as supply:
        supply.set_current(0.5)


@pytest.mark.parametrize("state", [0x0806, 0x0003, 0x0001, 0x0804])
def test_control_by_another_interface_is_refused(state: int) -> None:
    wire = [*known(), REMOTE, read("0003 01F9 0002", [0, state])]
    with scripted(EaSupply, wire) as supply, pytest.raises(InstrumentError, match="not from here") as caught:
        supply.set_current(0.5)
    assert caught.value.fault == "wrong mode"


def test_local_mode_is_said_with_its_remedy() -> None:
    with (
        scripted(EaSupply, [*known(), (REMOTE_ON, rtu("0085 17"))]) as supply,
        pytest.raises(InstrumentError, match=r"exception 23.*LOCAL") as caught,
    ):
        supply.set_current(0.5)
    assert caught.value.fault == "refused"


@pytest.mark.parametrize("amps", [3.01, -0.01, float("nan")])
def test_beyond_the_limit_nothing_is_sent(amps: float) -> None:
    with scripted(EaSupply, []) as supply, pytest.raises(LimitError, match="nothing was sent"):
        supply.set_current(amps)


def test_more_than_102_percent_of_nominal_is_refused() -> None:
    with scripted(EaSupply, known(), max_current_A=70.0) as supply, pytest.raises(LimitError, match=r"61\.2"):
        supply.set_current(61.3)


def test_a_read_back_that_differs_is_a_fault() -> None:
    wire = [*known(), REMOTE, BY_USB, wrote(f"0006 01F5 {HALF:04X}"), read("0003 01F5 0001", [HALF - 1])]
    with scripted(EaSupply, wire) as supply, pytest.raises(InstrumentError) as caught:
        supply.set_current(0.5)
    assert caught.value.fault == "read-back"


def test_the_late_echo_of_a_write_is_no_reply_to_a_read() -> None:
    wire = [(rtu("0003 01F5 0001"), rtu("0006 01F5 0100")), read("0003 01F5 0001", [HALF])]
    with scripted(EaSupply, [*known(), *wire]) as supply:
        supply.identify()
        with pytest.raises(InstrumentError) as caught:
            supply.set_point()
        assert caught.value.fault == "wrong reply"
        assert supply.set_point() == pytest.approx(0.5, abs=0.001)


@pytest.mark.parametrize("address", [0, 503, 498, 9000, 10000])
def test_other_registers_cannot_be_written(address: int) -> None:
    with scripted(EaSupply, [*known(), REMOTE, BY_USB]) as supply:
        supply.identify()
        with pytest.raises(InstrumentError) as caught:
            supply.registers.write(address, 1)
    assert caught.value.fault == "forbidden"


@contextmanager
def emulated(settings: Settings = Settings()) -> Iterator[tuple[EaSupply, EaEmulator]]:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    emulator = EaEmulator(open_twin({}, 1), {"coil-x": {}}, settings)
    link = ModbusLink(EmulatedLink("emulated://x", emulator, clock), clock)
    yield EaSupply("x", link, clock, settings), emulator


def test_an_alarm_under_current_is_a_trip_and_bars_the_next_start_but_not_zero() -> None:
    with emulated() as (supply, emulator):
        supply.output(True)
        supply.set_current(1.0)
        emulator.alarm = True
        with pytest.raises(InstrumentError) as caught:
            supply.measure_current()
        assert caught.value.fault == "tripped"
        supply.set_current(0.0)
        supply.measure_current()
        supply.output(False)
        with pytest.raises(InstrumentError, match="alarm"):
            supply.output(True)


def test_made_safe_it_is_given_back_to_its_panel() -> None:
    with emulated() as (supply, emulator):
        supply.output(True)
        supply.make_safe()
        assert emulator._bits == {402: False, 405: False}
        emulator.local = True
        with pytest.raises(InstrumentError, match="LOCAL"):
            supply.output(True)


def test_interface_monitoring_that_was_not_fed_is_named_and_zero_is_still_obeyed() -> None:
    with emulated(Settings(watchdog_s=5)) as (supply, emulator):
        supply.output(True)
        supply.set_current(1.0)
        clock = supply.registers._clock
        for _ in range(4):
            clock.wait_until(clock.now() + 3.0)
            supply.feed()
        clock.wait_until(clock.now() + 6.0)
        with pytest.raises(InstrumentError, match="has left remote control") as caught:
            supply.feed()
        assert caught.value.fault == "tripped"
        supply.set_current(0.0)
        assert supply.set_point() == 0.0
        assert emulator._bits[405] is False


def test_what_is_not_seen_off_is_not_given_back_to_its_panel() -> None:
    zero = [wrote("0006 01F5 0000"), read("0003 01F5 0001", [0])]
    still_on = [wrote("0005 0195 0000"), read("0003 01F9 0002", [0, 0x0883])]
    with (
        scripted(EaSupply, [*known(), REMOTE, BY_USB, *zero, *still_on]) as supply,
        pytest.raises(InstrumentError, match="did not go off"),
    ):
        supply.make_safe()


def test_rtu_frames_over_a_real_tcp_socket() -> None:
    server = socket.create_server(("127.0.0.1", 0))
    emulator = EaEmulator(open_twin({}, 1), {"coil-x": {}}, Settings(location=6))

    def serve() -> None:
        host, _ = server.accept()
        with host, suppress(ConnectionError):  # the other side may close with a reply unread
            while data := host.recv(256):
                emulator.take(0.0, data)
                host.sendall(b"".join(piece for _, piece in emulator.emit(1e9)))

    thread = threading.Thread(target=serve, daemon=True)
    thread.start()
    clock = RealClock()
    with server:
        line = open_link(f"modbus-rtu://socket://127.0.0.1:{server.getsockname()[1]}?timeout_ms=60000", clock)
        supply = EaSupply("x", modbus_link(line, clock), clock, Settings(location=6, gap_s=0.0))
        assert supply.identify().model == "PSI 9080-60 T"
        supply.set_current(0.5)
        assert supply.set_point() == pytest.approx(0.5, abs=0.001)
        supply.close()
        thread.join()
