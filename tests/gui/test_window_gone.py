"""The window dies in a run: the worker brings the coils to zero, and the run may be gone on with."""

import io
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, suppress
from pathlib import Path

import pytest

from labcal import session
from labcal.bench.coils.state import CoilReading, LabState
from labcal.errors import Stopped
from labcal.gui.ipc.bench_commands import run
from labcal.gui.ipc.channel import FROZEN_S, WAITS_S, Channel
from labcal.gui.ipc.lines import write_line
from labcal.gui.ipc.messages import Beat, ListRuns, Request, RunProcedure
from labcal.record.stream import Event
from labcal.store.live import Store

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
ASKED = Request(1, ListRuns())
ASK, BEAT = (f"{write_line(one)}\n".encode() for one in (ASKED, Beat()))
SHORT = {"axes": "x", "magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "zero_s": "3"}


class Line(io.StringIO):
    """To the window, which `dies` when the first turn begins."""

    def __init__(self, dies):
        super().__init__()
        self._dies, self._dead = dies, False

    def write(self, text):
        if not self._dead and "segment-opened" in text:
            self._dead = True
            self._dies()
        return len(text)


@contextmanager
def heard_by(said: bytes) -> Iterator[tuple[Channel, int]]:
    """A channel that got this and a first request, and where more can be said to it; hung up in the end."""
    hears, says = os.pipe()
    with os.fdopen(hears) as heard:
        channel = Channel(heard, io.StringIO())
        requests = channel.requests()
        os.write(says, said + ASK)
        assert next(requests) == ASKED
        try:
            yield channel, says
        finally:
            os.close(says)
        assert list(requests) == []


def broken():
    raise BrokenPipeError(32, "Broken pipe")


@pytest.mark.parametrize("way", ["its ear is gone", "its mouth is gone"])
def test_a_run_whose_window_has_died_is_interrupted_with_the_coils_at_zero(tmp_path, monkeypatch, way):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    hears, says = os.pipe()

    def hung_up():
        os.close(says)
        with suppress(Stopped):
            while True:
                channel.control.check()

    heard = os.fdopen(hears)
    channel = Channel(heard, Line(broken if way == "its ear is gone" else hung_up))
    channel.answer = lambda prompt: prompt.choices[0]
    requests = channel.requests()
    if way == "its mouth is gone":
        os.write(says, ASK)
        assert next(requests) == ASKED
    ended = run(channel, RunProcedure("preflight", str(BENCH), SHORT, "EM-07", "J. Doe", seed=3))
    if way == "its ear is gone":
        os.close(says)
    else:
        assert list(requests) == []
    heard.close()
    assert ended.status == "interrupted"
    assert [one.status for one in session.runs()] == ["interrupted"]
    with Store.open() as store:
        *_, last = (item for item in store.items(ended.run_id) if isinstance(item, Event))
    assert (last.kind, last.text) == ("read-back", "coils at zero")


@pytest.mark.parametrize(("simulated", "beats", "left"), [(False, 1, True), (False, 0, False), (True, 1, False)])
def test_a_window_that_stands_still_while_real_coils_are_driven_has_gone(simulated, beats, left):
    with heard_by(BEAT * beats) as (channel, _):
        channel.run_begins(simulated)
        deadline = time.monotonic() + (30.0 if left else 3 * FROZEN_S)
        with pytest.raises(Stopped) if left else nullcontext():
            while time.monotonic() < deadline:
                channel.control.check()
                time.sleep(0.01)


@pytest.mark.parametrize("current_A", [0.0, 1.1])
def test_a_window_that_stands_still_with_the_coils_at_zero_ends_no_run(current_A):
    with heard_by(BEAT) as (channel, _):
        channel.run_begins(simulated=False)
        still_s, deadline = time.monotonic(), time.monotonic() + (30.0 if current_A else 3 * FROZEN_S)
        with pytest.raises(Stopped, match="stood still") if current_A else nullcontext():
            while time.monotonic() < deadline:
                now = time.monotonic()
                flows_A = current_A if now - still_s > 1.5 * FROZEN_S else 0.0  # it is energised behind its back
                channel.send_state(LabState((CoilReading("x", flows_A, flows_A, flows_A == 0.0, read_s=now),)))
                channel.control.check()
                time.sleep(0.01)


def test_a_window_that_moves_is_there():
    with heard_by(BEAT) as (channel, says):
        channel.run_begins(simulated=False)
        deadline, slowest, before = time.monotonic() + 3 * FROZEN_S, 0.0, time.monotonic()
        while time.monotonic() < deadline:
            os.write(says, BEAT)
            time.sleep(0.2)
            slowest, before = max(slowest, time.monotonic() - before), time.monotonic()
            if slowest > FROZEN_S / 2:
                pytest.skip("this computer is too busy: the test itself stood still")
            channel.control.check()


def test_one_that_is_late_on_a_busy_computer_is_waited_for_and_the_run_goes_on():
    with heard_by(BEAT) as (channel, says):
        channel.run_begins(simulated=False)
        late_s = time.monotonic() + WAITS_S + 1.0
        while time.monotonic() < late_s:
            channel.control.check()
            time.sleep(0.01)
        assert channel.control.paused()
        for _ in range(5):
            os.write(says, BEAT)
            time.sleep(0.1)
        assert not channel.control.paused()
        channel.control.check()
