"""Modbus RTU frames for transcripts, with a CRC of the tests' own (by table, where the emulators shift bits)."""

from __future__ import annotations

from functools import reduce


def _row(value: int) -> int:
    return reduce(lambda v, _: v >> 1 ^ 0xA001 if v & 1 else v >> 1, range(8), value)


TABLE = [_row(value) for value in range(256)]


def rtu(hexadecimal: str) -> bytes:
    """The bytes, and their CRC-16/MODBUS."""
    body = bytes.fromhex(hexadecimal)
    crc = reduce(lambda v, byte: v >> 8 ^ TABLE[(v ^ byte) & 0xFF], body, 0xFFFF)
    return body + crc.to_bytes(2, "little")


def wrote(hexadecimal: str) -> tuple[bytes, bytes]:
    """A write of one register or coil and its answer, which is its echo."""
    return rtu(hexadecimal), rtu(hexadecimal)


def read(asked: str, words: list[int]) -> tuple[bytes, bytes]:
    """A read of registers, and the answer."""
    data = b"".join(word.to_bytes(2) for word in words)
    return rtu(asked), rtu(asked.replace(" ", "")[:4] + f"{len(data):02x}" + data.hex())
