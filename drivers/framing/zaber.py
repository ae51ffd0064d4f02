"""What a Zaber stage says with every reply and unasked, and the checksum that it may have."""

from __future__ import annotations

import re
from dataclasses import dataclass

REPLY = re.compile(rb"@(\d\d) (\d) (?:(\d\d) )?(OK|RJ) (IDLE|BUSY) ([!-~]{2}) ([ -9;-~]*)(?::([0-9A-F]{2}))?\r\n")

UNASKED = (b"!", b"#")  # how alerts (where comm.alert is 1) and lines of information begin
SPEED_DATA = 1.6384  # speed data = microsteps/s · 1.6384
NOT_HOMED, TOUCHED = ("WR", "WH"), ("NC", "NI")  # warnings: no reference position; somebody turned the knob


@dataclass(frozen=True, slots=True)
class Reply:
    """What the device said, and the state that it says with everything."""

    data: str
    busy: bool
    warning: str


def checksum(body: bytes) -> str:
    """The protocol's LRC: the negated sum of all bytes after the first character, as two hex digits."""
    return f"{-sum(body) & 0xFF:02X}"
