"""`labcal bench off` without a guardian, killed while the coils come down: they come down all the same."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest
from served_lab import LABCAL, LONG_S, Served, at_zero, example, until
from test_off import left_on

from labcal.bench.stage_off import StageStop

SLOW = example().replace("interface_lock = true, ", "").replace("ramp_A_per_s = 2.0", "ramp_A_per_s = 0.1")

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="needs ptys, and to know a process's children")


def children(pid: int) -> list[int]:
    """Those that bring coils down: the one that stops the platform has its own command line."""
    found = list[int]()
    for word in Path(f"/proc/{pid}/task/{pid}/children").read_text().split():
        with suppress(OSError):  # one that has ended since
            found += [int(word)] * (b"labcal.bench.stage_off" not in Path(f"/proc/{word}/cmdline").read_bytes())
    return found


def coming_down(lab: Served) -> tuple[subprocess.Popen[str], int]:
    """`labcal bench off` and its child, while the current of coil x falls."""
    left_on(lab)
    off = subprocess.Popen([*LABCAL, "bench", "off", str(lab.file)], stdout=subprocess.PIPE, text=True)
    until(lambda: lab.currents()["x"] < 0.39)
    until(lambda: len(children(off.pid)) == 1)  # the platform's is named so once it has begun
    (child,) = children(off.pid)
    assert lab.currents()["x"] > 0.1
    return off, child


@pytest.mark.parametrize("bench_text", [SLOW], ids=["slow"])
def test_its_kill_leaves_the_coils_on_their_way_to_zero(lab: Served) -> None:
    off, _ = coming_down(lab)
    os.kill(off.pid, signal.SIGKILL)
    off.communicate(timeout=LONG_S)
    until(lambda: at_zero(lab))


@pytest.mark.parametrize("bench_text", [SLOW], ids=["slow"])
def test_the_kill_of_its_child_is_made_good_and_the_report_comes(lab: Served) -> None:
    off, child = coming_down(lab)
    os.kill(child, signal.SIGKILL)
    said, _ = off.communicate(timeout=LONG_S)
    assert off.returncode == 0, said
    assert said.count("zero, open") == 3
    assert at_zero(lab)


@pytest.mark.parametrize("bench_text", [example()], ids=["example"])
def test_a_platform_that_was_stopped_was_read_just_now_by_the_clock_that_everybody_has(lab: Served) -> None:
    stage = StageStop(lab.file)
    stage.begin()
    read = stage.ended(LONG_S)
    assert read is not None
    assert read.sentence(time.monotonic()).startswith("platform stands at ")
    assert read.read_s is not None
    assert 0.0 <= time.monotonic() - read.read_s < LONG_S
