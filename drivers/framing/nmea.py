"""NMEA-0183 sentences: `$NAME,field,field*HH`, HH the exclusive or of all between $ and *."""

from __future__ import annotations

import re
from functools import reduce
from operator import xor

SENTENCE = re.compile(rb"\$([A-Z0-9]+)((?:,[^$*,]*)*)\*([0-9A-Fa-f]{2})\r?")
LONGEST = 82  # with $ and line end


def fields(line: bytes) -> tuple[str, list[str]] | None:
    """Name and fields of the sentence at the end of `line`; None where it is none or its checksum is wrong."""
    sentence = line[max(line.rfind(b"$"), 0) :]
    found = SENTENCE.fullmatch(sentence)
    if found is None or len(sentence) > LONGEST or checksum(found[1] + found[2]) != int(found[3], 16):
        return None
    return found[1].decode(), [f.decode("latin-1") for f in found[2].split(b",")[1:]]


def looks_whole(line: bytes) -> bool:
    """Whether a sentence is there in form, so that only its checksum or its length can be wrong."""
    return SENTENCE.fullmatch(line[max(line.rfind(b"$"), 0) :]) is not None


def checksum(body: bytes) -> int:
    """Exclusive or of the bytes between $ and *."""
    return reduce(xor, body, 0)


def build(name: str, values: list[str]) -> bytes:
    """A sentence with its checksum and line end."""
    body = ",".join([name, *values]).encode()
    return b"$%b*%02X\r\n" % (body, checksum(body))
