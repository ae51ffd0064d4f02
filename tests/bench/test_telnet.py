"""telnet:// against a server that negotiates, and whose bytes hold FFh."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from contextlib import closing

import pytest

from drivers.tti_pl import Settings, TtiSupply
from labcal.bench.clock import RealClock
from labcal.bench.links import open_link
from labcal.bench.links.telnet import MOST_ANSWERS, TelnetPort
from labcal.bench.links.urls import split
from labcal.errors import InputError

WILL_ECHO, DO_TERMINAL, DO_SIZE = b"\xff\xfb\x01", b"\xff\xfd\x18", b"\xff\xfd\x1f"
REFUSED = b"\xff\xfe\x01\xff\xfc\x18\xff\xfc\x1f"
LONG_S = 60.0


class Below:
    """A connection that gives pieces, and keeps what is written."""

    byte_s = 0.0

    def __init__(self, *pieces: bytes) -> None:
        self.pieces, self.written = list(pieces), b""

    def read(self) -> bytes:
        return self.pieces.pop(0) if self.pieces else b""

    def write(self, data: bytes) -> None:
        self.written += data

    def there(self) -> bool:
        return True

    def close(self) -> None:
        """Nothing is held."""


def all_of(port: TelnetPort, below: Below) -> bytes:
    said = b""
    while below.pieces:
        said += port.read()
    return said


WIRE = WILL_ECHO + b"TTI\xff\xff,PL\r\0\r\n" + b"\xff\xfa\x18\x01\xff\xf0" + DO_TERMINAL + b"x\xff\xf1y" + DO_SIZE


@pytest.mark.parametrize("size", [1, 2, 3, 5, 100])
def test_its_commands_are_taken_out_however_they_are_cut(size: int) -> None:
    below = Below(*(WIRE[k : k + size] for k in range(0, len(WIRE), size)))
    assert all_of(TelnetPort(below), below) == b"TTI\xff,PL\r\r\nxy"
    assert below.written == REFUSED


def test_what_is_sent_keeps_its_bytes_and_a_quarrel_has_an_end() -> None:
    below = Below(*[DO_TERMINAL] * 200)
    port = TelnetPort(below)
    port.write(b"\xff1\n")
    assert below.written == b"\xff\xff1\n"
    assert all_of(port, below) == b""
    assert len(below.written) == 4 + 3 * MOST_ANSWERS


@pytest.fixture
def server() -> Iterator[tuple[int, list[bytes]]]:
    """A terminal server: it negotiates, then a supply answers behind it."""
    heard = list[bytes]()
    listener = socket.create_server(("127.0.0.1", 0))

    def serve() -> None:
        with listener.accept()[0] as host:
            host.sendall(WILL_ECHO + DO_TERMINAL + DO_SIZE)
            heard.append(host.recv(len(REFUSED), socket.MSG_WAITALL))
            heard.append(host.recv(6, socket.MSG_WAITALL))
            host.sendall(b"THURLBY THANDAR, PL303-P, 512340, 3.02\r\0\n")
            host.recv(1)

    thread = threading.Thread(target=serve, daemon=True)
    thread.start()
    with listener:
        yield listener.getsockname()[1], heard
        thread.join(LONG_S)


def test_a_supply_behind_a_terminal_server_says_who_it_is(server: tuple[int, list[bytes]]) -> None:
    port, heard = server
    clock = RealClock()
    with closing(open_link(f"telnet://127.0.0.1:{port}", clock)) as link:
        link.receive(clock.now() + 0.3)
        supply = TtiSupply("x", link, clock, Settings(timeout_s=LONG_S))
        assert supply.query("*IDN?").startswith("THURLBY THANDAR, PL303-P")
    assert heard == [REFUSED, b"*IDN?\n"]


def test_without_a_port_it_is_telnet_s() -> None:
    assert split("telnet://192.168.0.7")[1] == "192.168.0.7"
    with pytest.raises(InputError, match="no number from 1 to 65535"):
        split("telnet://192.168.0.7:99999")
