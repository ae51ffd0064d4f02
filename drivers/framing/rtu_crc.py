"""The CRC-16 of Modbus RTU frames, which others use too: polynomial 8005h reflected, start FFFFh, low byte first."""

from __future__ import annotations


def rtu_crc(data: bytes) -> bytes:
    """The two bytes that follow `data`. b"123456789" gives 37h 4Bh."""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0xA001 if crc & 1 else 0)
    return crc.to_bytes(2, "little")
