"""What a guardian hands to the one that stands by, and that its successor asks no more than who is there."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from served_lab import three_on_one_pair

from labcal.bench.clock import Clock, RealClock, VirtualClock
from labcal.bench.config import read_config
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.guardian.controller import Guardian
from labcal.bench.guardian.handover import DONE, Handover, Held, handover_of, stand_by, unknown

AMPERES = {"x": 1.8, "y": 0.7, "z": 0.3}
KNOWN = Handover(0.5, {"x": Held(1.8, True, Identity("Riden", "RD6006", "00020120", "1.35")), "y": Held()})
CURRENT, SERIAL = b"\0\x09", 2  # of a Riden's registers


@pytest.mark.parametrize(
    ("said", "heard"),
    [
        ([Handover().line(), KNOWN.line()], ("ended", KNOWN)),
        ([KNOWN.line(), KNOWN.line()[:40]], ("ended", unknown())),
        ([KNOWN.line(), "[1]", '{"exchanges_s": null}'], ("ended", unknown())),
        ([], ("ended", unknown())),
        ([KNOWN.line(), DONE, KNOWN.line()], (DONE, Handover())),
    ],
    ids=["killed", "killed in a word", "spoilt", "killed at once", "done"],
)
def test_what_was_said_last_counts(said: list[str], heard: tuple[str, Handover]) -> None:
    assert stand_by(said, hung_s=60.0) == heard


def test_one_that_is_silent_is_replaced_with_what_it_said_last(monkeypatch: pytest.MonkeyPatch) -> None:
    hushed, over, start = threading.Event(), threading.Event(), threading.Thread.start

    def said() -> Iterator[str]:
        yield KNOWN.line()
        hushed.set()
        over.wait()

    def begun(thread: threading.Thread) -> None:
        start(thread)
        hushed.wait()

    monkeypatch.setattr(threading.Thread, "start", begun)  # what was said has been heard before the silence is timed
    assert stand_by(said(), hung_s=0.01) == ("silent", KNOWN)
    over.set()


LISTENS = """
import sys
from labcal.bench.guardian.handover import stand_by
print("listening", flush=True)
print(stand_by(sys.stdin, hung_s=5.0)[0])
"""


@pytest.mark.skipif(sys.platform == "win32", reason="needs SIGSTOP, which Windows lacks")
def test_who_was_stopped_itself_replaces_nobody_when_it_wakes() -> None:
    with subprocess.Popen([sys.executable, "-c", LISTENS], stdin=-1, stdout=-1, text=True, bufsize=1) as standby:
        assert standby.stdin is not None
        assert standby.stdout is not None
        assert standby.stdout.readline() == "listening\n"
        standby.stdin.write(KNOWN.line() + "\n")
        os.kill(standby.pid, signal.SIGSTOP)
        time.sleep(6.0)  # longer than a guardian may be silent, and nothing is said meanwhile
        os.kill(standby.pid, signal.SIGCONT)
        time.sleep(1.0)
        with suppress(BrokenPipeError):
            standby.stdin.write(DONE + "\n")
        assert standby.stdout.read() == f"{DONE}\n"


class Pair:
    """Three Ridens on one emulated pair with a clock of their own, and the frames that went to them."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch, clock: Clock | None = None) -> None:
        self.clock, self.sent = clock or VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), list[bytes]()
        monkeypatch.setattr("labcal.bench.guardian.owned_lines.RealClock", lambda: self.clock)
        monkeypatch.setattr("labcal.bench.guardian.duty.runtime_folder", lambda: folder)
        self.file, self.noted = folder / "bench.toml", list[str]()
        self.file.write_text(three_on_one_pair(), encoding="utf-8")
        self.links: dict[str, Any] = {}

    def guardian(self, handed: Handover | None = None) -> Guardian:
        """One that has this pair."""
        guardian = Guardian(self.file, read_config(self.file), self.noted.append, handed)
        for coil in guardian.coils.values():
            coil.line.loader.links = self.links
        return guardian

    def listen(self) -> Any:
        """Keep the frames from now on; returns the emulator."""
        emulator = next(link for url, link in self.links.items() if url == "emulated://pair")._emulator
        take = emulator.take
        emulator.take = lambda t_s, data: (self.sent.append(data), take(t_s, data))[1]
        return emulator


