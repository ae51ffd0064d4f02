"""CCSDS space packets: the primary header, its counter, and time in the secondary header (133.0-B, 301.0-B)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

HEADER, IDLE, MODULO, LATE = 6, 2047, 16384, 64
Step = Literal["next", "gap", "late", "restart"]


@dataclass(frozen=True, slots=True)
class Packet:
    """One telemetry packet: `data` is its data field, secondary header included, CRC not."""

    apid: int
    count: int  # modulo 16384
    unsegmented: bool
    secondary: bool
    data: bytes


def parse(frame: bytes, *, crc_bytes: int = 0) -> Packet | None:
    """The packet that fills `frame` exactly; None where version, type or length say that it is none."""
    if len(frame) < HEADER + 1 + crc_bytes:
        return None
    first, second, length = (int.from_bytes(frame[k : k + 2], "big") for k in (0, 2, 4))
    if first >> 12 or length + 1 != len(frame) - HEADER:  # version 0, telemetry
        return None
    data = frame[HEADER : len(frame) - crc_bytes]
    return Packet(first & 0x7FF, second & 0x3FFF, second >> 14 == 3, bool(first >> 11 & 1), data)


def packets(raw: bytes) -> Iterator[bytes]:
    """The packets that stand in `raw` one after the other, by their lengths."""
    while raw:
        end = HEADER + 1 + int.from_bytes(raw[4:HEADER], "big")
        yield raw[:end]
        raw = raw[end:]


def build(apid: int, count: int, data: bytes, *, secondary: bool = False) -> bytes:
    """An unsegmented telemetry packet round `data` (at least one byte)."""
    words = secondary << 11 | apid, 3 << 14 | count % MODULO, len(data) - 1
    return b"".join(word.to_bytes(2, "big") for word in words) + data


class Counter:
    """Follows the count of one APID: what comes next, what is missing, what is late."""

    def __init__(self) -> None:
        self._expected: int | None = None

    def step(self, count: int) -> tuple[Step, int]:
        """What `count` means, and how many packets are missing before it.

        Up to 64 back it is a packet that was late or came twice; from there to half the circle back the sender has
        begun again.
        """
        ahead = 0 if self._expected is None else (count - self._expected) % MODULO
        if ahead >= MODULO - LATE:
            return "late", 0
        self._expected = (count + 1) % MODULO
        if ahead == 0:
            return "next", 0
        return ("gap", ahead) if ahead < MODULO // 2 else ("restart", 0)


def cuc_s(field: bytes, fine_bytes: int) -> float:
    """CUC time [s since its epoch]: whole seconds, then `fine_bytes` of binary fraction (301.0-B, 3.2)."""
    return int.from_bytes(field, "big") / float(1 << 8 * fine_bytes)


def cds_s(field: bytes) -> float:
    """CDS time [s since its epoch]: 16 bits of days, 32 of milliseconds (301.0-B, 3.3)."""
    return 86400.0 * int.from_bytes(field[:2], "big") + int.from_bytes(field[2:6], "big") / 1000
