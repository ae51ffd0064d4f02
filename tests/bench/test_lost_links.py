"""A line that is lost, and calls that fail while its port is there: on the other end of a real terminal."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

import pytest
import serial

from labcal.bench.clock import RealClock
from labcal.bench.links import WiredLink, open_link
from labcal.errors import InstrumentError

pty = pytest.importorskip("pty", reason="Windows has no ptys")
termios = pytest.importorskip("termios", reason="Windows has no terminals of this kind")
tty = pytest.importorskip("tty", reason="Windows has no terminals of this kind")

LONG_S = 60.0  # a busy machine answers within it


def test_an_unplugged_line_is_lost_until_it_is_opened_again() -> None:
    master, slave = pty.openpty()
    tty.setraw(slave)
    clock = RealClock()
    link = open_link(f"serial://{os.ttyname(slave)}?baud=115200", clock)
    os.write(master, b"here\n")
    assert link.ask(b"", end=b"\n", timeout_s=LONG_S) == b"here\n"
    os.close(slave)
    os.close(master)
    for _ in range(2):
        with pytest.raises(InstrumentError) as caught:
            link.ask(b"who\n", end=b"\n", timeout_s=0.2)
        assert caught.value.fault == "link lost"
    with pytest.raises(InstrumentError) as caught:
        link.reopen()
    assert caught.value.fault == "link lost"


@pytest.fixture
def terminal() -> Iterator[tuple[int, WiredLink]]:
    """A terminal's other end, and the link to it."""
    master, slave = pty.openpty()
    tty.setraw(slave)
    link = WiredLink(f"serial://{os.ttyname(slave)}?baud=115200", RealClock())
    yield master, link
    link.close()
    for end in (master, slave):
        with suppress(OSError):
            os.close(end)


@pytest.mark.parametrize("call", ["send", "look"])
def test_so_is_one_that_is_closed_inside_a_call(terminal: tuple[int, WiredLink], call: str) -> None:
    """What pyserial waits on is None by then, which is no error of the system's."""
    _, link = terminal
    port: Any = link._port
    descriptor, port._port.fd = port._port.fd, None
    if call == "look":
        for _ in range(2):  # one that fails may be a stumble
            link.look()
    with pytest.raises(InstrumentError) as caught:
        link.send(b"who\n")
    os.close(descriptor)
    assert caught.value.fault == "link lost"


def test_one_that_another_thread_closed_meanwhile_is_lost_and_no_crash(terminal: tuple[int, WiredLink]) -> None:
    _, link = terminal
    port: Any = link._port
    port.close()
    with pytest.raises(InstrumentError) as caught:
        link.send(b"who\n")
    assert caught.value.fault == "link lost"


def failing(*errors: Exception, then: Any = None) -> Any:
    """A call that fails so often, and is `then` from there on."""
    left = list(errors)

    def call(*what: Any) -> Any:
        if left:
            raise left.pop(0)
        return then(*what)

    return call


def test_one_read_that_fails_is_no_lost_link_and_two_are_said_as_what_they_are(terminal: tuple[int, WiredLink]) -> None:
    master, link = terminal
    port: Any = link._port
    os.write(master, b"here\n")
    port.read = failing(OSError(errno.EIO, "Input/output error"), then=port.read)
    assert link.ask(b"", end=b"\n", timeout_s=LONG_S) == b"here\n"
    port.read = failing(*[OSError(errno.EIO, "Input/output error")] * 2)
    with pytest.raises(InstrumentError, match=r"reading failed .*Input/output error.*; its port is there") as caught:
        link.ask(b"", end=b"\n", timeout_s=LONG_S)
    assert "lost" not in str(caught.value)
    assert "Plug it in" not in str(caught.value)
    link.reopen()


@pytest.mark.parametrize(
    ("error", "says"),
    [
        (OSError(errno.EIO, "Input/output error"), "writing failed"),
        (OSError(errno.ENODEV, "No such device"), "the link was lost"),
        (serial.SerialException("write failed: [Errno 38] Function not implemented"), "writing failed"),
        (serial.SerialTimeoutException("Write timeout"), "writing failed"),
        (ConnectionResetError(errno.ECONNRESET, "Connection reset by peer"), "the link was lost"),
    ],
)
def test_a_link_is_lost_only_where_its_port_is_gone(terminal: tuple[int, WiredLink], error: OSError, says: str) -> None:
    _, link = terminal
    port: Any = link._port
    port.write = failing(error)
    for _ in range(2):  # whoever uses it next is told the same
        with pytest.raises(InstrumentError, match=says) as caught:
            link.send(b"who\n")
        assert ("Plug it in" in str(caught.value)) == ("lost" in says)


@pytest.mark.parametrize(("hung_up", "says"), [(False, "writing failed"), (True, "the link was lost")])
def test_a_terminal_that_does_not_take_what_was_written_raises_no_error_of_its_own(
    terminal: tuple[int, WiredLink], hung_up: bool, says: str
) -> None:
    master, link = terminal
    port: Any = link._port
    port._port.flush = failing(termios.error(errno.EIO, "Input/output error"))
    port._port.write = len
    if hung_up:
        os.close(master)
    with pytest.raises(InstrumentError, match=says):
        link.send(b"who\n")
