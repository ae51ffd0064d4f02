"""When a heartbeat goes on and when it ends, without processes: lines and a loop of the tests' own."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from labcal.bench.config import read_config
from labcal.bench.guardian import heartbeat
from labcal.bench.guardian.heartbeat import Heartbeats
from labcal.bench.loading import load_bench
from labcal.bench.roles import Identity
from labcal.errors import InputError, InstrumentError

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
LONG_S = 60.0
SETTINGS = {"guard": SimpleNamespace(watchdog_s=0.15), "supply_x": SimpleNamespace(watchdog_s=0.15)}


@dataclass
class FakeLine:
    """A line with one instrument, that writes down what it is told."""

    lock: Any = field(default_factory=threading.RLock)
    said: list[str] = field(default_factory=list)
    error: Exception | None = None
    loader: Any = None
    watchdog_s: float = 0.15

    def __post_init__(self) -> None:
        self.loader = SimpleNamespace(driver=lambda name: (None, {}, SETTINGS.get(name, SimpleNamespace())))

    def instrument(self, name: str) -> FakeLine:
        return self

    def identify(self, name: str) -> Identity:
        return Identity("", "", "")

    def reopen(self) -> None:
        self.said.append("reopen")

    def feed(self) -> None:
        self._tell("feed")

    def arm(self) -> None:
        self._tell("arm")

    def disarm(self) -> None:
        self._tell("disarm")

    def _tell(self, word: str) -> None:
        if self.error is not None:
            raise self.error
        self.said.append(word)


class Loop:
    """The guardian's loop, as far as heartbeats see it."""

    def __init__(self, tmp_path: Path) -> None:
        self.at_rest, self.in_doubt = True, False
        self.lines = {"guard": FakeLine(), "supply_x": FakeLine(), "supply_y": FakeLine()}
        text = EXAMPLE.read_text(encoding="utf-8") + interlock("emulated://")
        (tmp_path / "bench.toml").write_text(text, encoding="utf-8")
        self.notes = list[str]()
        lines: Any = self.lines
        self.beats = Heartbeats(read_config(tmp_path / "bench.toml"), lines, self.notes.append)
        self.see()
        self.beats.start()

    def see(self) -> None:
        self.beats.see(at_rest=self.at_rest, in_doubt=self.in_doubt)

    def until(self, true: Callable[[], bool]) -> None:
        begun = time.monotonic()
        while not true():
            assert time.monotonic() - begun < LONG_S, self.lines
            self.see()
            time.sleep(0.01)


def interlock(link: str) -> str:
    return f'\n[instruments.guard]\ndriver = "waveshare-interlock"\nlink = "{link}"\nrole = "interlock"\n'


@pytest.fixture
def loop(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Loop]:
    monkeypatch.setattr(heartbeat, "AGAIN_S", 0.05)
    monkeypatch.setattr(heartbeat, "ARM_S", 0.5)
    running = Loop(tmp_path)
    yield running
    running.beats.stop()


def test_an_interlock_is_closed_at_rest_and_fed_and_a_supply_without_a_watchdog_is_left_alone(loop: Loop) -> None:
    loop.until(lambda: loop.lines["guard"].said.count("feed") > 3)
    assert loop.lines["guard"].said[:2] == ["arm", "feed"]
    assert set(loop.lines["supply_x"].said) == {"feed"}
    assert loop.lines["supply_y"].said == []
    loop.beats.refuse()
    loop.beats.stop()
    assert loop.lines["guard"].said[-1] == "disarm"


def test_it_is_opened_where_zero_is_in_doubt_and_closed_again_at_rest_only(loop: Loop) -> None:
    guard = loop.lines["guard"]
    loop.until(lambda: "feed" in guard.said)
    loop.at_rest, loop.in_doubt = False, True
    loop.until(lambda: guard.said[-1] == "disarm")
    with pytest.raises(InstrumentError, match=r"guard: the interlock is open") as caught:
        loop.beats.refuse()
    assert caught.value.fault == "interlock"
    fed = len(loop.lines["supply_x"].said)
    loop.in_doubt = False
    loop.until(lambda: len(loop.lines["supply_x"].said) > fed + 3)
    assert guard.said[-1] == "disarm"
    loop.at_rest = True
    loop.until(lambda: guard.said[-2:] == ["arm", "feed"])


@pytest.mark.parametrize("error", [InstrumentError("no reply.", fault="silent"), RuntimeError("no reply.")])
@pytest.mark.parametrize("name", ["guard", "supply_x"])
def test_a_beat_that_goes_wrong_is_named_bars_energising_and_is_tried_again(
    loop: Loop, name: str, error: Exception
) -> None:
    loop.until(lambda: "feed" in loop.lines["guard"].said)
    loop.lines[name].error = error
    loop.until(lambda: loop.beats.fault is not None)
    with pytest.raises(InstrumentError, match=rf"^{name}: .*no reply\."):
        loop.beats.refuse()
    assert [note for note in loop.notes if note.startswith(f"heartbeat of {name}: ")]
    loop.lines[name].error = None
    loop.until(lambda: loop.beats.fault is None)
    loop.until(lambda: loop.lines[name].said[-1] == "feed")
    loop.beats.refuse()


def test_a_loop_that_hangs_ends_the_beats(loop: Loop, monkeypatch: pytest.MonkeyPatch) -> None:
    guard = loop.lines["guard"]
    loop.until(lambda: "feed" in guard.said)
    monkeypatch.setattr(heartbeat, "LOOP_S", -1.0)  # whatever was seen is too long ago
    begun = time.monotonic()
    heard = list[int]()
    while len(heard) < 2 or heard[-1] != heard[-2]:  # a beat may be on its way
        assert time.monotonic() - begun < LONG_S
        time.sleep(0.5)
        heard.append(len(guard.said))
    assert guard.said[-1] == "feed"


def test_a_line_that_is_busy_holds_no_other_beat_up(loop: Loop) -> None:
    with loop.lines["supply_x"].lock:
        fed = len(loop.lines["guard"].said)
        loop.until(lambda: len(loop.lines["guard"].said) > fed + 3)


def test_an_interlock_on_a_line_with_others_is_refused(tmp_path: Path) -> None:
    text = EXAMPLE.read_text(encoding="utf-8")
    of_relay = 'driver = "waveshare-relay"\nlink = "emulated://'
    assert of_relay in text
    bench = tmp_path / "bench.toml"
    bench.write_text(text.replace(of_relay, f"{of_relay}pair") + interlock("emulated://pair"), encoding="utf-8")
    with pytest.raises(InputError, match="a line of its own, and reversers has this one too") as caught:
        load_bench(bench, None, 1)
    assert caught.value.line is not None


def test_on_a_bench_that_is_emulated_altogether_the_contact_counts_as_bridged(tmp_path: Path) -> None:
    bench = tmp_path / "bench.toml"
    bench.write_text(EXAMPLE.read_text(encoding="utf-8") + interlock("emulated://"), encoding="utf-8")
    with load_bench(bench, None, 1) as loaded:
        loaded.identities()
        loaded.cage.set_currents([0.5, 0.4, 0.3])
        assert loaded.cage.currents_A() == pytest.approx([0.5, 0.4, 0.3], abs=0.01)
