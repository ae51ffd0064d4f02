"""What processes are given to do in tests: they import it by this name."""

from __future__ import annotations

import os
import time
from pathlib import Path

from labcal.errors import InputError


def upper(name: str) -> str:
    """The name in capitals; one that does not fit is refused."""
    if "bad" in name:
        raise InputError(f"{name} does not fit its chain", file="store", line=3)
    return name.upper()


def noted(name: str) -> float:
    """When it began; until half a second later, for what is called a large one."""
    begun = time.monotonic()
    time.sleep(0.5 if "large" in name else 0.05)
    return begun


def deadly(name: str) -> int:
    """The process that did it; the first that is given "deadly" ends at once, and leaves a file that says so."""
    folder, _, what = name.rpartition("/")
    said = Path(folder, "died")
    if what == "deadly" and not said.exists():
        said.touch()
        os.kill(os.getpid(), 9)
    return os.getpid()


def about_it(_: str) -> tuple[int, dict[str, str]]:
    """The process's niceness and environment."""
    return os.nice(0), dict(os.environ)