@pytest.fixture
def pair(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Pair:
    """Three supplies at rest."""
    return Pair(tmp_path, monkeypatch)


def handed_over(pair: Pair) -> Handover:
    """What the guardian that has energised them hands over."""
    first = pair.guardian()
    assert all(end.opened for end in first.zero("a session begins", by_session=True))
    for axis, amperes in AMPERES.items():
        first.output(axis, True)
        for step in range(1, 11):
            pair.clock.wait_until(pair.clock.now() + 0.1)
            first.set_current(axis, amperes * step / 10)
    return handover_of(first.handover().line())


def test_a_successor_asks_who_is_there_and_nothing_else_before_it_ramps(pair: Pair) -> None:
    handed = handed_over(pair)
    assert {axis: held.held_A for axis, held in handed.coils.items()} == AMPERES
    pair.listen()
    begun_s = pair.clock.now()
    ended = pair.guardian(handed).zero("a guardian was killed")
    first_write = next(n for n, frame in enumerate(pair.sent) if frame[1] != 3)
    assert [frame[:6] for frame in pair.sent[:first_write]] == [bytes([n, 3, 0, 0, 0, 4]) for n in (1, 2, 3)]
    assert [end.words for end in ended] == ["zero, open"] * 3
    assert pair.clock.now() - begun_s < 2.0  # of the lab's time, with every read-back and every output


def test_a_step_on_its_way_is_asked_for(pair: Pair, monkeypatch: pytest.MonkeyPatch) -> None:
    handed = handed_over(pair)
    coils = {**handed.coils, "y": Held(None, True, handed.coils["y"].who)}
    pair.listen()
    pair.guardian(Handover(handed.exchanges_s, coils)).zero("a guardian was killed")
    first_write = next(n for n, frame in enumerate(pair.sent) if frame[1] != 3)
    assert [frame[0] for frame in pair.sent[:first_write] if frame[2:4] == CURRENT] == [2]


def test_another_supply_than_before_hears_zero_and_off_before_it_is_refused(pair: Pair) -> None:
    handed = handed_over(pair)
    who = handed.coils["y"].who
    assert who is not None
    coils = {**handed.coils, "y": Held(0.7, True, Identity(who.manufacturer, who.model, "99999999", who.firmware))}
    pair.listen()
    ended = {end.axis: end for end in pair.guardian(Handover(0.0, coils)).zero("a guardian was killed")}
    assert [ended[axis].words for axis in "xz"] == ["zero, open"] * 2
    assert ended["y"].fault is not None
    assert ended["y"].fault.fault == "another instrument"
    assert {frame[:6] for frame in pair.sent if frame[0] == 2 and frame[1] != 3} == {
        b"\x02\x06\x00\x09\x00\x00", b"\x02\x06\x00\x12\x00\x00"
    }  # fmt: skip


@pytest.fixture
def in_real_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Pair:
    """The same, for lines that work at the same time: each would move a clock of their own on past others' answers."""
    return Pair(tmp_path, monkeypatch, RealClock())


@pytest.mark.parametrize("end", ["close", "give_back"])
def test_at_its_end_the_supplies_are_given_back_to_their_panels(in_real_time: Pair, end: str) -> None:
    pair = in_real_time
    text = pair.file.read_text(encoding="utf-8").replace("riden-rd60xx", "ea-9000").replace("//pair", "//")
    pair.file.write_text(re.sub(r"address = \d", "address = 0", text), encoding="utf-8")
    guardian = pair.guardian()
    guardian.zero("a session begins", by_session=True)
    guardian.output("x", True)
    guardian.set_current("x", 0.05)
    guardian.give_back()  # not what is energised
    panels = [link._emulator for link in pair.links.values()]
    (energised,) = [emulator for emulator in panels if emulator._bits[402]]
    assert guardian.measure_current("x") == pytest.approx(0.05, abs=0.002)
    assert not any(axis.fault for axis in guardian.zero("the session ends", by_session=True))
    assert energised._bits[402]
    getattr(guardian, end)()
    assert [emulator._bits[402] for emulator in panels] == [False] * 3


def test_a_supply_that_is_slow_to_take_its_panel_back_keeps_no_other_line_waiting(in_real_time: Pair) -> None:
    pair = in_real_time
    text = pair.file.read_text(encoding="utf-8").replace("riden-rd60xx", "ea-9000").replace("//pair", "//")
    pair.file.write_text(re.sub(r"address = \d", "address = 0", text), encoding="utf-8")
    guardian, all_asked = pair.guardian(), threading.Barrier(3, timeout=20.0)
    guardian.zero("a session begins", by_session=True)
    for emulator in (panels := [link._emulator for link in pair.links.values()]):
        take = emulator.take
        emulator.take = lambda t_s, data, take=take: (all_asked.wait(), take(t_s, data))[1]
    guardian.give_back()
    assert [emulator._bits[402] for emulator in panels] == [False] * 3
