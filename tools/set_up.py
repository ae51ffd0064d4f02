"""Set labcal up in a virtual environment, and never be silent for long about it. `make` calls it.

python3 tools/set_up.py .venv --editable '.[dev]'

Needs nothing but Python itself. Exit code: pip's own.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import threading
import time
from collections.abc import Iterable
from pathlib import Path
from typing import TextIO

OLDEST, TOO_NEW = (3, 11), (3, 14)
SILENCE_S = 3.0  # after which a sign of life is given
SHOWN = ("Collecting", "Downloading", "Installing", "Building", "Successfully", "ERROR", "error:", "WARNING: Retrying")
QUIETLY = ("--disable-pip-version-check", "--no-color")
SHORT = 100  # letters of a line


class Aloud:
    """Says lines, and after SILENCE_S without one how long it has taken and how much lies in the folder by now."""

    def __init__(self, folder: Path, out: TextIO) -> None:
        self._folder, self._out, self._begun = folder, out, time.monotonic()
        self._said_s, self._over = self._begun, threading.Event()
        threading.Thread(target=self._break_silence, daemon=True).start()

    def say(self, line: str) -> None:
        """One line, cut to a terminal's width."""
        self._said_s = time.monotonic()
        print("  " + line.strip()[:SHORT], file=self._out, flush=True)

    def end(self) -> None:
        """No sign of life after this."""
        self._over.set()

    def _break_silence(self) -> None:
        while not self._over.wait(0.2):
            if time.monotonic() - self._said_s > SILENCE_S:
                took_s = time.monotonic() - self._begun
                self.say(f"... {took_s:.0f} s, {packages_in(self._folder)} packages are in place")


def packages_in(folder: Path) -> int:
    """How many packages a virtual environment has by now."""
    return sum(1 for _ in folder.glob("lib/python*/site-packages/*.dist-info"))


def run(command: Iterable[str], aloud: Aloud) -> int:
    """Run a program and say the lines of it that tell where it stands; all of them where it fails."""
    lines = []
    environment = {**os.environ, "PYTHONUNBUFFERED": "1"}
    with subprocess.Popen(
        list(command), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", env=environment
    ) as process:
        for line in process.stdout or ():
            lines.append(line)
            if line.strip().startswith(SHOWN):
                aloud.say(line)
    if process.returncode:
        print("".join(lines[-30:]), file=sys.stderr)
    return process.returncode


def set_up(folder: Path, wanted: list[str], out: TextIO) -> int:
    """Make the virtual environment where there is none, and install what is wanted there. Returns an exit code."""
    aloud = Aloud(folder, out)
    python = str(folder / "bin" / "python")
    try:
        if not Path(python).exists():
            aloud.say(f"making {folder}")
            if run([sys.executable, "-m", "venv", str(folder)], aloud):
                print("no virtual environment could be made; on Debian: apt-get install python3-venv", file=sys.stderr)
                return 1
        # What is imported is compiled then, and kept: all of the packages at once took two fifths of the set-up.
        return run([python, "-m", "pip", "install", *QUIETLY, "--no-compile", *wanted], aloud)
    finally:
        aloud.end()


def main() -> int:
    """Set up; exit 2 where this Python is none that labcal runs on."""
    parser = argparse.ArgumentParser(description="Set labcal up in a virtual environment.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("wanted", nargs="+", help="what pip is asked to install")
    parser.add_argument("--editable", action="store_true", help="from this folder, as it is")
    given = parser.parse_args()
    if not OLDEST <= sys.version_info[:2] < TOO_NEW:
        print(f"labcal needs Python 3.11 to 3.13, python3 is {sys.version.split()[0]}; say PYTHON=python3.12 make ...",
              file=sys.stderr)  # fmt: skip
        return 2
    wanted = [part for one in given.wanted for part in (["--editable", one] if given.editable else [one])]
    return set_up(given.folder, wanted, sys.stdout)


if __name__ == "__main__":
    sys.exit(main())
