"""Every emulated instrument of a bench on a real line: TCP ports and ptys, so that any program can talk to it."""

from __future__ import annotations

import json
import os
import select
import socket
import sys
from collections.abc import Callable
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any, Protocol

from labcal.bench.clock import Clock, RealClock
from labcal.bench.config import read_config
from labcal.bench.links.emulated import Emulator, Foresees
from labcal.bench.loading import Loader, speaks_modbus
from labcal.files.atomic import write_text

STEP_S = 0.002  # how often an emulator is looked at that does not foresee its next bytes
UNHEARD_S = 1.0  # and one whose line is full, as nobody reads it
LONGEST_S = 3600.0  # that select is asked to wait

BAUD = 115_200  # of an emulator that states none

if sys.platform != "win32":
    import pty
    import termios
    import tty

    def open_pty() -> tuple[int, int, str]:
        """Both ends of a raw pseudo terminal, and its name; the slave stays open: hosts come and go."""
        master, slave = pty.openpty()
        tty.setraw(slave)
        os.set_blocking(master, False)
        return master, slave, os.ttyname(slave)

    def set_baud(slave: int, baud: int) -> None:
        """8N1 at this rate."""
        state = termios.tcgetattr(slave)
        state[2] = state[2] & ~FRAME | termios.CS8
        state[4] = state[5] = getattr(termios, f"B{baud}")
        termios.tcsetattr(slave, termios.TCSANOW, state)

    def line_of(slave: int) -> tuple[int, ...]:
        """How the host has set its line, as far as the terminal tells: Linux keeps odd parity, not even.

        How many stop bits it sends is its own affair: who hears it looks at the first only.
        """
        state = termios.tcgetattr(slave)
        return state[4], state[5], state[2] & FRAME

    FRAME = termios.PARENB | termios.PARODD | termios.CSIZE
else:

    def set_baud(slave: int, baud: int) -> None:
        """There is none."""

    def line_of(slave: int) -> tuple[int, ...]:
        """There is none."""
        return ()

    def open_pty() -> tuple[int, int, str]:
        """There is none."""
        raise OSError("Windows has no pseudo terminals")


class Outlet(Protocol):
    """The emulator's end of a real line."""

    url: str

    def files(self) -> list[int]:
        """What becomes readable when the host sends."""
        ...

    def full(self) -> list[int]:
        """What becomes writable when a host reads at last; none while there is room."""
        ...

    def read(self) -> bytes:
        """What the host sent since the last look."""
        ...

    def write(self, data: bytes) -> None:
        """Put bytes on the line; they are gone where nobody listens."""
        ...

    def close(self) -> None:
        """Let go of the line."""
        ...


class PtyOutlet:
    """A pseudo terminal, for what has a serial line; a host that has set it otherwise than 8N1 at `baud` is not heard
    and hears nothing, as far as the terminal tells. `usb`: the instrument's own USB port, where no rate is on a wire.
    """

    def __init__(self, scheme: str, baud: int = BAUD, *, usb: bool = False) -> None:
        self._master, self._slave, name = open_pty()
        self.url = f"{scheme}://{name}?baud={baud}"
        self._full = list[int]()
        set_baud(self._slave, baud)
        self._line, self._usb = line_of(self._slave), usb

    def files(self) -> list[int]:
        """The end that the host does not have."""
        return [self._master]

    def full(self) -> list[int]:
        """The same, where the terminal holds all that it can; what is said until somebody reads is lost."""
        self._full = [] if select.select([], [self._master], [], 0)[1] else [self._master]
        return self._full

    def read(self) -> bytes:
        """What the host sent."""
        with suppress(BlockingIOError):
            data = os.read(self._master, 65536)
            return data if self._hears() else b""
        return b""

    def write(self, data: bytes) -> None:
        """Put bytes on the line."""
        with suppress(BlockingIOError):
            if not self._full and self._hears():
                os.write(self._master, data)

    def _hears(self) -> bool:
        return self._usb or line_of(self._slave) == self._line

    def close(self) -> None:
        """Close both ends."""
        os.close(self._master)
        os.close(self._slave)


