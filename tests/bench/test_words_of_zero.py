"""What the guardian says of a zero: what was read in this round, and by whose word; who failed, and when."""

from __future__ import annotations

import re
import threading
import time
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from test_gate import text_line
from test_guardian_handover import Pair, handed_over
from test_guardian_handover import pair as pair
from test_latch import Bench, one_tti

from labcal.bench import early_off
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.at_zero import FROM_HERE, AtZero
from labcal.bench.guardian.handover import Handover, Held
from labcal.bench.guardian.last_read import LastRead
from labcal.cli import execute
from labcal.errors import InstrumentError

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "simulated.toml"
WAIT_S = 30.0


@pytest.fixture
def bench(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Bench:
    """At rest."""
    return Bench(one_tti(), tmp_path, monkeypatch)


def test_what_is_not_asked_again_is_told_as_that_with_its_age(bench: Bench) -> None:
    bench.energise({"x": 1.0})
    wire = bench.spoil(["lost"] * 10_000, 0.0)
    bench.guardian.zero("the session", by_session=True)
    first = bench.noted[-1]
    assert re.match(r"NOT confirmed at zero: coil x: \S+: no reply", first), first
    wire.sent.clear()
    ended = bench.guardian.zero("the session", by_session=True)
    assert not wire.sent
    again = bench.noted[-1]
    assert re.match(r"NOT confirmed at zero: coil x: not asked this time; \d+\.\d s ago: \S+: no reply", again), again
    assert "read back:" not in again
    assert not any(end.abrupt for end in ended)


def test_a_coil_whose_fault_names_it_is_named_once() -> None:
    still = InstrumentError("coil x: 0.6 A still flows 1 s after zero was set.", fault="not zero")
    assert AtZero("x", None, False, still).why_left == "coil x: 0.6 A still flows 1 s after zero was set."
    assert AtZero("y", None, False, InstrumentError("no reply.")).why_left == "coil y: no reply."


def fails_once(bench: Bench, axis: str) -> None:
    """One question to this supply is lost: from then on it is in doubt."""
    bench.spoil(["lost"], 0.0)
    with pytest.raises(InstrumentError, match="no reply"):
        bench.guardian.measure_current(axis)


def test_a_fault_of_before_stands_apart_from_what_is_read_now(bench: Bench) -> None:
    bench.energise({"x": 1.0})
    fails_once(bench, "x")
    ended = {end.axis: end for end in bench.guardian.zero("the session", by_session=True)}
    said = bench.noted[-1]
    assert re.search(r"read back: coil x [+-]0\.0\d+ A, zero, open; before that: \S+: no reply.*; coil y ", said), said
    assert [axis for axis, end in ended.items() if end.abrupt] == ["x"]
    assert ended["x"].from_A == pytest.approx(1.0, abs=0.01)


def test_a_coil_in_doubt_that_was_at_zero_came_to_it_by_no_step(bench: Bench) -> None:
    bench.energise({"x": 1.0})
    fails_once(bench, "y")
    ended = {end.axis: end for end in bench.guardian.zero("the session", by_session=True)}
    assert ended["y"].fault is not None
    assert ended["y"].current_A == pytest.approx(0.0, abs=0.005)
    assert not any(end.abrupt for end in ended.values())


def test_an_instrument_that_took_the_coils_to_zero_is_no_doubt_about_them(bench: Bench) -> None:
    bench.energise({"x": 1.0})
    opened = InstrumentError("interlock: the link was lost.", fault="link lost")
    bench.guardian.zero("the interlock is out", fault=opened)
    for ask in (
        bench.guardian.measure_current,
        bench.guardian.set_point,
        lambda axis: bench.guardian.output(axis, True),
    ):
        with pytest.raises(InstrumentError, match="interlock: the link was lost"):
            ask("x")
    ended = bench.guardian.zero("the session", by_session=True)
    assert [end.words for end in ended] == ["zero, open"] * 3


def test_a_successor_tells_what_it_knows_of_the_one_before(pair: Pair) -> None:
    handed = handed_over(pair)
    coils = {**handed.coils, "y": Held(0.7, True, handed.coils["y"].who, falling=True)}
    ended = {end.axis: end for end in pair.guardian(Handover(handed.exchanges_s, coils)).zero("it is gone")}
    told = "zero, open; before that: coil y: the guardian before is gone; it had ordered zero and reported no read-back"
    assert [ended[axis].words for axis in "xyz"] == ["zero, open", told, "zero, open"]
    assert [axis for axis, end in ended.items() if end.abrupt] == ["y"]


def test_whoever_gives_way_to_zero_is_told_who_ordered_it() -> None:
    _, gate, link = text_line()
    gate.close("labcal bench off, process 7")
    gate.close()  # by who carries it out
    with pytest.raises(
        InstrumentError, match=r"zero was ordered \(labcal bench off, process 7\); what was being asked"
    ):
        link.ask(b"the set-point?\n", end=b"\n", timeout_s=2.0)


def test_a_connection_that_is_gone_tells_what_was_read_last_and_when() -> None:
    read = LastRead(VirtualClock(datetime(2026, 1, 1, 7, 8, 9, tzinfo=UTC)))
    assert read.gone().what == "the connection to the guardian was lost; no current was read through it."
    read.keep("x", 0.25)
    assert (
        read.gone().what
        == "the connection to the guardian was lost; last read before that (UTC): coil x +0.2500 A at 07:08:09."
    )
    assert "killed" not in str(read.gone())


def off(monkeypatch: pytest.MonkeyPatch, slow_s: float) -> threading.Event:
    """`labcal bench off` without a guardian; whether it said that it is at it, before anything was ordered."""
    from labcal.bench.guardian.controller import Guardian

    said, zero, aloud = threading.Event(), Guardian.zero, early_off.aloud

    def heard(text: str) -> None:
        aloud(text)
        if text == FROM_HERE:
            said.set()

    def late(guardian: Guardian, why: str) -> Any:
        assert said.wait(WAIT_S) or slow_s
        return zero(guardian, why)

    monkeypatch.setattr(early_off, "SLOW_S", slow_s)
    monkeypatch.setattr(early_off, "aloud", heard)
    if not slow_s:
        monkeypatch.setattr(Guardian, "zero", late)
    assert execute(["bench", "off", str(EXAMPLE)]) == 0
    return said


def test_off_says_what_it_does_where_that_takes_long_and_by_whose_word_it_was_read(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert off(monkeypatch, 0.0).is_set()
    out, err = capsys.readouterr()
    assert err == f"{FROM_HERE}\n"
    read = r"coil ([xyz]): [+-]\d\.\d{4} A  by the supply's word only: zero, open"
    assert re.findall(read, out) == ["x", "y", "z"]


def test_off_says_when_a_coil_was_read_back_where_that_is_not_just_now(capsys: pytest.CaptureFixture[str]) -> None:
    now = time.monotonic()
    ended = [AtZero(axis, 0.0, True, read_s=now - age) for axis, age in (("x", 0.1), ("y", 3.1), ("z", 1.5))]
    assert early_off.reported(EXAMPLE, ended) == 0
    x, y, z, last = capsys.readouterr().out.splitlines()
    assert [line.endswith(": zero, open") for line in (x, z)] == [True, True]
    assert y.endswith(": zero, open, read back 3 s ago")
    assert last == "coils read back at zero by the supply's word 3 s ago; not watched since"


def test_off_says_nothing_of_an_order_that_was_read_back_in_time(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not off(monkeypatch, 1000.0).is_set()
