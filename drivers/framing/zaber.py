"""What a Zaber stage says with every reply, and the checksum that it may have."""

from __future__ import annotations

import re
from dataclasses import dataclass

REPLY = re.compile(rb"@(\d\d) (\d) (?:(\d\d) )?(OK|RJ) (IDLE|BUSY) ([!-~]{2}) ([ -9;-~]*)(?::([0-9A-F]{2}))?\r\n")


@dataclass(frozen=True, slots=True)
class Reply:
    """What the device said, and the state that it says with everything."""

    data: str
    busy: bool
    warning: str


def checksum(body: bytes) -> str:
    """The protocol's LRC: the negated sum of all bytes after the first character, as two hex digits."""
    return f"{-sum(body) & 0xFF:02X}"
