"""Once zero is ordered a coil hears zero, off, or less than it has heard since: whatever becomes of the replies."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from served_lab import plain, three_on_one_pair

from labcal.bench.clock import VirtualClock
from labcal.bench.config import read_config
from labcal.bench.guardian.controller import Guardian
from labcal.bench.guardian.latch import Latch
from labcal.errors import InstrumentError

AXES = "xyz"
FATES = ("answered", "late", "lost", "doubled", "stale", "unheard")
TTI_SETS = re.compile(rb"I(\d) ([\d.]+)\n")


def one_tti() -> str:
    """One supply of three outputs on one line."""
    text = plain()
    for number, axis in enumerate(AXES, 1):
        before = f'link = "emulated://"\nrole = "coil-{axis}"'
        text = text.replace(
            before, f'link = "emulated://psu"\nrole = "coil-{axis}"\nsettings = {{ output = {number} }}'
        )
    return text


@dataclass
class Wire:
    """Between driver and emulator: each message meets the next of its `fates`, then all go well."""

    emulator: Any
    fates: list[str]
    late_s: float
    sent: list[bytes] = field(default_factory=list)
    at: dict[int, Any] = field(default_factory=dict)  # what happens when so many messages were sent
    when: Callable[[], None] = lambda: None  # with each message
    _replies: list[tuple[float, bytes]] = field(default_factory=list)
    _last: bytes = b""
    _fate: str = "answered"

    def take(self, t_s: float, data: bytes) -> None:
        self.sent.append(data)
        self.when()
        self._fate = self.fates.pop(0) if self.fates else "answered"
        if self._fate != "unheard":
            self.emulator.take(t_s, data)
        self.at.pop(len(self.sent), lambda: None)()

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        self._replies += [piece for t_s, reply in self.emulator.emit(until_s) for piece in self._spoilt(t_s, reply)]
        due = [piece for piece in self._replies if piece[0] <= until_s]
        self._replies = [piece for piece in self._replies if piece[0] > until_s]
        return due

    def _spoilt(self, t_s: float, reply: bytes) -> Iterator[tuple[float, bytes]]:
        stale, self._last = self._last, reply
        if self._fate == "stale" and stale:
            yield t_s, stale
        elif self._fate != "lost":
            yield t_s + (self.late_s if self._fate == "late" else 0.0), reply
        if self._fate == "doubled":
            yield t_s + 0.01, reply


class Bench:
    """A guardian whose three coils are on one line, with one clock; `wire` is that line."""

    def __init__(self, text: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
        monkeypatch.setattr("labcal.bench.guardian.owned_lines.RealClock", lambda: self.clock)
        monkeypatch.setattr("labcal.bench.guardian.duty.runtime_folder", lambda: folder)
        monkeypatch.setattr("labcal.bench.guardian.duty.later", lambda write: None)
        file = folder / "bench.toml"
        file.write_text(text, encoding="utf-8")
        self.noted = list[str]()
        self.guardian = Guardian(file, read_config(file), self.noted.append)
        self.guardian.zero("a session begins", by_session=True)
        line = self.guardian.coils["x"].line
        (self._link,) = line.loader.links.values()
        self.lab = line.loader.twin

    def energise(self, currents_A: dict[str, float]) -> None:
        for axis, amperes in currents_A.items():
            self.guardian.set_current(axis, 0.0)
            self.guardian.output(axis, True)
            for step in range(1, 6):
                self.clock.wait_until(self.clock.now() + 0.2)
                self.guardian.set_current(axis, amperes * step / 5)

    def spoil(self, fates: list[str], late_s: float) -> Wire:
        self._link._foresees = None
        wire = Wire(self._link._emulator, fates, late_s)
        self._link._emulator = wire
        return wire

    def flowing_A(self) -> dict[str, float]:
        return {axis: abs(float(coil.current.now(self.clock.now()))) for axis, coil in self.lab.coils.items()}


def set_points(sent: list[bytes]) -> dict[str, list[float]]:
    """What each axis was told [A], in order."""
    told: dict[str, list[float]] = {axis: [] for axis in AXES}
    for message in sent:
        for number, value in TTI_SETS.findall(message):
            told[AXES[int(number) - 1]].append(float(value))
        if len(message) == 8 and message[1] == 6 and message[2:4] == b"\0\x09":
            told[AXES[message[0] - 1]].append(int.from_bytes(message[4:6], "big") / 1000)
    return told


def switched_on(sent: list[bytes]) -> bool:
    return any((b"OP" in m and m.strip().endswith(b" 1")) or m[1:6] == b"\x06\0\x12\0\x01" for m in sent)


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@pytest.mark.parametrize("text", [one_tti(), three_on_one_pair()], ids=["tti", "riden-on-one-pair"])
@given(
    fates=st.lists(st.sampled_from(FATES), min_size=1, max_size=30),
    late_s=st.sampled_from([0.3, 1.5, 4.0]),
    interrupted_at=st.integers(1, 12),
)
def test_nothing_goes_up_again_once_zero_is_ordered(
    tmp_path: Path, text: str, fates: list[str], late_s: float, interrupted_at: int
) -> None:
    with pytest.MonkeyPatch.context() as monkeypatch:
        bench = Bench(text, tmp_path, monkeypatch)
        guardian = bench.guardian
        bench.energise({"x": 1.0, "y": 0.6, "z": 0.3})
        wire = bench.spoil(fates, late_s)
        wire.at[interrupted_at] = lambda: guardian.order_zero("somebody said off")
        try:  # the session goes on until it is stopped, or something fails
            for step in range(1, 13):
                bench.clock.wait_until(bench.clock.now() + 0.1)
                guardian.set_current("x", 1.0 + 0.05 * step)
                guardian.measure_current("y")
        except InstrumentError:
            pass
        begun = len(wire.sent)
        guardian.zero("somebody said off")
        for _ in range(6):
            bench.clock.wait_until(bench.clock.now() + 0.5)
            guardian.try_again()
        for axis, told in set_points(wire.sent[begun:]).items():
            assert told == sorted(told, reverse=True), (axis, told)
        assert not switched_on(wire.sent[begun:])
        wire.fates.clear()
        bench.clock.wait_until(bench.clock.now() + 5.0)
        for _ in range(3):
            guardian.try_again()
        assert not guardian.unresolved
        assert max(bench.flowing_A().values()) < 0.005


@pytest.mark.parametrize("text", [one_tti(), three_on_one_pair()], ids=["tti", "riden-on-one-pair"])
def test_on_a_line_that_loses_messages_each_coil_is_told_zero_again_and_again_in_two_seconds(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str
) -> None:
    bench = Bench(text, tmp_path, monkeypatch)
    bench.energise({"x": 0.2, "y": 0.2, "z": 0.2})
    wire = bench.spoil(["unheard"] * 100_000, 0.0)
    with pytest.raises(InstrumentError):
        bench.guardian.measure_current("x")
    wire.sent.clear()
    begun, told = bench.clock.now(), list[float]()
    wire.when = lambda: told.append(bench.clock.now() - begun)
    bench.guardian.zero("somebody said off")
    in_time = set_points([message for message, t_s in zip(wire.sent, told, strict=True) if t_s < 2.0])
    assert all(sent.count(0.0) >= 3 for sent in in_time.values()), in_time


def test_a_latch_is_lifted_by_a_zero_read_back_and_a_new_order_of_who_was_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bench = Bench(one_tti(), tmp_path, monkeypatch)
    guardian = bench.guardian
    bench.energise({"x": 1.0})
    guardian.zero("a person said off")
    for order in (lambda: guardian.set_current("x", 0.1), lambda: guardian.output("x", True)):
        with pytest.raises(InstrumentError, match=r"zero was ordered for all coils: a person said off\."):
            order()
    guardian.set_current("x", 0.0)  # now it was told
    guardian.output("x", True)
    guardian.set_current("x", 0.1)
    bench.clock.wait_until(bench.clock.now() + 0.5)
    assert guardian.measure_current("x") == pytest.approx(0.1, abs=0.002)
    wire = bench.spoil(["lost"] * 1000, 0.0)
    guardian.zero("the session", by_session=True)
    with pytest.raises(InstrumentError, match="no reply"):
        guardian.output("x", True)
    assert not switched_on(wire.sent)


def test_a_latched_coil_takes_only_less() -> None:
    latch = Latch()
    latch.take(5.0)
    latch.engage(-1.0)
    latch.take(-0.8)
    for beyond in (0.9, -0.81, float("nan")):
        with pytest.raises(InstrumentError, match=r"0\.8 A is the most"):
            latch.take(beyond)
    latch.engage(2.0)  # a second order to zero is no permission
    with pytest.raises(InstrumentError):
        latch.take(1.0)
    latch.take(0.0)
    latch.lift()
    latch.take(1.0)


@pytest.mark.parametrize("text", [one_tti(), three_on_one_pair()], ids=["tti", "riden-on-one-gateway"])
def test_a_connection_that_was_forgotten_at_its_other_end_is_opened_anew_in_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str
) -> None:
    bench = Bench(text, tmp_path, monkeypatch)
    monkeypatch.setattr("labcal.bench.guardian.owned_lines.is_connection", lambda url: True)
    bench.energise({"x": 1.0, "y": 0.6, "z": 0.3})
    wire = bench.spoil(["unheard"] * 10_000, 0.0)
    monkeypatch.setattr(bench._link, "reopen", wire.fates.clear)
    begun = bench.clock.now()
    ended = bench.guardian.zero("the session ends")
    after = begun + np.arange(0.0, 2.0, 0.01)
    flowing = np.abs(np.column_stack([coil.current.at(after) for coil in bench.lab.coils.values()])).max(axis=1)
    assert flowing[0] > 0.9
    assert flowing[-1] < 0.01
    silent = [(end.axis, end.fault.what) for end in ended if end.fault]
    assert silent
    assert [what for axis, what in silent if f"supply_{axis}" not in what] == []
    assert all(abs(end.current_A) < 0.01 for end in bench.guardian.zero("once more"))


@pytest.mark.parametrize("missed", range(9))
@pytest.mark.parametrize("asked", ["", "y"])
@pytest.mark.parametrize("text", [one_tti(), three_on_one_pair()], ids=["tti", "riden-on-one-pair"])
def test_a_line_that_comes_back_on_the_way_to_zero_brings_zero_to_each_coil_in_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, asked: str, missed: int
) -> None:
    bench = Bench(text, tmp_path, monkeypatch)
    bench.energise({"x": 1.0, "y": 0.6, "z": 0.3})
    wire, back = bench.spoil([], 0.0), list[float]()
    lost = InstrumentError("the link was lost", fault="link lost")

    def gone() -> None:
        if len(back) <= missed:
            raise lost

    def reopened() -> None:
        back.append(bench.clock.now())
        gone()

    wire.when = gone
    monkeypatch.setattr(bench._link, "reopen", reopened)
    if asked:  # its link is known to be lost, that of the others not yet
        with pytest.raises(InstrumentError, match="the link was lost"):
            bench.guardian.measure_current(asked)
    bench.guardian.zero("the session ends", by_session=True)
    while bench.guardian.unresolved:  # as the guardian's process does, and a session that is not content
        bench.clock.wait_until(bench.clock.now() + 0.1)
        bench.guardian.try_again()
        bench.guardian.zero("the session is not content", by_session=True)
    after = back[missed] + np.arange(0.0, 2.0, 0.01)
    flowing = np.abs(np.column_stack([coil.current.at(after) for coil in bench.lab.coils.values()])).max(axis=1)
    assert flowing[0] > 0.9
    assert flowing[-1] < 0.01, f"{max(after[flowing > 0.01]) - after[0]:.2f} s"
