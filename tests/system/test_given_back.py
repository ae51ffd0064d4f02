"""What a computation has let go of goes back to the system."""

from __future__ import annotations

import platform
import subprocess
import sys

import pytest

KEEPS = """
import os, threading
from labcal.system.given_back import give_back_memory
def resident():
    return int(open("/proc/self/statm").read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6
pieces, last = [], []
def work():
    for _ in range(2000):
        pieces.append(bytearray(50_000))
    last.append(bytearray(50_000))  # the arena's end stays in use: nothing below it is given back by itself
some = threading.Thread(target=work)
some.start(); some.join()
pieces.clear()
before = resident()
give_back_memory()
print(before - resident())
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="there is no malloc_trim elsewhere than in glibc")
def test_free_pages_of_a_thread_that_has_ended_are_given_back() -> None:
    said = subprocess.run([sys.executable, "-c", KEEPS], capture_output=True, text=True, check=True)
    assert float(said.stdout) > 80
