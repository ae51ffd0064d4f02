"""A fluxgate on a LabJack T7: registers as its map has them, and over Modbus TCP."""

from __future__ import annotations

import struct
import threading
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from typing import Any

import numpy as np
import pytest
from frames import read, rtu
from pydantic import TypeAdapter, ValidationError

from drivers.emulators.labjack_t7 import LabJackEmulator
from drivers.emulators.modbus_tcp import NetworkPort
from drivers.labjack_t7 import LabJackT7, Settings
from labcal.bench.clock import RealClock
from labcal.bench.driver_kit.testing import Exchange, scripted
from labcal.bench.links import open_link
from labcal.bench.links.modbus import modbus_link
from labcal.bench.serve import outlet_of
from labcal.errors import InstrumentError
from labcal.testing.drivers import installed
from labcal.twin import open_twin

SCALE: dict[str, Any] = {"uT_per_V": (10.0, 10.0, -10.0), "zero_V": (0.0, 0.25, 0.0)}
WHO = [
    read("0103 EA60 0002", [0x40E0, 0]),  # 7.0
    read("0103 EA64 0002", [0x3F84, 0xAF4F]),  # 1.0366
    read("0103 EA7C 0002", [7, 0x4722]),
]


def floats(*volts: float) -> list[int]:
    return list(struct.unpack(f">{2 * len(volts)}H", struct.pack(f">{len(volts)}f", *volts)))


def polled(driver: Any) -> Any:
    driver._polls.start()
    (block,) = driver.read_until(driver._polls._next_s)
    return block


def test_who_it_is() -> None:
    with scripted(LabJackT7, WHO, serial="MAG-03 2741", **SCALE) as driver:
        who = driver.identify()
    assert (who.manufacturer, who.model, who.serial, who.firmware) == ("LabJack", "T7", "476962 MAG-03 2741", "1.0366")


def test_a_t4_is_refused() -> None:
    wire = [read("0103 EA60 0002", [0x4080, 0]), WHO[1]]
    with scripted(LabJackT7, wire, **SCALE) as driver, pytest.raises(InstrumentError, match="product is 4") as caught:
        driver.identify()
    assert caught.value.fault == "another instrument"


def test_volts_become_nanotesla_by_scale_and_zero() -> None:
    with scripted(LabJackT7, [read("0103 0000 0006", floats(2.0, 0.75, -1.0))], **SCALE) as driver:
        assert polled(driver).values.tolist() == [[20_000.0, 5_000.0, 10_000.0]]


def test_inputs_apart_are_picked_out_of_one_block_in_their_order() -> None:
    wire = [read("0103 0004 000A", floats(1.0, 9.0, 2.0, 9.0, 3.0))]
    with scripted(LabJackT7, wire, uT_per_V=(1.0, 1.0, 1.0), inputs=(6, 2, 4)) as driver:
        assert polled(driver).values.tolist() == [[3000.0, 1000.0, 2000.0]]


def test_a_filter_s_delay_is_taken_off_the_stamp() -> None:
    with scripted(LabJackT7, [read("0103 0000 0006", floats(0, 0, 0))], filter_Hz=10.0, **SCALE) as driver:
        moment = driver._polls._clock.now()
        assert polled(driver).t_s[0] == pytest.approx(moment - 0.0159, abs=1e-4)


@pytest.mark.parametrize("volts", [9.95, -10.05])
def test_a_sensor_at_its_end_is_overloaded(volts: float) -> None:
    wire = [read("0103 0000 0006", floats(0, 0, volts))]
    with scripted(LabJackT7, wire, **SCALE) as driver, pytest.raises(InstrumentError) as caught:
        polled(driver)
    assert caught.value.fault == "overloaded"


@pytest.mark.parametrize("volts", [float("nan"), -9999.0])
def test_what_is_no_reading_is_noted(volts: float) -> None:
    with scripted(LabJackT7, [read("0103 0000 0006", floats(0, volts, 0))], **SCALE) as driver:
        driver._polls.start()
        assert driver.read_until(driver._polls._next_s) == []
        assert [event.data["fault"] for event in driver.events()] == ["bad frame"]


def test_a_range_that_it_does_not_take_is_a_fault() -> None:
    wire: list[Exchange] = [
        (rtu("0110 9C40 0002 04 41200000"), rtu("0110 9C40 0002")),
        read("0103 9C40 0002", [0x3F80, 0]),
    ]
    with scripted(LabJackT7, wire, **SCALE) as driver, pytest.raises(InstrumentError) as caught:
        driver.start()
    assert caught.value.fault == "read-back"


