"""serial, tcp, telnet, udp, usbtmc, visa, can, daq, ros, file: links on real lines, a lost one until it is reopened."""

from __future__ import annotations

import socket
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from threading import RLock
from typing import Protocol

import serial

from labcal.bench.clock import Clock
from labcal.bench.links import devices, hosts
from labcal.bench.links.canbus import CanPort
from labcal.bench.links.daq import DaqPort
from labcal.bench.links.deny import DenyList
from labcal.bench.links.echo import Echo
from labcal.bench.links.followed import FollowedFile
from labcal.bench.links.gone import failed, is_gone, not_open, stands
from labcal.bench.links.line import drop, read_reply
from labcal.bench.links.ports import claim
from labcal.bench.links.rostopic import RosPort
from labcal.bench.links.telnet import TelnetPort
from labcal.bench.links.urls import place, split
from labcal.bench.links.usbtmc import UsbtmcPort
from labcal.bench.links.visa import VisaPort
from labcal.errors import InputError, InstrumentError

CONNECT_S = 3.0
LOOK_S, LOOK_BYTES = 0.002, 1 << 16  # of one look: whoever looks has a clock of their own to keep
UNREAD_BYTES = 64 << 20  # beyond that the rest stays with the computer, which makes the other side wait or drops it
DATAGRAM_BUFFER = 4 << 20  # what comes while nobody looks is lost beyond this (Linux caps it at rmem_max)


class Port(Protocol):
    """An open port: what is there now, and no waiting."""

    byte_s: float  # how long one byte takes on the wire; 0 where that is not known

    def read(self) -> bytes:
        """What has arrived. Raises OSError when the line is gone, or reading failed."""
        ...

    def write(self, data: bytes) -> None:
        """Send all of it. Raises OSError when the line is gone, or writing failed."""
        ...

    def there(self) -> bool:
        """Whether the port is there yet and has not hung up, as far as the computer can tell without using it."""
        ...

    def close(self) -> None:
        """Let go."""
        ...


class WiredLink:
    """A Link on a real port, which is its alone as long as it is open.

    In the URL, `gap_ms` is the least pause before a request after anything on the line, `echo=1` an adapter's echo.
    """

    emulated = False

    def __init__(self, url: str, clock: Clock) -> None:
        self.url, self._clock = url, clock
        _, self._address, self._options = split(url)
        self._gap_s = int(self._options.get("gap_ms", "0")) / 1000
        self.never = DenyList()
        self._echo = Echo(url) if self._options.get("echo") == "1" else None
        self._arrived: list[tuple[float, bytes]] = []
        self._unread = 0  # bytes in it
        self._last_s = -1e9
        self._port: Port | None = None
        self._give_back_port: Callable[[], None] = lambda: None
        self._failure: InstrumentError | None = None
        self._stumbled = False  # the last look failed, and the port was there
        self._looking = RLock()  # who waits looks at every line, and another thread may be asking on this one
        self.reopen()
        clock.while_waiting(self.look)

    def reopen(self) -> None:
        """Open the port, again where it was lost. Who asks must then ask the instrument who it is."""
        self.close()
        self._give_back_port = claim(self.url)
        self._arrived, self._unread, self._failure, self._stumbled = [], 0, None, False
        if self._echo is not None:
            self._echo.forget()
        try:
            self._port = _open(self.url, self._address, self._options)
        except (OSError, ValueError) as error:
            self.close()
            if not isinstance(error, OSError):
                raise self._wrong(error) from error
            self._failure = not_open(self.url, error)
            raise self._failure from error

    def send(self, data: bytes) -> None:
        """Put bytes on the line."""
        self.never.check(self.url, data)
        self._clock.wait_until(self._last_s + self._gap_s)
        port = self._open_port()
        try:
            port.write(data)
        except OSError as error:
            self._failure = self._given_up(port, "writing", error)
            raise self._failure from error
        if self._echo is not None:
            self._echo.sent(data)
        self._last_s = self._clock.now()

    def receive(self, until_s: float) -> list[tuple[float, bytes]]:
        """All that arrives up to `until_s`, in pieces stamped at their first byte."""
        self._clock.wait_until(until_s)
        with self._looking:
            self.look()
            if not self._arrived:
                self._open_port()
            pieces, self._arrived, self._unread = self._arrived, [], 0
        return pieces if self._echo is None else self._echo.taken_off(pieces)

    def ask(self, request: bytes, *, end: bytes | int, timeout_s: float) -> bytes:
        """Send, then return the reply up to and with `end`, or `end` bytes. Raises InstrumentError (silent)."""
        if request:
            self.send(request)
        return read_reply(self, self._clock, end=end, timeout_s=timeout_s)

    def give_back(self, t_s: float, data: bytes) -> None:
        """Put bytes that were read too far back at the head of the line."""
        with self._looking:
            self._arrived.insert(0, (t_s, data))
            self._unread += len(data)

    def flush(self) -> None:
        """Drop what has arrived and was not read."""
        drop(self, self._clock)

    def close(self) -> None:
        """Let go of the line."""
        with self._looking:
            port, self._port = self._port, None
        if port is not None:
            with suppress(OSError):
                port.close()
        self._give_back_port()
        self._give_back_port = lambda: None

    def look(self) -> None:
        """Take in what has arrived, or the first of it where that is much: the next look takes the next.

        A line that is lost is reported to whoever uses it next, not to who waits now. One call that fails while the
        port is there is none: the next look shows it.
        """
        with self._looking:
            if self._port is None:
                return
            try:
                self._take_in(self._port)
                self._stumbled = False
            except OSError as error:
                if self._stumbled or is_gone(error) or not self._port.there():
                    self._failure = self._given_up(self._port, "reading", error)
                self._stumbled = True

    def _take_in(self, port: Port) -> None:
        most, until_s = min(self._unread + LOOK_BYTES, UNREAD_BYTES), time.monotonic() + LOOK_S
        while self._unread < most and (data := port.read()):
            self._take(data, port.byte_s)
            if time.monotonic() > until_s:
                break

    def _take(self, data: bytes, byte_s: float) -> None:
        now = self._clock.now()
        self._arrived.append((max(now - len(data) * byte_s, self._last_s), data))
        self._unread, self._last_s = self._unread + len(data), now

    def _open_port(self) -> Port:
        if self._port is None:
            raise self._failure or not_open(self.url)
        return self._port

    def _given_up(self, port: Port, call: str, error: OSError) -> InstrumentError:
        """The error for a call that failed, with the line closed."""
        there = port.there()
        self.close()
        return failed(self.url, call, error, there)

    def _wrong(self, error: ValueError) -> InputError:
        return error if isinstance(error, InputError) else InputError(f"link {self.url!r}: {error}")


