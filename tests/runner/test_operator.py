"""What the operator may do while a run goes on: retry, skip, stop from the keyboard, resume only what is the same."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from labcal import session
from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.errors import InputError, InstrumentError
from labcal.record.stream import Event, Item, Prompt, Step
from labcal.runner import Outcome, find, run_procedure
from labcal.store import Store

BenchFile = Callable[..., Path]
SHORT = {
    "axes": "z",
    "modes": "nominal",
    "magnitudes_nT": "20000,30000",
    "reverse": "no",
    "rate_deg_per_s": "20",
    "zero_s": "2",
    "dwell_s": "1",
}


def with_a_stuck_stage(bench: Path, said: dict[str, str]) -> tuple[Outcome, list[Item]]:
    """A preflight whose stage is stuck once, in the first turn; prompts are answered as `said`, else by yes."""
    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(bench, clock=clock, seed=2)) as lab, Store.open() as store:
        move_to, stuck = lab.platform.move_to, iter([True])

        def sticking(angle_deg: float, rate_deg_per_s: float) -> None:
            if turning and next(stuck, False):
                raise InstrumentError("stage: it does not move.", fault="stuck")
            move_to(angle_deg, rate_deg_per_s)

        turning: list[Item] = []

        def tell(item: Item) -> None:
            if isinstance(item, Step) and item.name == "z+20uT-nominal":
                turning.append(item)

        def answer(prompt: Prompt) -> str:
            return said.get(prompt.key, prompt.choices[0] if prompt.choices else "")

        lab.platform.move_to = sticking
        outcome = run_procedure(lab, find("preflight"), SHORT, store=store, answer=answer, tell=tell, run_id="R")
        return outcome, list(store.items("R"))


def test_a_failed_step_does_not_start_again_by_itself(bench_file: BenchFile) -> None:
    outcome, items = with_a_stuck_stage(bench_file(), {})
    assert outcome.status == "failed: stage: it does not move."
    prompt = next(i for i in items if isinstance(i, Prompt) and i.key == "failed-z+20uT-nominal")
    assert prompt.choices[0] == "stop"


def test_a_failed_step_is_retried_when_a_person_says_so(bench_file: BenchFile) -> None:
    outcome, _ = with_a_stuck_stage(bench_file(), {"failed-z+20uT-nominal": "retry"})
    assert outcome.status == "finished"
    run = session.load_run("R")
    rows = [len(run.rows(index)) for index, s in enumerate(run.segments) if s.id.startswith("z+20uT")]
    assert max(rows) > 150


def test_a_failed_step_is_skipped_with_a_reason_that_stands_in_the_record(bench_file: BenchFile) -> None:
    said = {"failed-z+20uT-nominal": "skip", "skip-z+20uT-nominal": "cable too short"}
    outcome, items = with_a_stuck_stage(bench_file(), said)
    assert outcome.status == "finished"
    skips = [i for i in items if isinstance(i, Event) and i.kind == "skip"]
    assert [i.data["reason"] for i in skips] == ["cable too short"]
    run = session.load_run("R")
    assert {s.id: len(run.rows(i)) > 150 for i, s in enumerate(run.segments)}["z+30uT-nominal"]


def test_ctrl_c_stops_in_order_and_still_prints_the_run_id(bench_file: BenchFile) -> None:
    code = "from labcal.cli import main; main()"
    words = ["run", "rotate-axis", "--bench", str(bench_file()), "--yes", "--clock", "real", "--progress", "json"]
    with subprocess.Popen(
        [sys.executable, "-c", code, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as child:
        assert child.stderr is not None
        while "read-back" not in child.stderr.readline():
            assert child.poll() is None
        time.sleep(0.5)
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=60)
    assert child.returncode == 130
    assert re.fullmatch(r"\d{8}T\d{6}-[0-9a-f]{4}\n", out)
    assert "coils at zero" in err
    assert "Traceback" not in err
    with Store.open() as store:
        assert store.status(out.strip()) == "stopped"


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (('serial = "SIM-0001"\nmodel', 'serial = "SIM-0002"\nmodel'), "is of DUT SIM-0001, the bench has SIM-0002"),
        (None, "was not interrupted: it is finished"),
    ],
)
def test_only_the_same_run_is_resumed(bench_file: BenchFile, change: Any, says: str) -> None:
    given = SHORT | {"magnitudes_nT": "20000"}
    outcome = session.run("preflight", bench_file(), given, seed=2)
    with pytest.raises(InputError, match=says):
        session.resume(outcome.run_id, bench_file("", *([change] if change else [])), seed=2)


def test_resuming_that_is_given_up_before_a_coil_is_energised_leaves_the_run_interrupted(bench_file: BenchFile) -> None:
    bench, given = bench_file(), SHORT | {"magnitudes_nT": "20000"}
    with Store.open() as store:
        break_off(bench, given, store)
    outcome = session.resume("R", bench, seed=2, answer=lambda prompt: "perhaps")
    assert (outcome.status, outcome.at_rest) == ("interrupted", "coils at zero")
    assert "'perhaps' is no answer" in str(outcome.fault)
    with pytest.raises(InputError, match="run R is of preflight, not of ambient"):
        session.resume("R", bench, "ambient", seed=2)
    assert session.resume("R", bench, seed=2).status == "finished"


def break_off(bench: Path, given: dict[str, str], store: Store) -> None:
    """A run R whose program died while the axes were checked."""
    outcome = session.run("preflight", bench, given, seed=2)
    writer = store.begin(replace(store.header(outcome.run_id), run_id="R"))
    for item in store.items(outcome.run_id):
        writer.write(item)
        if isinstance(item, Step) and item.name == "axes-check":
            break
    writer.finish("interrupted")


def test_what_keeps_no_steps_cannot_be_resumed(bench_file: BenchFile) -> None:
    outcome = session.run("ambient", bench_file(), {"duration_s": "10"})
    with pytest.raises(InputError, match="ambient cannot go on after an interruption"):
        session.resume(outcome.run_id, bench_file())
