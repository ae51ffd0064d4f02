"""CRC-16-CCITT as CCSDS uses it: polynomial 1021h, start FFFFh, not reflected (CCSDS 132.0-B, 4.1.6.2)."""

from __future__ import annotations

import binascii


def crc16(data: bytes) -> int:
    """The CRC of `data`; that of a frame with its CRC at the end is zero. b"123456789" gives 29B1h."""
    return binascii.crc_hqx(data, 0xFFFF)