class SerialPort:
    """Any port that pyserial opens by URL."""

    def __init__(self, address: str, options: dict[str, str]) -> None:
        baud = int(options.get("baud", "9600"))
        self._port = serial.serial_for_url(
            address,
            baudrate=baud,
            bytesize=int(options.get("bytesize", "8")),
            parity=options.get("parity", "N"),
            stopbits=float(options.get("stopbits", "1")),
            xonxoff=options.get("xonxoff") == "1",
            rtscts=options.get("rtscts") == "1",
            timeout=0,
            write_timeout=2,
        )
        if "://" not in address and sys.platform != "win32":
            devices.shut(self._port.fileno(), address)
        self.byte_s = 0.0 if "://" in address else 10 / baud
        self._address = address

    def read(self) -> bytes:
        """What has arrived."""
        with _as_os_error():
            return bytes(self._port.read(4096))

    def write(self, data: bytes) -> None:
        """Send all of it."""
        with _as_os_error():
            self._port.write(data)
            self._port.flush()

    def there(self) -> bool:
        """Whether it is; of one that is reached by URL its own errors tell. One that was closed is not."""
        try:
            return "://" not in self._address and stands(self._port.fileno(), self._address)
        except (OSError, TypeError):
            return False

    def close(self) -> None:
        """Let go."""
        self._port.close()


@contextmanager
def _as_os_error() -> Iterator[None]:
    """What a terminal cannot do, or one that is closed meanwhile by who reads, is raised as no OSError."""
    try:
        yield
    except OSError:
        raise
    except Exception as error:
        if type(error).__module__ != "termios" and not isinstance(error, TypeError):  # of a descriptor that is None
            raise
        raise OSError(*error.args) from error


class TcpPort:
    """A TCP connection."""

    byte_s = 0.0

    def __init__(self, host: str, port: int) -> None:
        self._socket = _connected(host, port)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def read(self) -> bytes:
        """What has arrived. Raises ConnectionError where the other side has closed."""
        self._socket.setblocking(False)
        try:
            data = self._socket.recv(65536)
        except BlockingIOError:
            return b""
        if not data:
            raise ConnectionError("the other side closed the connection")
        return data

    def write(self, data: bytes) -> None:
        """Send all of it."""
        self._socket.settimeout(CONNECT_S)
        self._socket.sendall(data)

    def there(self) -> bool:
        """It is, unless an error says otherwise."""
        return True

    def close(self) -> None:
        """Let go."""
        self._socket.close()


def _connected(host: str, port: int) -> socket.socket:
    """A connection to the first address that answers. Raises OSError."""
    error, known = OSError(f"{host} has no address that is known"), hosts.addresses(host)
    for address in known:
        try:
            return socket.create_connection((address, port), CONNECT_S)
        except OSError as failure:
            error = failure
    if known:
        hosts.forget(host)
    raise error


class UdpPort:
    """Datagrams that come to a local port; replies go to whoever sent the last one."""

    byte_s = 0.0

    def __init__(self, host: str, port: int) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, DATAGRAM_BUFFER)
        self._socket.bind((host, port))
        self._socket.setblocking(False)
        self._other: tuple[str, int] | None = None

    def read(self) -> bytes:
        """The next datagram, whole."""
        try:
            data, self._other = self._socket.recvfrom(65536)
        except BlockingIOError:
            return b""
        return data

    def write(self, data: bytes) -> None:
        """One datagram."""
        if self._other is not None:
            self._socket.sendto(data, self._other)

    def there(self) -> bool:
        """It is: it is this computer's own."""
        return True

    def close(self) -> None:
        """Let go."""
        self._socket.close()


def _open(url: str, address: str, options: dict[str, str]) -> Port:
    scheme = url.split("://", 1)[0]
    if scheme in ("serial", "modbus-rtu"):
        return SerialPort(address, options)
    if scheme == "usbtmc":
        return UsbtmcPort(address)
    if scheme == "visa":
        return VisaPort(address, options)
    if scheme == "can":
        return CanPort(address, options)
    if scheme == "daq":
        return DaqPort(address)
    if scheme == "ros":
        return RosPort(address)
    if scheme == "file":
        return FollowedFile(address)
    host, port = place(url, scheme, address)
    if scheme == "udp":
        return UdpPort(host, port)
    return TelnetPort(TcpPort(host, port)) if scheme == "telnet" else TcpPort(host, port)
