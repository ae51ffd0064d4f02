"""A window that goes while its worker takes the coils to zero, where no guardian lives, does not break that off."""

from __future__ import annotations

import io
import os
import threading
from pathlib import Path

import pytest

from labcal import session
from labcal.bench.coils.at_zero import AtZero
from labcal.gui.ipc import channel as channels
from labcal.gui.ipc.lines import write_line
from labcal.gui.ipc.messages import Request, SwitchOff
from labcal.gui.ipc.worker import serve

LONG_S = 30.0


def test_a_window_that_hangs_up_does_not_end_its_worker_on_the_way_to_zero(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    ended, at_zero = [], []
    reading, writing = (os.fdopen(end, mode) for end, mode in zip(os.pipe(), "rw", strict=True))

    def coming_down(_: Path) -> list[AtZero]:
        writing.close()
        [listener] = (thread for thread in threading.enumerate() if thread.name == "window")
        listener.join(LONG_S)
        at_zero.append(not ended)
        return []

    monkeypatch.setattr(channels.os, "_exit", ended.append)
    monkeypatch.setattr(session, "coils_off", coming_down)
    writing.write(write_line(Request(1, SwitchOff(str(tmp_path / "bench.toml")))) + "\n")
    writing.flush()
    with reading:
        serve(channels.Channel(reading, io.StringIO()))
    assert at_zero == [True]
