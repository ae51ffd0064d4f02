"""Lines that flood: bytes without an end, as fast as they come. One look is short, a question ends at once."""

from __future__ import annotations

import os
import pty
import select
import socket
import sys
import threading
import time
import tty
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, suppress
from typing import Any

import pytest
from served_lab import Served, Sessions, at_zero, log, until

from drivers.korad_ka3005p import KoradSupply
from drivers.korad_ka3005p import Settings as KoradSettings
from labcal.bench.clock import RealClock
from labcal.bench.guardian.gate import Gate, GatedLink
from labcal.bench.links import open_link, wired
from labcal.bench.links.line import LONGEST, wait_for_quiet
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError

LONG_S = 30.0  # a busy machine gets there
JUNK = b"\x00\xff#" * 20_000


@contextmanager
def pouring(pour: Callable[[bytes], object], junk: bytes = JUNK) -> Iterator[None]:
    """`junk` again and again, until the line is closed."""

    def run() -> None:
        with suppress(OSError):
            while not ended.is_set():
                pour(junk)

    ended, thread = threading.Event(), threading.Thread(target=run, daemon=True)
    thread.start()
    try:
        yield
    finally:
        ended.set()


@contextmanager
def tcp_line() -> Iterator[tuple[Any, socket.socket]]:
    """A TCP line, and its other side."""
    with (
        socket.create_server(("127.0.0.1", 0)) as listener,
        closing(open_link(f"tcp://127.0.0.1:{listener.getsockname()[1]}", RealClock())) as link,
        listener.accept()[0] as host,
    ):
        yield link, host


@contextmanager
def flooded(junk: bytes = JUNK) -> Iterator[Any]:
    """A TCP line whose other side sends `junk` for ever."""
    with tcp_line() as (link, host), pouring(host.sendall, junk):
        yield link


def ended(act: Callable[[], object]) -> Any:
    """What `act` raised or returned, where it ends at all."""
    out = list[Any]()

    def run() -> None:
        try:
            out.append(act())
        except InstrumentError as error:
            out.append(error)

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    thread.join(LONG_S)
    assert out, f"it does not end within {LONG_S:g} s"
    return out[0]


def test_a_question_to_a_line_that_floods_ends_with_what_it_does() -> None:
    with flooded() as link:
        error = ended(lambda: link.ask(b"*IDN?\n", end=b"\n", timeout_s=1e9))
        assert error.fault == "babbles"
        assert "more than 4 KiB came without an end" in error.what
        assert len(str(error)) < 500
        assert ended(link.flush) is None
        assert ended(lambda: wait_for_quiet(link, link._clock, 0.05)) is None


def test_one_look_at_a_line_that_floods_takes_little(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(wired, "UNREAD_BYTES", most := 4 * wired.LOOK_BYTES)
    with flooded() as link:
        until(lambda: bool(link.receive(0.0)))
        assert sum(len(data) for _, data in ended(lambda: link.receive(0.0))) < 2 * wired.LOOK_BYTES
        for _ in range(50):
            link.look()
        assert link._unread <= most + wired.LOOK_BYTES
        assert sum(len(data) for _, data in link._arrived) == link._unread


def test_what_came_in_plenty_is_read_to_its_last_byte() -> None:
    """A device that was not looked at for a while: nothing of that is lost."""
    sent = b"".join(b"%07d\n" % number for number in range(100_000))
    with tcp_line() as (link, host):
        threading.Thread(target=host.sendall, args=(sent,), daemon=True).start()
        came = b""
        while len(came) < len(sent):
            came += b"".join(data for _, data in link.receive(0.0))
    assert came == sent


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
def test_a_serial_line_that_floods_likewise() -> None:
    master, slave = pty.openpty()
    tty.setraw(slave)
    clock = RealClock()
    with (
        closing(open_link(f"serial://{os.ttyname(slave)}", clock)) as link,
        pouring(lambda junk: os.write(master, junk), JUNK[:999]),
    ):
        assert ended(lambda: link.ask(b"*IDN?\n", end=b"\n", timeout_s=1e9)).fault == "babbles"
        korad = KoradSupply("y", link, clock, KoradSettings())
        assert ended(korad.identify).fault == "babbles"  # its replies have no end of their own
        os.set_blocking(master, False)
    os.close(slave)
    os.close(master)


@pytest.mark.parametrize("framer", ["rtu", "socket"])
def test_registers_of_a_line_that_floods_likewise(framer: str) -> None:
    with flooded() as link:
        master = ModbusLink(link, link._clock, framer=framer, timeout_s=1e9)
        assert ended(lambda: master.read_holding(1, 7, 1)).fault == "babbles"
        assert ended(lambda: master.write_register_unacknowledged(1, 7, 0)) is None


def test_who_has_little_time_to_ask_keeps_it_on_a_line_that_floods_slowly() -> None:
    gate = Gate()
    with (
        tcp_line() as (link, host),
        pouring(lambda one: (host.sendall(one), time.sleep(0.01)), b"#"),
        gate.asking_until(link._clock.now() + 0.3),
    ):
        error = ended(lambda: GatedLink(link, gate, link._clock).ask(b"", end=b"\n", timeout_s=1e9))
    assert error.fault == "silent"


def test_a_long_reply_that_has_an_end_is_one() -> None:
    with flooded(b"x" * (LONGEST - 1) + b"\n") as link:
        assert len(ended(lambda: link.ask(b"", end=b"\n", timeout_s=LONG_S))) == LONGEST
    with flooded(b"x" * LONGEST + b"\n") as link:
        assert ended(lambda: link.ask(b"", end=b"\n", timeout_s=LONG_S)).fault == "babbles"


@pytest.mark.skipif(sys.platform == "win32", reason="needs SIGKILL and ptys, which Windows lacks")
@pytest.mark.parametrize("deed", ["nothing", "killed"])
def test_a_supply_that_floods_and_obeys_is_at_zero_with_all_others(lab: Served, session: Sessions, deed: str) -> None:
    child = session("measure")
    link = lab.emulator("supply_x")
    outlet: Any = next(outlet for outlet, emulator in lab.lines if emulator is link)
    host = outlet._host.dup()  # as the lab's own end of the line, it never waits

    def pour(junk: bytes) -> None:
        select.select([], [host], [], 1.0)
        with suppress(BlockingIOError):
            host.send(junk)

    with host, pouring(pour):
        if deed == "killed":
            child.kill()
        until(lambda: at_zero(lab))
        until(lambda: "it babbles" in log())
        with suppress(OSError):  # the guardian has opened its link again
            host.shutdown(socket.SHUT_RDWR)
