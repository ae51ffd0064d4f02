"""What the guardian did, when and why: one line each in `guardian.log` of the user's data folder."""

from __future__ import annotations

import os
from datetime import UTC, datetime

from labcal.home import home


def note(text: str) -> None:
    """Append a line with the UTC time and the process; a disk that is full does not keep the coils from zero."""
    line = f"{datetime.now(UTC):%Y-%m-%dT%H:%M:%S.%f}Z [{os.getpid()}] {text}\n"
    try:
        home().mkdir(parents=True, exist_ok=True)
        with (home() / "guardian.log").open("a", encoding="utf-8") as log:
            log.write(line)
    except OSError:
        pass