class TcpOutlet:
    """A TCP port on this machine that serves one host at a time, the newest."""

    def __init__(self, scheme: str) -> None:
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._listener.setblocking(False)
        self._host: socket.socket | None = None
        port = self._listener.getsockname()[1]
        self.url = f"{scheme}://{'' if scheme in ('tcp', 'modbus-tcp') else 'socket://'}127.0.0.1:{port}"

    def files(self) -> list[int]:
        """The port, and the connection where there is one."""
        return [end.fileno() for end in (self._listener, self._host) if end is not None]

    def full(self) -> list[int]:
        """None: a connection without a host holds nothing."""
        return []

    def read(self) -> bytes:
        """What the host sent; one that has gone is let go, and the next is heard once this one has said all."""
        if not (data := self._heard()):
            self._welcome()
        return data

    def _heard(self) -> bytes:
        if self._host is None:
            return b""
        try:
            data = self._host.recv(65536)
        except BlockingIOError:
            return b""
        except OSError:
            data = b""
        if not data:
            self._host.close()
            self._host = None
        return data

    def write(self, data: bytes) -> None:
        """Send to the host that is there."""
        if self._host is not None:
            with suppress(OSError):
                self._host.sendall(data)

    def close(self) -> None:
        """Close the port and the connection."""
        self._listener.close()
        if self._host is not None:
            self._host.close()

    def _welcome(self) -> None:
        """Take a host that has come in place of the one before."""
        with suppress(OSError):
            host = self._listener.accept()[0]
            if self._host is not None:
                self._host.close()
            host.setblocking(False)
            host.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self._host = host


def serve(path: Path, out: Path, ready: Callable[[], None], *, clock: Clock | None = None) -> None:
    """Serve the emulated instruments of `path` until interrupted; write `out` first, then call `ready`.

    `out` is the same bench with real links instead of emulated:// and without the table [twin]; where no instrument is
    a real one it says `served`: what is measured there is simulated.
    """
    config = read_config(path)
    loader = Loader(path, config, clock or RealClock(), 0)
    lines: dict[str, tuple[Outlet, Emulator]] = {}
    with ExitStack() as afterwards:
        for name, entry in config.instruments.items():
            if entry.link.startswith("emulated://") and loader.line_of(name) not in lines:
                _, hints, _ = loader.driver(name)
                emulator = _met_at(loader.emulator(name))
                outlet = outlet_of(emulator, speaks_modbus(hints))
                afterwards.callback(outlet.close)
                lines[loader.line_of(name)] = (outlet, emulator)
        table = config.model_dump(mode="json", exclude_defaults=True)
        if all(loader.line_of(name) in lines for name in config.instruments):
            table["served"] = True
        for name in config.instruments:
            if loader.line_of(name) in lines:
                table["instruments"][name]["link"] = lines[loader.line_of(name)][0].url
        write_text(out, toml(table))
        ready()
        _pump(list(lines.values()), loader.clock)


def outlet_of(emulator: Emulator, modbus: bool) -> Outlet:
    """The real line that an emulated instrument is put on: a TCP port where it has a network port, else a pty."""
    scheme = "modbus-rtu" if modbus else "serial"
    if (wire := getattr(emulator, "wire", "serial")) in ("tcp", "modbus-tcp"):
        return TcpOutlet(wire)
    if sys.platform == "win32":
        return TcpOutlet(scheme)
    return PtyOutlet(scheme, baud_of(emulator), usb=getattr(emulator, "usb", False))


def _met_at(emulator: Emulator) -> Emulator:
    """What stands at its network port, of one that speaks otherwise there than in a simulated lab."""
    port: Emulator = getattr(emulator, "on_network", lambda: emulator)()
    return port


def baud_of(emulator: Emulator) -> int:
    """The rate at which an emulated instrument speaks: its own `baud`, where it has one."""
    return int(getattr(emulator, "baud", BAUD))


def _pump(lines: list[tuple[Outlet, Emulator]], clock: Clock) -> None:
    """Carry bytes both ways; in between sleep until a host sends or an emulator's next bytes are due."""
    while True:
        for outlet, emulator in lines:
            if data := outlet.read():
                emulator.take(clock.now(), data)
            if pieces := emulator.emit(clock.now()):
                outlet.write(b"".join(piece for _, piece in pieces))
        full = [outlet.full() for outlet, _ in lines]
        idle = [_idle_s(emulator, clock.now(), bool(there)) for (_, emulator), there in zip(lines, full, strict=True)]
        files = [file for outlet, _ in lines for file in outlet.files()]
        select.select(files, [file for there in full for file in there], [], min(idle, default=LONGEST_S))


def _idle_s(emulator: Emulator, now: float, unheard: bool) -> float:
    due_s = emulator.due_s() if isinstance(emulator, Foresees) else now
    return min(max(due_s - now, UNHEARD_S if unheard else STEP_S if due_s <= now else 0.0), LONGEST_S)


def toml(table: dict[str, Any], head: str = "") -> str:
    """A table of plain values as TOML text."""
    lines = [f"{json.dumps(key)} = {_value(value)}" for key, value in table.items() if not isinstance(value, dict)]
    text = "\n".join(([f"[{head}]"] if head else []) + lines) + "\n\n"
    for key, value in table.items():
        if isinstance(value, dict):
            text += toml(value, f"{head}.{json.dumps(key)}" if head else json.dumps(key))
    return text


def _value(value: Any) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    return json.dumps(value, ensure_ascii=False)
