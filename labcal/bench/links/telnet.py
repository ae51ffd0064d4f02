"""telnet:// a TCP connection on which Telnet is spoken (RFC 854): commands taken out, every option refused."""

from __future__ import annotations

from typing import Protocol

IAC, DONT, DO, WONT, WILL, SB, SE = 255, 254, 253, 252, 251, 250, 240
ANSWERS = {DO: WONT, WILL: DONT}  # an option is refused, so that bytes stay as the instrument sends them
MOST_ANSWERS = 64  # of one connection: two ends that refuse each other for ever do not


class Carrier(Protocol):
    """The connection below."""

    byte_s: float

    def read(self) -> bytes:
        """What has arrived. Raises OSError when it is gone."""
        ...

    def write(self, data: bytes) -> None:
        """Send all of it."""
        ...

    def there(self) -> bool:
        """Whether it is, as far as is known."""
        ...

    def close(self) -> None:
        """Let go."""
        ...


class TelnetPort:
    """Bytes of the instrument on `below`; a command that is cut is waited for."""

    def __init__(self, below: Carrier) -> None:
        self._below, self.byte_s = below, below.byte_s
        self._rest, self._answered, self._after_cr = b"", 0, False

    def read(self) -> bytes:
        """What has arrived, without Telnet's own."""
        data, self._rest = self._rest + self._below.read(), b""
        out, at = bytearray(), 0
        while at < len(data):
            length = self._command(data[at:]) if data[at] == IAC else 0
            if length < 0:
                self._rest = data[at:]
                break
            if not length and not (self._after_cr and data[at] == 0):  # CR NUL is a carriage return alone
                out.append(data[at])
            self._after_cr = not length and data[at] == 13
            if length == 2 and data[at + 1] == IAC:
                out.append(IAC)
            at += length or 1
        return bytes(out)

    def write(self, data: bytes) -> None:
        """Send all of it, FFh as FFh FFh."""
        self._below.write(data.replace(bytes([IAC]), bytes([IAC, IAC])))

    def there(self) -> bool:
        """As the connection below tells."""
        return self._below.there()

    def close(self) -> None:
        """Let go."""
        self._below.close()

    def _command(self, data: bytes) -> int:
        """The length of the command that `data` begins with, which is answered; -1 where it is cut."""
        if len(data) < 2:
            return -1
        if data[1] == SB:
            end = data.find(bytes([IAC, SE]))
            return end + 2 if end >= 0 else -1
        if data[1] not in (DO, DONT, WILL, WONT):
            return 2
        if len(data) < 3:
            return -1
        if data[1] in ANSWERS and self._answered < MOST_ANSWERS:
            self._answered += 1
            self._below.write(bytes([IAC, ANSWERS[data[1]], data[2]]))
        return 3
