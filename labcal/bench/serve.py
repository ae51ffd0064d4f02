"""Every emulated instrument of a bench on a real line: TCP ports and ptys, so that any program can talk to it."""

from __future__ import annotations

import json
import os
import socket
import sys
from collections.abc import Callable
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any, Protocol

from labcal.bench.clock import Clock, RealClock
from labcal.bench.config import read_config
from labcal.bench.links import Emulator
from labcal.bench.loading import Loader, speaks_modbus
from labcal.files import write_text

STEP_S = 0.002

if sys.platform != "win32":
    import pty
    import tty

    def open_pty() -> tuple[int, int, str]:
        """Both ends of a raw pseudo terminal, and its name; the slave stays open: hosts come and go."""
        master, slave = pty.openpty()
        tty.setraw(slave)
        os.set_blocking(master, False)
        return master, slave, os.ttyname(slave)
else:

    def open_pty() -> tuple[int, int, str]:
        """There is none."""
        raise OSError("Windows has no pseudo terminals")


class Outlet(Protocol):
    """The emulator's end of a real line."""

    url: str

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
    """A pseudo terminal, for what has a serial line."""

    def __init__(self, scheme: str) -> None:
        self._master, self._slave, name = open_pty()
        self.url = f"{scheme}://{name}?baud=115200"

    def read(self) -> bytes:
        """What the host sent."""
        with suppress(BlockingIOError):
            return os.read(self._master, 65536)
        return b""

    def write(self, data: bytes) -> None:
        """Put bytes on the line."""
        with suppress(BlockingIOError):
            os.write(self._master, data)

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
        self.url = f"{scheme}://{'socket://' if scheme != 'tcp' else ''}127.0.0.1:{port}"

    def read(self) -> bytes:
        """What the host sent."""
        with suppress(BlockingIOError):
            self._host = self._listener.accept()[0]
            self._host.setblocking(False)
        if self._host is not None:
            with suppress(OSError):
                return self._host.recv(65536)
        return b""

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


def serve(path: Path, out: Path, ready: Callable[[], None], *, clock: Clock | None = None) -> None:
    """Serve the emulated instruments of `path` until interrupted; write `out` first, then call `ready`.

    `out` is the same bench with real links instead of emulated:// and without the table [twin].
    """
    config = read_config(path)
    loader = Loader(path, config, clock or RealClock(), 0)
    lines: dict[str, tuple[Outlet, Emulator]] = {}
    with ExitStack() as afterwards:
        for name, entry in config.instruments.items():
            if entry.link.startswith("emulated://") and loader.line_of(name) not in lines:
                _, hints, _ = loader.driver(name)
                emulator = loader.emulator(name)
                outlet = _outlet(emulator, speaks_modbus(hints))
                afterwards.callback(outlet.close)
                lines[loader.line_of(name)] = (outlet, emulator)
        table = config.model_dump(mode="json", exclude_defaults=True)
        for name in config.instruments:
            if loader.line_of(name) in lines:
                table["instruments"][name]["link"] = lines[loader.line_of(name)][0].url
        write_text(out, toml(table))
        ready()
        _pump(list(lines.values()), loader.clock)


def _outlet(emulator: Emulator, modbus: bool) -> Outlet:
    scheme = "modbus-rtu" if modbus else "serial"
    if getattr(emulator, "wire", "serial") == "tcp":
        return TcpOutlet("tcp")
    return TcpOutlet(scheme) if sys.platform == "win32" else PtyOutlet(scheme)


def _pump(lines: list[tuple[Outlet, Emulator]], clock: Clock) -> None:
    while True:
        for outlet, emulator in lines:
            if data := outlet.read():
                emulator.take(clock.now(), data)
            if pieces := emulator.emit(clock.now()):
                outlet.write(b"".join(piece for _, piece in pieces))
        clock.wait_until(clock.now() + STEP_S)


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
