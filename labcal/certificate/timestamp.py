"""When a signature is shown to have been there: an RFC 3161 token beside it, of an authority that this lab trusts.

`CAL.json.sshsig.tsr` is a time-stamping authority's reply for the bytes of `CAL.json.sshsig`, checked by the system's
`openssl ts`; `timestamp_ca.pem` among the lab's keys holds the certificates of those it believes.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from datetime import UTC, datetime
from pathlib import Path
from tempfile import TemporaryDirectory

from labcal.certificate.calibration_file import read_limited
from labcal.errors import InputError
from labcal.files.home import for_children

LARGEST_BYTES = 2**17
WITHIN_S = 60.0
MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
_STAMP = re.compile(
    r"^Time stamp: ([A-Z][a-z]{2}) +(\d{1,2}) (\d\d):(\d\d):(\d\d)(?:\.\d+)? (\d{4}) GMT$", re.MULTILINE
)


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
        told = _asked(openssl, "ts", "-reply", *of_reply, "-text")
    return None if told is None else _time(told)


def _time(told: str) -> datetime | None:
    if (found := _STAMP.search(told)) is None or found[1] not in MONTHS:
        return None
    day, hour, minute, second, year = (int(found[i]) for i in range(2, 7))
    return datetime(year, MONTHS.index(found[1]) + 1, day, hour, minute, second, tzinfo=UTC)


def _asked(*words: str) -> str | None:
    try:
        done = subprocess.run(words, env=for_children(), capture_output=True, timeout=WITHIN_S)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout.decode(errors="replace") if done.returncode == 0 else None
