"""The emulators' side of real lines: it sleeps until something is to be carried."""

from __future__ import annotations

import math
import os
import socket
import sys
import threading
from contextlib import suppress
from typing import Any
from urllib.parse import urlsplit

import pytest
from served_lab import LONG_S, Stop, until

from labcal.bench.clock import RealClock
from labcal.bench.serve import PtyOutlet, TcpOutlet, _pump

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
