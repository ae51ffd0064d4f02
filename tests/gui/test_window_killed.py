"""The window and its worker on supplies of real lines: both killed, and the guardian brings the coils to zero."""

import os
import signal
import subprocess
import sys
from datetime import UTC, datetime
from pathlib import Path

import pytest
from served_lab import Served, at_zero, example, guardians, log, read_back_after, until

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform == "win32", reason="needs SIGKILL and ptys, which Windows lacks"),
]
IN_TIME_S = 2.0
WINDOW = Path(__file__).parents[1] / "campaign" / "window_at_work.py"


@pytest.fixture
def lab(tmp_path, monkeypatch):
    served = Served(tmp_path, monkeypatch, example())
    yield served
    served.close()


def at_zero_after(begun):
    """When every coil was first read back at zero after `begun`, by the guardian's own stamp."""
    lines = [line for line in log().splitlines() if line.count("zero, open") == 3]
    return min(at for at in (datetime.fromisoformat(line.split()[0]) for line in lines) if at > begun)


@pytest.mark.parametrize("whom", ["the worker", "the window", "both"])
def test_whoever_is_killed_the_coils_come_to_zero(lab, tmp_path, whom):
    command = [sys.executable, str(WINDOW), str(lab.file), str(tmp_path / "window.ini")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as window:
        worker = int(window.stdout.readline())
        until(lambda: max(lab.currents().values()) > 0.5)
        begun = datetime.now(UTC)
        for pid in {"the worker": (worker,), "the window": (window.pid,), "both": (window.pid, worker)}[whom]:
            os.kill(pid, signal.SIGKILL)
        until(lambda: at_zero(lab))
        until(lambda: read_back_after("a session begins"))
        window.kill()
    until(lambda: not guardians())
    took_s = (at_zero_after(begun) - begun).total_seconds()
    print(f"{whom}: zero after {took_s:.2f} s, by the guardian's own log")
    assert took_s < IN_TIME_S
