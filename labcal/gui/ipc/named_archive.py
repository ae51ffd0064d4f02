"""Where the archive is that this window looks at: kept here, for what it opens, as a folder, has its environment."""

from __future__ import annotations

import os

from labcal.files.home import ARCHIVE

_told: list[str] = []


def take(url: str) -> None:
    """From here on it is `url`, else the one that the environment named, which names none any more."""
    by_environment = os.environ.pop(ARCHIVE, "")
    _told[:] = [url or by_environment]


def named() -> str:
    """Its URL, which may state a password; "" where nobody named one."""
    return _told[0] if _told else os.environ.get(ARCHIVE, "")
