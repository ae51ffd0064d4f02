"""A computer that sleeps while a row waits is no slow disk: from waking on the disk has its time, and no more."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from labcal.errors import InstrumentError
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Event
from labcal.store import Store

LATE_S = 0.5
WRITES = f"""
import os, signal, sys, time
from pathlib import Path
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Event
from labcal.store import Store
header = RunHeader("r", "2026-03-02T08:15:00Z", True, "", Dut("S"), Reference("none"))
with Store.open(Path(sys.argv[1])) as store, store.begin(header) as writer:
    writer.late_s = {LATE_S}
    time.sleep(0.6)
    writer.check()
    writer.write(Event(0.0, "note", "before it sleeps"))
    os.kill(os.getpid(), signal.SIGSTOP)
    writer.check()
    print("kept")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="nobody stops a process there by a signal")
def test_who_was_asleep_does_not_say_that_the_disk_is_slow(tmp_path: Path) -> None:
    writes = subprocess.Popen(
        [sys.executable, "-c", WRITES, str(tmp_path / "s.sqlite")], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert os.WIFSTOPPED(os.waitpid(writes.pid, os.WUNTRACED)[1])
    time.sleep(3 * LATE_S)
    os.kill(writes.pid, signal.SIGCONT)
    out, err = writes.communicate(timeout=30)
    assert out == b"kept\n", err.decode()


def test_a_disk_that_stands_still_is_late_though_nobody_looked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    header = RunHeader("r", "2026-03-02T08:15:00Z", True, "", Dut("S"), Reference("none"))
    with Store.open(tmp_path / "s.sqlite") as store, store.begin(header) as writer:
        writer.late_s = LATE_S
        with monkeypatch.context() as still:
            still.setattr(writer, "commit", lambda: time.sleep(0.01))  # nothing reaches the disk
            writer.write(Event(0.0, "note", "waits"))
            time.sleep(2 * LATE_S)  # nobody looks
            writer.check()
            time.sleep(1.2 * LATE_S)
            with pytest.raises(InstrumentError, match="did not take in time"):
                writer.check()
