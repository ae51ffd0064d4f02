"""Somebody at a terminal of his own who runs a labcal command, answers its questions, and keeps what it says."""

from __future__ import annotations

import fcntl
import json
import os
import select
import signal
import struct
import subprocess
import sys
import termios
import threading
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from prepared import Forked, prepared

LABCAL = [sys.executable, str(Path(__file__).with_name("launcher.py"))]
LOOK_S = 0.01
WIDE = struct.pack("HHHH", 50, 4000, 0, 0)  # so that no line of it is folded


class Technician:
    """`said`: each line with the machine's monotonic time at which it was read."""

    def __init__(self, command: list[str], env: Mapping[str, str]) -> None:
        self._terminal, its = os.openpty()
        fcntl.ioctl(its, termios.TIOCSWINSZ, WIDE)
        self.said = list[tuple[float, str]]()
        self._process: subprocess.Popen[bytes] | Forked
        if command[: len(LABCAL)] == LABCAL:
            self._process = prepared().fork(command[len(LABCAL) :], env, its)
        else:
            self._process = subprocess.Popen(
                command, stdin=its, stdout=its, stderr=its, env=env, start_new_session=True
            )
        os.close(its)
        self.pid = self._process.pid
        self._closed = threading.Event()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    @classmethod
    def runs(cls, words: list[str], env: Mapping[str, str]) -> Technician:
        """`labcal run …`."""
        return cls([*LABCAL, "run", *words, "--progress", "json"], env)

    def press_ctrl_c(self) -> None:
        """At the terminal."""
        with suppress(OSError):
            os.write(self._terminal, b"\x03")

    def close_the_terminal(self) -> None:
        """Hang up. Nobody may be reading then: the kernel keeps a terminal open as long as somebody does."""
        if not self._closed.is_set():
            self._closed.set()
            self._reader.join(2.0)
            os.close(self._terminal)

    @property
    def ended(self) -> bool:
        """Whether the command has ended."""
        return self._process.poll() is not None

    @property
    def code(self) -> int | None:
        """Its exit code; negative where a signal ended it."""
        return self._process.poll()

    def leave(self) -> None:
        """End the command, whatever it does."""
        with suppress(OSError):
            os.kill(self.pid, signal.SIGKILL)
        self._process.wait()
        self._reader.join(2.0)
        self.close_the_terminal()

    def words(self) -> list[tuple[float, str]]:
        """What it said, without the readings of items that say nothing about the lab."""
        return [(t_s, _spoken(line)) for t_s, line in list(self.said) if _spoken(line)]

    def _read(self) -> None:
        rest = b""
        while not self._closed.is_set():
            try:
                if not select.select([self._terminal], [], [], LOOK_S)[0]:
                    continue
                data = os.read(self._terminal, 65536)
            except OSError:
                break
            *lines, rest = (rest + data).split(b"\n")
            for line in lines:
                self._hear(line.decode("utf-8", "replace").strip().removeprefix("^C"))
        if rest:
            self._hear(rest.decode("utf-8", "replace").strip())

    def _hear(self, line: str) -> None:
        self.said.append((time.monotonic(), line))
        item = _item(line)
        if item.get("item") == "prompt":
            with suppress(OSError):
                os.write(self._terminal, ((item["choices"] or ["seen"])[0] + "\n").encode())


def _item(line: str) -> dict[str, object]:
    try:
        item = json.loads(line)
    except ValueError:
        return {}
    return item if isinstance(item, dict) else {}


def _spoken(line: str) -> str:
    item = _item(line)
    if not item:
        return line
    return str(item.get("text", "")) if item.get("item") in ("event", "end", "prompt") else ""


def processes_of(bench: Path) -> dict[str, list[int]]:
    """The living guardians of a bench file: {"guardian": […], "standby": […]}."""
    found: dict[str, list[int]] = {"guardian": [], "standby": []}
    for place in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            words = (place / "cmdline").read_bytes().split(b"\0")
            if b"labcal.bench.guardian" in words and os.fsencode(bench.resolve()) in words:
                which = "standby" if b"--standby" in words else "guardian"
                if (place / "stat").read_text().rpartition(")")[2].split()[0] != "Z":
                    found[which].append(int(place.name))
    return found