@pytest.mark.parametrize(
    ("stated", "told"),
    [
        ({}, "required"),
        ({"uT_per_V": [10, 10, 0]}, "other than zero"),
        ({"uT_per_V": [10, 10, 10], "inputs": [0, 0, 1]}, "inputs must be three"),
        ({"uT_per_V": [10, 10, 10], "differential": True}, "even where they are differential"),
        ({"uT_per_V": [10, 10, 10], "range_V": 5}, "range_V must be one of 10, 1, 0.1, 0.01"),
        ({"uT_per_V": [10, 10, 10], "inputs": [0, 1, 14]}, "less than or equal to 13"),
    ],
)
def test_settings_that_cannot_be_are_refused(stated: dict[str, Any], told: str) -> None:
    with pytest.raises(ValidationError, match=told):
        TypeAdapter(Settings).validate_python(stated)


@contextmanager
def served(emulator: LabJackEmulator) -> Iterator[str]:
    """Its network port, on a port of this computer, as `bench serve` puts it there; the link to it."""
    outlet, over = outlet_of(port := emulator.on_network(), modbus=True), threading.Event()

    def pump() -> None:
        while not over.is_set():
            if data := outlet.read():
                port.take(time.monotonic(), data)
            outlet.write(b"".join(piece for _, piece in port.emit(time.monotonic())))
            time.sleep(0.001)

    (thread := threading.Thread(target=pump, daemon=True)).start()
    yield f"{outlet.url}?timeout_ms=30000"
    over.set()
    thread.join()
    outlet.close()


def test_it_is_read_over_modbus_tcp() -> None:
    settings, clock = Settings(uT_per_V=(10.0, 10.0, 10.0), inputs=(0, 2, 4), differential=True), RealClock()
    emulator = LabJackEmulator(open_twin({}, 1), {"reference": {}}, settings)
    with served(emulator) as url, closing(open_link(url, clock)) as line:
        assert url.startswith("modbus-tcp://127.0.0.1:")
        line.never.add(LabJackT7.never, settings.address)
        driver = LabJackT7("t7", modbus_link(line, clock), clock, settings)
        assert driver.identify().serial == "476986"
        driver.start()
        blocks = driver.read_until(clock.now() + 0.5)
        with pytest.raises(InstrumentError, match="never sent"):
            modbus_link(line, clock).write_register(1, 1000, 1)  # DAC0
    assert 10_000 < np.linalg.norm(blocks[0].values[0]) < 100_000


PRODUCT = "0000 0006 {unit} 03 EA60 0002"
T7 = "0000 0007 {unit} 03 04 40E0 0000"


def port() -> NetworkPort:
    return LabJackEmulator(open_twin({}, 1), {"reference": {}}, Settings(**SCALE)).on_network()


def said(network: NetworkPort, t_s: float) -> str:
    return b"".join(piece for _, piece in network.emit(t_s + 1.0)).hex().upper()


@pytest.mark.parametrize("unit", ["01", "00", "FF"])
def test_its_network_port_answers_each_request_by_its_number_whatever_unit_is_named(unit: str) -> None:
    network = port()
    asked = bytes.fromhex("0001" + PRODUCT.format(unit=unit) + "0002" + PRODUCT.format(unit=unit))
    network.take(0.0, asked[:5])
    network.take(0.1, asked[5:])
    told = "0001" + T7.format(unit=unit) + "0002" + T7.format(unit=unit)
    assert said(network, 0.1) == told.replace(" ", "")


def test_its_network_port_refuses_by_exception_and_gets_over_what_is_no_request() -> None:
    network = port()
    network.take(0.0, bytes.fromhex("0007 0000 0006 01 06 03E8 0001"))  # DAC0
    assert said(network, 0.0) == "0007000000030186" + "01"
    for t_s, noise in enumerate((b"*IDN?\r\n" * 9, bytes.fromhex("0008 0000 0005 01 2B 0E 01 00"), b"\0\x09"), 1):
        network.take(5.0 * t_s, noise)
        assert said(network, 5.0 * t_s) == ""
    network.take(60.0, bytes.fromhex("0009" + PRODUCT.format(unit="01")))
    assert said(network, 60.0) == ("0009" + T7.format(unit="01")).replace(" ", "")


def test_a_differential_input_without_its_pair_reads_nothing_and_is_noted() -> None:
    rig = installed("labjack-t7", forbidden=[], settings={"uT_per_V": (10.0, 10.0, 10.0)}).rig()
    rig.driver.start()
    rig.emulator._kept[41001] = 5  # somebody else has set it so
    assert rig.driver.read_until(rig.clock.now() + 0.05) == []
    assert rig.driver.events()
