"""The window dies in a run: the worker brings the coils to zero, and the run may be gone on with."""

import io
import os
import time
from contextlib import nullcontext, suppress
from pathlib import Path

import pytest

from labcal import session
from labcal.errors import Stopped
from labcal.gui.bench_verbs import run
from labcal.gui.talk import STILL_S, Talk
from labcal.record.stream import Event
from labcal.store.live import Store

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
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
                talk.control.check()

    heard = os.fdopen(hears)
    talk = Talk(heard, Line(broken if way == "its ear is gone" else hung_up))
    talk.answer = lambda prompt: prompt.choices[0]
    asks = talk.asks()
    if way == "its mouth is gone":
        os.write(says, b'{"do": "run"}\n')
        assert next(asks) == {"do": "run"}
    ended = run(talk, "preflight", str(BENCH), SHORT, "EM-07", "J. Doe", seed=3)
    if way == "its ear is gone":
        os.close(says)
    else:
        assert list(asks) == []
    heard.close()
    assert ended["status"] == "interrupted"
    assert [one.status for one in session.runs()] == ["interrupted"]
    with Store.open() as store:
        *_, last = (item for item in store.items(ended["run_id"]) if isinstance(item, Event))
    assert (last.kind, last.text) == ("read-back", "coils at zero")


@pytest.mark.parametrize(("simulated", "beats", "left"), [(False, 1, True), (False, 0, False), (True, 1, False)])
def test_a_window_that_stands_still_while_real_coils_are_driven_has_gone(simulated, beats, left):
    hears, says = os.pipe()
    with os.fdopen(hears) as heard:
        talk = Talk(heard, io.StringIO())
        asks = talk.asks()
        os.write(says, b'{"do": "beat"}\n' * beats + b'{"do": "run"}\n')
        assert next(asks) == {"do": "run"}
        talk.on_bench(simulated)
        deadline = time.monotonic() + (30.0 if left else 3 * STILL_S)
        with pytest.raises(Stopped) if left else nullcontext():
            while time.monotonic() < deadline:
                talk.control.check()
                time.sleep(0.01)
        os.close(says)
        assert list(asks) == []


def test_a_window_that_moves_is_there():
    hears, says = os.pipe()
    with os.fdopen(hears) as heard:
        talk = Talk(heard, io.StringIO())
        asks = talk.asks()
        os.write(says, b'{"do": "beat"}\n{"do": "run"}\n')
        assert next(asks) == {"do": "run"}
        talk.on_bench(simulated=False)
        deadline, slowest, before = time.monotonic() + 3 * STILL_S, 0.0, time.monotonic()
        while time.monotonic() < deadline:
            os.write(says, b'{"do": "beat"}\n')
            time.sleep(0.2)
            slowest, before = max(slowest, time.monotonic() - before), time.monotonic()
            if slowest > STILL_S / 2:
                pytest.skip("this computer is too busy: the test itself stood still")
            talk.control.check()
        os.close(says)
        assert list(asks) == []
