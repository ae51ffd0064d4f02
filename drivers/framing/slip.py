"""SLIP frames on a serial line (RFC 1055)."""

from __future__ import annotations

import re

END, ESC = b"\xc0", b"\xdb"
BROKEN = re.compile(rb"\xdb(?![\xdc\xdd])")


def decode(line: bytes) -> bytes | None:
    """The packet between two ENDs; None where an escape is broken."""
    if BROKEN.search(line):
        return None
    return line.replace(b"\xdb\xdc", END).replace(b"\xdb\xdd", ESC)


def encode(packet: bytes) -> bytes:
    """END first, which flushes noise, then the packet, then END."""
    return END + packet.replace(ESC, b"\xdb\xdd").replace(END, b"\xdb\xdc") + END
