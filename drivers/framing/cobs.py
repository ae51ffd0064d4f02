"""COBS frames: no zero inside, a zero between them (Cheshire & Baker, 1999)."""

from __future__ import annotations

END = b"\x00"


def decode(line: bytes) -> bytes | None:
    """The packet between two zeros; None where the lengths do not add up."""
    packet, at = bytearray(), 0
    while at < len(line):
        code = line[at]
        block = line[at + 1 : at + code]
        if code == 0 or len(block) != code - 1:
            return None
        packet += block
        at += code
        if code < 0xFF and at < len(line):
            packet.append(0)
    return bytes(packet)


def encode(packet: bytes) -> bytes:
    """The packet without zeros, and the zero that ends it."""
    coded = bytearray()
    parts = packet.split(END)
    for number, part in enumerate(parts):
        while len(part) >= 254:
            coded += b"\xff" + part[:254]
            part = part[254:]
            if not part and number == len(parts) - 1:
                return bytes(coded) + END
        coded += bytes([len(part) + 1]) + part
    return bytes(coded) + END
