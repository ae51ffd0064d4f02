"""Runs tests in an order of chance: files shuffled, and the tests of each; whoever depends on the order fails.

    python tools/shuffle_tests.py SEED [PATH …] [-- PYTEST OPTIONS]

A test that fails here and not alone needs something that another one left behind.
"""

from __future__ import annotations

import random
import subprocess
import sys
import tempfile
from itertools import groupby
from pathlib import Path

NOT_SLOW = ("-m", "not slow")


def collected(paths: list[str], options: list[str]) -> list[str]:
    """Node ids of all tests, in their own order."""
    command = [sys.executable, "-m", "pytest", "--collect-only", "-q", *NOT_SLOW, *options, *paths]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return [line for line in done.stdout.splitlines() if "::" in line]


def shuffled(tests: list[str], seed: int) -> list[str]:
    """The files in an order of chance, and so the tests of each: a window is opened once for all tests of a file."""
    chance = random.Random(seed)
    files = [list(those) for _, those in groupby(tests, key=lambda test: test.split("::")[0])]
    chance.shuffle(files)
    for those in files:
        chance.shuffle(those)
    return [test for those in files for test in those]


def main() -> int:
    """Shuffle and run; pytest's own exit code."""
    given, _, options = " ".join(sys.argv[1:]).partition(" -- ")
    seed, *paths = given.split()
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as listed:
        listed.write("\n".join(shuffled(collected(paths or ["tests"], options.split()), int(seed))))
        listed.flush()
        command = [sys.executable, "-m", "pytest", "-q", *NOT_SLOW, *options.split(), f"@{Path(listed.name)}"]
        return subprocess.run(command, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
