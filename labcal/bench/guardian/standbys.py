"""The processes that stand by a guardian: they hear at once what has changed, and ten times a second that it lives."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time

from labcal.bench.guardian.briefing import Briefing
from labcal.bench.guardian.controller import Guardian
from labcal.bench.guardian.handover import DONE
from labcal.bench.guardian.spawn import STANDBY, spawn

HOW_MANY = 2  # so that a guardian and one of them may be killed together
PULSE_S = 0.1
AGAIN_S = 5.0  # until another one is started, where one has ended by itself


class Standbys:
    """Keeps `HOW_MANY` of them beside this process."""

    def __init__(self, bench: Briefing, guardian: Guardian) -> None:
        self._bench, self._guardian = bench, guardian
        self._processes: list[subprocess.Popen[bytes]] = []
        self._started, self._next_s, self._dismissed = 0, 0.0, threading.Event()
        self._hand, self._pipes = threading.Lock(), threading.Lock()
        guardian.notify = self.notify

    def start(self) -> None:
        """Keep them from now on, by a thread of its own."""
        threading.Thread(target=self._keep, daemon=True).start()

    def notify(self) -> None:
        """Have them know what holds now, before anything else is done."""
        self._say(self._guardian.handover().line())

    def dismiss(self) -> None:
        """They are not needed any more; one that does not hear, as it stands still, is ended."""
        self._dismissed.set()
        with self._hand:
            for process in self._say(DONE):
                process.kill()

    def _keep(self) -> None:
        changed = self._guardian.changed
        while not self._dismissed.is_set():
            changed.clear()
            with self._hand:
                if not self._dismissed.is_set():
                    self._fill_up()
            self.notify()
            changed.wait(PULSE_S)

    def _fill_up(self) -> None:
        """One at a time: the first is ready sooner."""
        self._processes = [process for process in self._processes if process.poll() is None]
        if len(self._processes) < HOW_MANY and time.monotonic() > self._next_s:
            self._started += 1
            self._next_s = time.monotonic() + (AGAIN_S if self._started >= HOW_MANY else 0.0)
            process = spawn(self._bench, STANDBY)
            assert process.stdin is not None
            if sys.platform != "win32":
                os.set_blocking(process.stdin.fileno(), False)  # one that stands still holds up nobody
            with self._pipes:
                self._processes.append(process)

    def _say(self, line: str) -> list[subprocess.Popen[bytes]]:
        """Say it to all; returns those who cannot hear it. A line is shorter than what a pipe takes in one piece."""
        with self._pipes:
            return [process for process in self._processes if not _heard(process, line.encode() + b"\n")]


def _heard(process: subprocess.Popen[bytes], line: bytes) -> bool:
    """Whether it heard; one that has ended need not."""
    assert process.stdin is not None
    try:
        os.write(process.stdin.fileno(), line)
    except BlockingIOError:
        return False
    except OSError:
        pass
    return True
