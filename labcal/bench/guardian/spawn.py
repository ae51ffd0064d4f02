"""Starts a guardian that outlives whoever starts it: a session of its own, no terminal, no Ctrl-C."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from labcal.home import home

STANDBY, SUCCESSOR = "--standby", "--successor"  # beside one that lives; after one that died
DETACHED = 0x00000208  # DETACHED_PROCESS | CREATE_NEW_PROCESS_GROUP
_started: list[subprocess.Popen[bytes]] = []  # kept: they go on when this process has forgotten them


def spawn(path: Path, *options: str, stdin: int = subprocess.DEVNULL) -> subprocess.Popen[bytes]:
    """Run `python -m labcal.bench.guardian PATH` on its own."""
    home().mkdir(parents=True, exist_ok=True)
    with (home() / "guardian.log").open("ab") as log:
        child = subprocess.Popen(
            [sys.executable, "-m", "labcal.bench.guardian", str(path.resolve()), *options],
            stdin=stdin, stdout=subprocess.DEVNULL, stderr=log,
            start_new_session=True, creationflags=DETACHED if sys.platform == "win32" else 0,
        )  # fmt: skip
    _started[:] = [started for started in _started if started.poll() is None] + [child]
    return child
