"""Sessions without their two seconds of imports: forked from a `launcher.py` that has everything loaded already."""

from __future__ import annotations

import json
import socket
import subprocess
import sys
import threading
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

LAUNCHER = Path(__file__).with_name("launcher.py")
STARTS_S, ENDS_S = 60.0, 30.0


class Forked:
    """A session that was forked: as much of `subprocess.Popen` as a technician needs."""

    def __init__(self, pid: int, ends: threading.Event, codes: Mapping[int, int]) -> None:
        self.pid, self._ends, self._codes = pid, ends, codes

    def poll(self) -> int | None:
        """Its exit code; None while it runs, negative where a signal ended it."""
        return self._codes[self.pid] if self._ends.is_set() else None

    def wait(self) -> None:
        """Until it has ended. Raises TimeoutError where it does not."""
        if not self._ends.wait(ENDS_S):
            raise TimeoutError(f"process {self.pid} goes on")


class Prepared:
    """The launcher that forks, and who listens to what it says of its children."""

    def __init__(self) -> None:
        self._orders, its = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        command = [sys.executable, str(LAUNCHER), "--prepared"]
        self._process = subprocess.Popen(command, stdin=its, stdout=subprocess.DEVNULL, start_new_session=True)
        its.close()
        self._codes, self._ends = dict[int, int](), dict[int, threading.Event]()
        self._asking, self._begun, self._pid = threading.Lock(), threading.Event(), 0
        threading.Thread(target=self._listen, daemon=True).start()

    def fork(self, words: Sequence[str], env: Mapping[str, str], terminal: int) -> Forked:
        """A labcal with these words, whose terminal is this handle. Raises TimeoutError where none begins."""
        with self._asking:
            self._begun.clear()
            socket.send_fds(self._orders, [json.dumps({"words": list(words), "env": dict(env)}).encode()], [terminal])
            if not self._begun.wait(STARTS_S):
                raise TimeoutError("the launcher forks nothing")
            return Forked(self._pid, self._ends[self._pid], self._codes)

    def _listen(self) -> None:
        while message := self._orders.recv(4096):
            said = json.loads(message)
            pid = said["pid"]
            if "code" in said:
                self._codes[pid] = said["code"]
                self._ends[pid].set()
            else:
                self._ends[pid], self._pid = threading.Event(), pid
                self._begun.set()


@cache
def prepared() -> Prepared:
    """The one of this process."""
    return Prepared()
