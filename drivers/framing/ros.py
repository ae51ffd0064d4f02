"""sensor_msgs/MagneticField as CDR: a stamp, the name of a frame, the field in tesla, nine numbers of covariance."""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from labcal.bench.links.rostopic import HEAD

LITTLE, BIG = b"\0\1", b"\0\0"  # how an encapsulation begins; two bytes of options follow
TEXT, COVARIANCE = 8, 9  # where the length of the frame's name stands behind it; numbers at the end
Pieces = Sequence[tuple[float, bytes]]


@dataclass(frozen=True, slots=True)
class Message:
    """One message: its stamp [s], the frame it is stated in, and the field (3,) [T]."""

    stamp_s: float
    frame: str
    xyz_T: tuple[float, float, float]


def messages(pieces: Pieces) -> Iterator[tuple[float, bytes, bytes]]:
    """Stamp, whole and CDR of each message; what is cut is given as far as it came."""
    for stamp, data in pieces:
        while data:
            length = HEAD.unpack_from(data)[0] if len(data) >= HEAD.size else len(data)
            whole, data = data[: HEAD.size + length], data[HEAD.size + length :]
            yield stamp, whole, whole[HEAD.size :]


def parse(cdr: bytes) -> Message | None:
    """The message; None where it is none."""
    order = {LITTLE: "<", BIG: ">"}.get(cdr[:2])
    body = cdr[4:]
    if order is None or len(body) < TEXT + 4:
        return None
    sec, nanosec, length = struct.unpack_from(f"{order}iII", body)
    at = -(-(TEXT + 4 + length) // 8) * 8  # numbers of 8 bytes stand at multiples of 8
    name = body[TEXT + 4 : TEXT + 4 + length]
    if len(body) != at + 8 * (3 + COVARIANCE) or nanosec >= 10**9 or not name.endswith(b"\0"):
        return None
    frame = name.rstrip(b"\0").decode("utf-8", "replace")
    return Message(sec + 1e-9 * nanosec, frame, struct.unpack_from(f"{order}3d", body, at))


def build(message: Message) -> bytes:
    """The message as little-endian CDR, its covariance zero, which says that it is not known."""
    sec, part = divmod(round(message.stamp_s * 1e9), 10**9)
    name = message.frame.encode() + b"\0"
    head = struct.pack("<iII", sec, part, len(name)) + name
    head += bytes(-len(head) % 8)
    return LITTLE + b"\0\0" + head + struct.pack("<12d", *message.xyz_T, *(COVARIANCE * [0.0]))
