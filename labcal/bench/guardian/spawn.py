"""Starts a guardian that outlives whoever starts it: a session of its own, no terminal, no Ctrl-C."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from typing import IO

from labcal.bench.guardian.briefing import BRIEFED, Briefing
from labcal.files.atomic import absolute
from labcal.files.home import file_at_home, for_children

STANDBY, SUCCESSOR = "--standby", "--successor"  # beside one that lives; after one that died
DETACHED = 0x00000208  # DETACHED_PROCESS | CREATE_NEW_PROCESS_GROUP
_started: list[subprocess.Popen[bytes]] = []  # kept: they go on when this process has forgotten them


def spawn(bench: Briefing, *options: str) -> subprocess.Popen[bytes]:
    """Run `python -m labcal.bench.guardian PATH` on its own, briefed; nothing is loaded from the current folder."""
    with _log() as log:
        child = subprocess.Popen(
            [sys.executable, "-P", "-m", "labcal.bench.guardian", str(absolute(bench.named)), *options, BRIEFED],
            stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=log, env=for_children(),
            start_new_session=True, creationflags=DETACHED if sys.platform == "win32" else 0,
        )  # fmt: skip
    assert child.stdin is not None
    with suppress(OSError):  # it has ended already; that is seen elsewhere
        os.write(child.stdin.fileno(), bench.line())
    if STANDBY not in options:
        child.stdin.close()
    _started[:] = [started for started in _started if started.poll() is None] + [child]
    return child


def _log() -> IO[bytes]:
    """Where its last words go; nowhere, if there is no place for a log: coils come to zero without one too."""
    try:
        log = os.open(file_at_home("guardian.log"), os.O_WRONLY | os.O_APPEND | getattr(os, "O_NONBLOCK", 0))
        if stat.S_ISREG(os.fstat(log).st_mode):  # a pipe would be waited for once it is full
            return os.fdopen(log, "ab")
        os.close(log)
    except OSError:
        pass
    return Path(os.devnull).open("ab")
