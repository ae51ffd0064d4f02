"""The emulators' side of real lines: it sleeps until something is to be carried."""

from __future__ import annotations

import math
import os
import select
import socket
import sys
import threading
from contextlib import suppress
from importlib.metadata import entry_points
from typing import Any, get_type_hints
from urllib.parse import urlsplit

import pytest
import serial
from served_lab import LONG_S, Stop, until

from drivers.ea_ps2000b import Settings as EaSettings
from labcal.bench.clock import RealClock
from labcal.bench.serve import PtyOutlet, TcpOutlet, _pump, baud_of, outlet_of
from labcal.twin import open_twin

if sys.platform != "win32":
    import termios

DELAY_S = 0.3


class Late:
    """Answers what it is told after a while; `looks` counts how often it was looked at."""

    def __init__(self) -> None:
        self._reply: tuple[float, bytes] | None = None
        self.looks = 0

    def take(self, t_s: float, data: bytes) -> None:
        self._reply = t_s + DELAY_S, data

    def due_s(self) -> float:
        return self._reply[0] if self._reply else math.inf

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        self.looks += 1
        if self.due_s() > until_s:
            return []
        reply, self._reply = self._reply, None
        return [reply] if reply else []


class Unforeseeing:
    """Speaks at the tenth look after somebody spoke, and does not know when that will be."""

    def __init__(self) -> None:
        self._left = math.inf

    def take(self, t_s: float, data: bytes) -> None:
        self._left = 10.0

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        self._left -= 1
        return [(until_s, b"!")] if self._left == 0 else []


def answered(emulator: Any) -> bytes:
    """What the emulator, served on a TCP port, answers a host that then goes away."""
    outlet, stop = TcpOutlet("tcp"), Stop()

    def serve() -> None:
        with suppress(InterruptedError):
            _pump([(outlet, emulator), (stop, stop)], RealClock())

    thread = threading.Thread(target=serve, daemon=True)
    thread.start()
    with socket.create_connection(("127.0.0.1", urlsplit(outlet.url).port or 0), LONG_S) as host:
        host.sendall(b"?")
        reply = host.recv(1)
    until(lambda: len(outlet.files()) == 1)
    stop.pull()
    thread.join()
    outlet.close()
    return reply


def test_one_that_does_not_foresee_its_bytes_is_looked_at_again_and_again() -> None:
    assert answered(Unforeseeing()) == b"!"


def test_it_looks_at_an_emulator_only_when_something_is_due() -> None:
    emulator = Late()
    assert answered(emulator) == b"?"
    assert emulator.looks <= 8  # begun, a host, its word, the reply, the host gone, the end; it may wake too early


def host_on(outlet: PtyOutlet, **line: Any) -> serial.Serial:
    """A program's own way to the line."""
    return serial.Serial(urlsplit(outlet.url).path, timeout=0, **line)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
@pytest.mark.parametrize("wrong", [{"baudrate": 115200}, {"baudrate": 9600}, {"baudrate": 38400}])
def test_a_host_with_another_baud_rate_or_frame_is_not_heard_and_hears_nothing(wrong: dict[str, Any]) -> None:
    outlet = PtyOutlet("serial", 19200)
    assert outlet.url.endswith("?baud=19200")
    for line, right in ((wrong, False), ({"baudrate": 19200}, True), ({"baudrate": 19200, "stopbits": 2}, True)):
        with host_on(outlet, **line) as host:
            host.write(b"who?\n")
            select.select(outlet.files(), [], [], LONG_S)
            assert outlet.read() == (b"who?\n" if right else b"")
            outlet.write(b"I\n")
            assert bool(select.select([host], [], [], LONG_S if right else 0)[0]) == right
    outlet.close()


@pytest.mark.skipif(sys.platform != "linux", reason="what a terminal keeps of a parity is Linux's")
def test_odd_parity_is_told_by_the_terminal_and_not_heard() -> None:
    outlet = PtyOutlet("serial", 19200)
    host = os.open(urlsplit(outlet.url).path, os.O_RDWR | os.O_NOCTTY)
    state = termios.tcgetattr(host)
    state[2] |= termios.PARENB | termios.PARODD
    termios.tcsetattr(host, termios.TCSANOW, state)
    os.write(host, b"who?\n")
    select.select(outlet.files(), [], [], LONG_S)
    assert outlet.read() == b""
    os.close(host)
    outlet.close()


@pytest.mark.skipif(sys.platform != "linux", reason="what a terminal keeps of a parity is Linux's")
def test_one_on_its_own_usb_port_hears_whatever_the_line_is_set_to() -> None:
    emulator = next(iter(entry_points(group="labcal.emulators", name="ea-ps2000b"))).load()
    outlet = outlet_of(emulator(open_twin({}, 1), {"coil-x": {}}, EaSettings()), modbus=False)
    assert isinstance(outlet, PtyOutlet)
    for line in ({"parity": "O"}, {"parity": "N"}, {"baudrate": 9600}):
        with host_on(outlet, **{"baudrate": 115_200, **line}) as host:
            host.write(b"who?\n")
            select.select(outlet.files(), [], [], LONG_S)
            assert outlet.read() == b"who?\n"
    outlet.close()


def test_each_emulated_instrument_is_served_at_its_own_rate() -> None:
    bauds = {"hmr2300": 9600, "zaber": 115200, "newport-esp301": 19200, "newport-smc100": 57600, "korad-ka3005p": 9600,
             "kepco-bop": 9600, "riden-rd60xx": 115200, "waveshare-relay": 9600}  # fmt: skip
    twin = open_twin({}, 1)
    for name, baud in bauds.items():
        driver = next(iter(entry_points(group="labcal.drivers", name=name))).load()
        emulator = next(iter(entry_points(group="labcal.emulators", name=name))).load()
        settings = get_type_hints(driver.__init__)["settings"]()
        assert baud_of(emulator(twin, {"coil-x": {}}, settings)) == baud, name


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
def test_what_is_said_while_nobody_reads_a_full_line_is_lost() -> None:
    outlet = PtyOutlet("serial")
    while not outlet.full():
        outlet.write(b"old\n" * 20)
    outlet.write(b"unheard\n")
    host = os.open(urlsplit(outlet.url).path, os.O_RDWR | os.O_NOCTTY)
    heard = os.read(host, 4096)
    while outlet.full():
        heard += os.read(host, 4096)
    outlet.write(b"new\n")
    while not heard.endswith(b"new\n"):
        heard += os.read(host, 4096)
    os.close(host)
    outlet.close()
    assert b"unheard" not in heard


def test_what_a_host_said_before_it_went_is_heard_before_the_next() -> None:
    """Some programs make a connection for each message."""
    outlet, heard = TcpOutlet("tcp"), list[bytes]()
    there = ("127.0.0.1", urlsplit(outlet.url).port or 0)

    def both() -> bool:
        heard.append(outlet.read())
        return b"".join(heard).endswith(b"CURR?\n")

    with socket.create_connection(there) as host:
        until(lambda: outlet.read() == b"" and len(outlet.files()) == 2)
        host.sendall(b"CURR 1\n")
    with socket.create_connection(there) as host:
        host.sendall(b"CURR?\n")
        until(both)
    assert b"".join(heard) == b"CURR 1\nCURR?\n"
    outlet.close()
