"""The lab is read while no run goes on: nothing is set by it, and whoever wants a port has it."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator

import pytest
from served_lab import ZERO_A, Served, Sessions, all_gone, at_zero, example, kill_all, log, until

from labcal import session as labs
from labcal.bench.config import read_config
from labcal.bench.guardian.client import driven_before
from labcal.bench.links import ports
from labcal.bench.reading import InstrumentReading, read_lab
from labcal.bench.shutdown import coils_off
from labcal.errors import InstrumentError
from labcal.runner import Control
from labcal.runner.prompts import first_choice

SUPPLIES = ("supply_x", "supply_y", "supply_z")
READS = """
import sys
from pathlib import Path
from labcal.bench.reading import read_lab
print("reads", flush=True)
while True:
    read_lab(Path(sys.argv[1]))
"""
HOLDS = """
import os, sys, time
from labcal.bench.links import ports
assert ports.hold([sys.argv[1]])
ports.announce({"pid": os.getpid(), **({ports.BRIEF: True} if sys.argv[2] == "brief" else {})})
print("holds", flush=True)
time.sleep(1.0)
ports.let_go()
sys.stdin.read()
"""


@pytest.fixture
def bench_text() -> str:
    return example(timeout_s=0.5)


def of(readings: list[InstrumentReading]) -> dict[str, InstrumentReading]:
    return {one.name: one for one in readings}


@pytest.fixture
def reads(lab: Served) -> Iterator[subprocess.Popen[str]]:
    """Another process that reads all the time, as nobody does."""
    child = subprocess.Popen([sys.executable, "-c", READS, str(lab.file)], stdout=subprocess.PIPE, text=True)
    assert child.stdout is not None
    child.stdout.readline()
    yield child
    child.kill()
    child.communicate()


def test_everybody_is_read_and_nothing_is_set(lab: Served) -> None:
    lab.coils["z"].drive(lab.clock.now(), 1.1, 30.0, True)  # as somebody left it at its panel
    time.sleep(1.0)
    said = of(read_lab(lab.file))
    assert {name: one.fault for name, one in said.items() if one.fault or one.held or not one.identity} == {}
    assert said["stage"].moving is False
    field = said["reference"].field_nT
    assert field is not None
    assert 1e4 < sum(v * v for v in field) ** 0.5 < 2e5
    assert (said["supply_x"].zero, said["supply_z"].zero) == (True, False)
    assert said["supply_z"].current_A == pytest.approx(1.1, abs=0.02)
    assert lab.currents()["z"] == pytest.approx(1.1, abs=0.02)
    assert [name for name, one in read_config(lab.file).instruments.items() if ports.holder(one.link) is not None] == []


def test_who_was_named_alone_is_read(lab: Served) -> None:
    assert [one.name for one in read_lab(lab.file, ["supply_y", "dut"])] == ["supply_y", "dut"]


def test_what_another_process_drives_is_left_to_it(lab: Served, session: Sessions) -> None:
    session("idle")
    said = of(read_lab(lab.file))
    assert [said[name].held for name in SUPPLIES] == [True] * 3
    assert [said[name].current_A for name in SUPPLIES] == [None] * 3
    assert lab.currents()["x"] == pytest.approx(1.0, abs=0.01)


def test_a_coil_that_nobody_watches_any_more_is_seen_to_be_on_and_off_knows_of_it(
    lab: Served, session: Sessions
) -> None:
    kill_all(session("idle"))
    until(lambda: bool(driven_before(lab.file)))
    (left,) = driven_before(lab.file)
    said = of(read_lab(lab.file))
    assert [said[name].zero for name in SUPPLIES] == [False] * 3
    assert said["supply_x"].current_A == pytest.approx(1.0, abs=0.02)
    assert driven_before(lab.file) == [left]
    assert [end.fault for end in coils_off(lab.file)] == [None] * 3
    assert at_zero(lab)


@pytest.mark.slow
def test_one_that_its_guardian_still_asks_is_read_as_soon_as_it_answers(lab: Served) -> None:
    control, mute = Control(), lab.emulator("supply_y")

    def on_item(item: object) -> None:
        if getattr(item, "kind", "") == "set-point" and "emit" not in vars(mute):
            mute.emit = lambda until_s: []
            control.stop()

    try:
        labs.run("field-hold", lab.file, {"duration_s": "30"}, answer=first_choice, operator="x", control=control,
                 on_item=on_item)  # fmt: skip
        before = of(read_lab(lab.file, SUPPLIES))
        assert before["supply_y"].fault is not None, log()
        assert before["supply_y"].current_A is None
        assert before["supply_x"].zero
        asked_s = time.monotonic()
        by_guardian = of(read_lab(lab.file, SUPPLIES))["supply_x"]
        assert (by_guardian.zero, by_guardian.until) == (True, ("supply_y",))
        assert by_guardian.read_s is not None
        assert by_guardian.read_s >= asked_s, "read now, and not its last word"
    finally:
        vars(mute).pop("emit", None)
    until(lambda: of(read_lab(lab.file, SUPPLIES))["supply_y"].zero)
    all_gone(lab.file)


def test_off_reaches_everybody_beside_who_reads_all_the_time(lab: Served, reads: subprocess.Popen[str]) -> None:
    for _ in range(3):
        lab.coils["z"].drive(lab.clock.now(), 1.1, 30.0, True)
        begun = time.monotonic()
        assert [end.fault for end in coils_off(lab.file)] == [None] * 3
        assert time.monotonic() - begun < 5.0
        assert lab.currents()["z"] < ZERO_A
    assert reads.poll() is None


@pytest.mark.slow
def test_a_run_begins_beside_who_reads_all_the_time(lab: Served, reads: subprocess.Popen[str]) -> None:
    given = {"duration_s": "10"}
    outcome = labs.run("field-hold", lab.file, given, answer=first_choice, operator="x")
    assert outcome.status == "finished", f"{outcome}\n{log()}"
    assert reads.poll() is None


@pytest.mark.parametrize("how", ["brief", "for long"])
def test_who_only_reads_is_waited_for_and_nobody_else(lab: Served, how: str) -> None:
    url = "tcp://127.0.0.1:9"
    child = subprocess.Popen(
        [sys.executable, "-c", HOLDS, url, how], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert child.stdout is not None
    child.stdout.readline()
    begun = time.monotonic()
    try:
        if how == "brief":
            ports.claim(url)()
        else:
            with pytest.raises(InstrumentError) as refused:
                ports.claim(url)
            assert refused.value.fault == "in use"
            assert time.monotonic() - begun < 0.9
    finally:
        child.communicate()
