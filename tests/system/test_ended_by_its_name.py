"""Whoever ends `labcal gui` by its name ends the window with it: none stays without its watch."""

import os
import signal
import subprocess
import sys
import time

import pytest

WATCH = """
import signal, sys
for name in {"SIGTERM", "SIGHUP"} & set(dir(signal)):
    signal.signal(getattr(signal, name), signal.SIG_DFL)  # whoever runs the tests may have it ignored, as nohup does
from labcal.system.window_watch import watch
window = "import os, sys, time; open(sys.argv[1], 'w').write(str(os.getpid())); time.sleep(60)"
sys.exit(watch((), print, (sys.executable, "-c", window, sys.argv[1])))
"""


def until(holds, seconds=20.0):
    ends = time.monotonic() + seconds
    while not holds() and time.monotonic() < ends:
        time.sleep(0.02)
    return holds()


def lives(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such signals")
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_the_window_ends_with_its_watch(tmp_path, number):
    told = tmp_path / "pid"
    environment = {**os.environ, "LABCAL_HOME": str(tmp_path / "home")}
    watch = subprocess.Popen([sys.executable, "-c", WATCH, str(told)], env=environment, start_new_session=True)
    try:
        assert until(lambda: told.exists() and told.read_text())
        window = int(told.read_text())
        watch.send_signal(number)
        assert watch.wait(timeout=20) == 128 + number
        assert until(lambda: not lives(window))
        assert not (tmp_path / "home" / "crashes").exists()  # it was wanted: nothing broke off
    finally:
        watch.kill()
        watch.wait()
        if told.exists() and lives(int(told.read_text())):
            os.kill(int(told.read_text()), signal.SIGKILL)
