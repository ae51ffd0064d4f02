"""The host's end of a line that can be pulled out and put back: a TCP port, or a pty behind a name that stays."""

from __future__ import annotations

import os
import pty
import select
import socket
import tty
from contextlib import suppress
from pathlib import Path


class TcpEnd:
    """A port that serves one host at a time; half open, the host that is there is not heard, and the next one is."""

    def __init__(self, scheme: str) -> None:
        self._listener: socket.socket | None = None
        self._host: socket.socket | None = None
        self._abandoned = list[socket.socket]()
        self._port = 0
        self.plug()
        self.url = f"{scheme}://{'socket://' if scheme != 'tcp' else ''}127.0.0.1:{self._port}"

    def plug(self) -> None:
        """Listen, at the same port as before."""
        if self._listener is None:
            self._listener = socket.create_server(("127.0.0.1", self._port))
            self._listener.setblocking(False)
            self._port = self._listener.getsockname()[1]

    def unplug(self) -> None:
        """The connection ends, and nobody listens any more."""
        for end in (self._listener, self._host, *self._abandoned):
            if end is not None:
                end.close()
        self._listener, self._host, self._abandoned = None, None, []

    def half_open(self) -> None:
        """The host believes in a connection that nobody serves any more."""
        if self._host is not None:
            self._abandoned.append(self._host)
            self._host = None

    def files(self) -> list[int]:
        """What becomes readable when the host sends, or comes."""
        end = self._host or self._listener
        return [] if end is None else [end.fileno()]

    def read(self) -> bytes:
        """What the host sent; one that has gone is let go."""
        self._welcome()
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

    def _welcome(self) -> None:
        if self._host is None and self._listener is not None:
            with suppress(OSError):
                self._host = self._listener.accept()[0]
                self._host.setblocking(False)
                self._host.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)


class PtyEnd:
    """A pseudo terminal; its name is a link that is gone while it is out, as under /dev/serial/by-id."""

    def __init__(self, scheme: str, name: Path) -> None:
        self._name, self._ends = name, list[int]()
        self.plug()
        self.url = f"{scheme}://{name}?baud=115200"

    def plug(self) -> None:
        """A terminal under the old name."""
        if not self._ends:
            self._ends = list(pty.openpty())
            tty.setraw(self._ends[1])
            os.set_blocking(self._ends[0], False)
            self._name.symlink_to(os.ttyname(self._ends[1]))

    def unplug(self) -> None:
        """Whoever has it open is hung up on."""
        self._name.unlink(missing_ok=True)
        while self._ends:
            os.close(self._ends.pop())

    def half_open(self) -> None:
        """A terminal has no connections: nothing is heard on it until it is put in anew."""
        self.unplug()
        self.plug()

    def files(self) -> list[int]:
        """The end that the host does not have."""
        return self._ends[:1]

    def read(self) -> bytes:
        """What the host sent."""
        with suppress(OSError):
            return os.read(self._ends[0], 65536) if self._ends else b""
        return b""

    def write(self, data: bytes) -> None:
        """Put bytes on the line; what is said while nobody reads is lost."""
        with suppress(OSError):
            if self._ends and select.select([], [self._ends[0]], [], 0)[1]:
                os.write(self._ends[0], data)


End = TcpEnd | PtyEnd
