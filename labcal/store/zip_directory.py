"""The list of files at the end of a zip, looked at before anything reads it: a hostile one takes minutes and gigabytes.

PKWARE's APPNOTE, 4.3.16: the end of central directory record, 22 bytes and a comment.
"""

from __future__ import annotations

from pathlib import Path
from struct import unpack_from

from labcal.errors import InputError
from labcal.store.limits import DIRECTORY, MiB

END, LOCATOR = b"PK\x05\x06", b"PK\x06\x07"
LENGTH, LONGEST_COMMENT, OF_LOCATOR = 22, 1 << 16, 20


def refuse_a_long_directory(path: Path) -> None:
    """Raise InputError where the zip at `path` lists more than a bundle may have, or is of the kind for gigabytes."""
    with path.open("rb") as file:
        size = file.seek(0, 2)
        file.seek(max(0, size - LENGTH - LONGEST_COMMENT - OF_LOCATOR))
        tail = file.read()
    at = len(tail) - LENGTH if tail[-LENGTH:].startswith(END) else tail.rfind(END)
    if at < 0 or len(tail) < at + LENGTH:
        raise InputError("not a readable zip file: it has no list of its files", file=path)
    (length,) = unpack_from("<I", tail, at + 12)
    if tail[max(0, at - OF_LOCATOR) : at].startswith(LOCATOR):
        raise InputError("is a zip of the kind for files of gigabytes (zip64): zip the bundle anew", file=path)
    if length > DIRECTORY:
        raise InputError(f"the zip lists more files than {DIRECTORY // MiB} MiB hold; a bundle has two", file=path)
