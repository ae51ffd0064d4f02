"""What is done for the next push as soon as a run has ended."""

from __future__ import annotations

import subprocess
import sys
from contextlib import suppress

from labcal.archive import ready
from labcal.files.home import for_children
from labcal.runner import Outcome

DETACHED = 0x00000208  # DETACHED_PROCESS | CREATE_NEW_PROCESS_GROUP
_started: list[subprocess.Popen[bytes]] = []  # kept: they go on when this process has forgotten them


def begin_to_make_ready(outcome: Outcome) -> None:
    """Have a finished run made ready by a process of its own, where there was a push before; nobody waits for it.

    It stays in this session: Linux weighs a session of its own as a whole, whatever the priorities in it.
    """
    if outcome.status != "finished" or not ready.folder().is_dir():
        return
    words = [sys.executable, "-P", "-m", "labcal.archive.make_ready", outcome.run_id]
    with suppress(OSError):
        child = subprocess.Popen(
            words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=for_children(),
            creationflags=DETACHED if sys.platform == "win32" else 0,
        )  # fmt: skip
        _started[:] = [started for started in _started if started.poll() is None] + [child]
