"""When a signature is shown to have been there, by what: an RFC 3161 token, the lab's audit log, the archive.

`CAL.json.sshsig.tsr` is a time-stamping authority's reply for the bytes of `CAL.json.sshsig`, checked by the system's
`openssl ts`; `timestamp_ca.pem` among the lab's keys holds the certificates of those it believes.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import dataclass
from datetime import UTC, datetime
from http.client import HTTPException
from pathlib import Path
from queue import Empty, SimpleQueue
from tempfile import TemporaryDirectory
from threading import Thread
from typing import Literal
from urllib.request import Request, urlopen

from labcal.errors import InputError
from labcal.files import atomic
from labcal.files.home import for_children
from labcal.files.plain_file import read_limited

LARGEST_BYTES = 2**17
WITHIN_S = 60.0
BY = {"token": "its time-stamp token", "audit log": "the audit log", "archive": "the archive"}
ANSWERED_S = 20.0  # an authority that takes longer is not waited for
MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
_STAMP = re.compile(
    r"^Time stamp: ([A-Z][a-z]{2}) +(\d{1,2}) (\d\d):(\d\d):(\d\d)(?:\.\d+)? (\d{4}) GMT$", re.MULTILINE
)


@dataclass(frozen=True, slots=True)
class ShownTime:
    """A signature was there at `utc`, as something else than its signer shows."""

    utc: datetime
    by: Literal["token", "audit log", "archive"]

    def in_words(self, stated: str | None = None) -> str:
        """Time and source, and by how many days it is later than the date of issue that the file has `stated`."""
        said = f"no later than {self.utc:%Y-%m-%d %H:%M:%S} UTC, shown by {BY[self.by]}"
        days = self._days_after(stated)
        return f"{said}, {days} day{'s' * (days > 1)} after the file states it was issued" if days > 0 else said

    def _days_after(self, stated: str | None) -> int:
        try:
            return (self.utc - datetime.fromisoformat(stated or "")).days
        except (ValueError, TypeError):  # none is stated, or no time with its zone
            return 0


def claimed(utc: str | None) -> str:
    """The same of a time that only the file states."""
    return f"{utc}, claimed" if utc else "claimed: no time is stated"


def token_file(signature: Path) -> Path:
    """Where the token of a signature file lies."""
    return signature.with_name(f"{signature.name}.tsr")


def shown_utc(file: Path, signature: bytes, authorities: Path) -> datetime | None:
    """Since when the bytes of the signature file `file` are shown to be there; None without a token that holds."""
    openssl = shutil.which("openssl")
    if openssl is None or not authorities.exists():
        return None
    try:
        token = read_limited(token_file(file), LARGEST_BYTES)
    except (OSError, InputError):
        return None
    with TemporaryDirectory() as folder:
        data, reply = Path(folder) / "data", Path(folder) / "reply"
        data.write_bytes(signature)
        reply.write_bytes(token)
        of_reply = ["-in", str(reply)]
        if _asked(openssl, "ts", "-verify", "-data", str(data), *of_reply, "-CAfile", str(authorities)) is None:
            return None
        printed = _asked(openssl, "ts", "-reply", *of_reply, "-token_out", "-text")  # nobody signs the words beside it
    return None if printed is None else _time(printed)


def fetch_token(file: Path, url: str, authorities: Path) -> datetime:
    """Ask the time-stamping authority at `url` for a token of the signature `file`; it is kept beside it if it holds.

    Returns the time that it shows. Raises InputError, and nothing is kept, where none comes that holds.
    """
    openssl, signature = shutil.which("openssl"), read_limited(file, LARGEST_BYTES)
    if openssl is None:
        raise InputError("openssl, which makes and checks time-stamp tokens, is not installed")
    if not authorities.exists():
        raise InputError("the certificates of its authority are missing, by which a token is checked", file=authorities)
    with TemporaryDirectory() as folder:
        data, query = Path(folder) / "data", Path(folder) / "query"
        data.write_bytes(signature)
        made = _asked(openssl, "ts", "-query", "-data", str(data), "-sha256", "-cert", "-out", str(query))
        if made is None:
            raise InputError("openssl made no time-stamp query")
        reply = _answer(url, query.read_bytes())
        trial = Path(folder) / file.name
        token_file(trial).write_bytes(reply)
        if (shown := shown_utc(trial, signature, authorities)) is None:
            raise InputError(f"what {url} answered is no token that the certificates in {authorities.name} vouch for")
    atomic.write_bytes(token_file(file), reply)
    return shown


def _answer(url: str, query: bytes) -> bytes:
    """What the authority answers. Raises InputError where nothing comes in time, however slowly it drips."""
    heard: SimpleQueue[bytes | str] = SimpleQueue()
    Thread(target=lambda: heard.put(_posted(url, query)), daemon=True).start()
    try:
        answer = heard.get(timeout=ANSWERED_S)
    except Empty:
        answer = f"no answer within {ANSWERED_S:.0f} s"
    if isinstance(answer, str):
        raise InputError(f"{url}: {answer}")
    return answer


def _posted(url: str, query: bytes) -> bytes | str:
    """The bytes of the reply, or in words why there are none (RFC 3161, 3.4)."""
    request = Request(url, query, {"Content-Type": "application/timestamp-query"})
    try:
        with urlopen(request, timeout=ANSWERED_S) as reply:
            content: bytes = reply.read(LARGEST_BYTES + 1)
    except (OSError, HTTPException, ValueError) as fault:
        return str(fault) or type(fault).__name__
    return content if len(content) <= LARGEST_BYTES else f"answers more than {LARGEST_BYTES} bytes"


def _time(printed: str) -> datetime | None:
    if (found := _STAMP.search(printed)) is None or found[1] not in MONTHS:
        return None
    day, hour, minute, second, year = (int(found[i]) for i in range(2, 7))
    return datetime(year, MONTHS.index(found[1]) + 1, day, hour, minute, second, tzinfo=UTC)


def _asked(*words: str) -> str | None:
    try:
        done = subprocess.run(words, env=for_children(), capture_output=True, timeout=WITHIN_S)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout.decode(errors="replace") if done.returncode == 0 else None
