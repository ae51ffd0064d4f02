"""Ctrl-C in the terminal that the window was started from: it closes, in order and without a word."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from served_lab import until

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
COMMAND = [sys.executable, "-P", "-m", "labcal.gui", "--bench", str(BENCH)]
OF_THE_PLATFORM = "This plugin does not support"  # of a screen that is none

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows sends Ctrl-C to a console alone")


def workers(window):
    """The processes that it has started."""
    return Path(f"/proc/{window}/task/{window}/children").read_text().split()


def test_ctrl_c_closes_the_window(tmp_path):
    at_home = os.environ | {"LABCAL_HOME": str(tmp_path), "QT_QPA_PLATFORM": "offscreen"}
    with subprocess.Popen(COMMAND, env=at_home, stderr=subprocess.PIPE, text=True) as window:
        until(lambda: len(workers(window.pid)) >= 2)
        window.send_signal(signal.SIGINT)
        said = window.communicate(timeout=120)[1]
    assert window.returncode == 0
    assert [line for line in said.splitlines() if OF_THE_PLATFORM not in line] == []
