"""What the operator may do while a run goes on: retry, skip, stop from the keyboard, resume only what is the same."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from contextlib import closing
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest
from left import left_as
from short_preflight import SHORT

from labcal import session
from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.state import AT_ZERO, BY_WORD
from labcal.errors import InputError, InstrumentError, LimitNotMet
from labcal.record.endings import ended_word
from labcal.record.stream import FAULT, Event, Item, Measurement, Prompt, Step
from labcal.runner import Control, Outcome, find, run_procedure
from labcal.runner.control import LATER
from labcal.store import Store

BenchFile = Callable[..., Path]
TWO_FIELDS = SHORT | {"magnitudes_nT": "20000,30000"}


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
            if prompt.key.startswith("failed-"):
                assert max(map(abs, lab.cage.currents_A())) < 0.002
            return said.get(prompt.key, prompt.choices[0] if prompt.choices else "")

        lab.platform.move_to = sticking
        outcome = run_procedure(
            lab, find("preflight"), TWO_FIELDS, store=store, answer=answer, on_item=tell, run_id="R"
        )
        return outcome, list(store.items("R"))


def test_a_failed_step_does_not_start_again_by_itself(bench_file: BenchFile) -> None:
    outcome, items = with_a_stuck_stage(bench_file(), {})
    assert (outcome.status, str(outcome.fault)) == ("interrupted", "stage: it does not move.")
    assert [i.text for i in items if isinstance(i, Event) and i.kind == FAULT] == ["stage: it does not move."]
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
        assert any("read-back" in line for line in child.stderr)
        time.sleep(0.5)
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=180)
    assert child.returncode == 130
    assert re.fullmatch(r"\d{8}T\d{6}-[0-9a-f]{4}\n", out)
    assert BY_WORD in err
    assert "Traceback" not in err
    with Store.open() as store:
        assert store.status(out.strip()) == "stopped"


def perhaps(prompt: Prompt) -> str:
    return "perhaps"


def test_only_the_same_run_is_resumed(bench_file: BenchFile) -> None:
    begun = session.run("preflight", bench_file(), TWO_FIELDS, answer=perhaps, seed=2)
    with Store.open() as store:
        bench = "served = true\n" + store.header(begun.run_id).bench.replace("emulated://", "tcp://127.0.0.1:9", 1)
        for run_id, changed in {"R": {}, "other-text": {"source_sha256": "00"}, "served": {"bench": bench}}.items():
            store.begin(replace(store.header(begun.run_id), run_id=run_id, **changed)).finish("interrupted")
    for run_id, change, says in (
        (
            "R",
            [('serial = "SIM-0001"\nmodel', 'serial = "SIM-0002"\nmodel')],
            "is of DUT SIM-0001, the bench has SIM-0002",
        ),
        ("R", [('"v_bus"], serial = "SIM-0001"', '"v_bus"], serial = "SIM-0003"')], "dut was .* now it is .*SIM-0003"),
        ("other-text", [], "preflight was changed since run other-text began: start it anew"),
        ("served", [], "run served was begun on another bench: a real, a simulated and a served one are not the same"),
        (begun.run_id, [], "is none to be gone on with: it is broken off"),
    ):
        with pytest.raises(InputError, match=says):
            session.resume(run_id, bench_file("", *change), seed=2)
    with Store.open() as store:
        assert store.status("R") == "interrupted"


@pytest.mark.parametrize(
    ("ends_it", "by_a_person"),
    [(Control.stop, True), (lambda control: control.leave(LATER), True), (Control.leave, False)],
    ids=["stop", "later", "gone"],
)
def test_a_run_that_a_person_stopped_is_listed_so_though_it_may_be_gone_on_with(
    bench_file: BenchFile, ends_it: Callable[[Control], None], by_a_person: bool
) -> None:
    control = Control(to_be_resumed=True)

    def ends(prompt: Prompt) -> str:
        ends_it(control)
        return prompt.choices[0]

    outcome = session.run("preflight", bench_file(), TWO_FIELDS, answer=ends, seed=2, control=control)
    [listed] = session.runs()
    assert (outcome.status, listed.status) == ("interrupted", "interrupted")
    assert listed.stopped == by_a_person
    assert ended_word(listed.status, stopped=listed.stopped) == ("stopped" if by_a_person else "broken off")


def test_resuming_that_is_given_up_before_a_coil_is_energised_leaves_the_run_interrupted(bench_file: BenchFile) -> None:
    bench, asked = bench_file(), list[str]()

    def remounted(prompt: Prompt) -> str:
        asked.append(prompt.key)
        return {"mounting-stands": "no", "ready": "done"}.get(prompt.key, "perhaps")

    break_off(bench, "closure-z")
    outcome = session.resume("R", bench, seed=2, answer=remounted)
    assert outcome.status == "interrupted"
    assert left_as(outcome) == AT_ZERO  # by the ambient field of before the interruption too
    assert asked == ["mounting-stands", "ready", "mount-z"]
    with Store.open() as store:
        events = [one for one in store.items("R") if isinstance(one, Event)]
    resumed = next(n for n, one in enumerate(events) if one.kind == "resumed")
    first = next(n for n, one in enumerate(events) if n > resumed and one.kind == "answer")
    before = [one.kind for one in events[resumed:first]]
    assert before[-2:] == ["read-back", "standstill"]  # before a person is sent to look
    assert "'perhaps' is no answer" in str(outcome.fault)
    with pytest.raises(InputError, match="run R is of preflight, not of ambient"):
        session.resume("R", bench, "ambient", seed=2)
    moved = session.resume("R", bench_file("ambient = { earth_nT = [20400.0, 3150.0, -43700.0] }"), seed=2)
    assert moved.ending.startswith("interrupted: zero since the interruption: 2000 nT is beyond 500 nT")


@pytest.mark.parametrize(
    ("at", "asked"),
    [
        ("x+20uT-nominal", "mounting-stands"),
        pytest.param("closure-x", "mounting-stands", marks=pytest.mark.slow),  # x is up, and is closed first
        ("mount-y", "mount-y"),  # hands were at it
        pytest.param("y+20uT-nominal", "mounting-stands", marks=pytest.mark.slow),
        ("closing", "mount-x"),
    ],
)
def test_who_goes_on_is_asked_whether_the_mounting_stands_only_where_it_was_that_one(
    bench_file: BenchFile, at: str, asked: str
) -> None:
    bench, keys = bench_file(), list[str]()
    break_off(bench, at, given=TWO_FIELDS | {"axes": "x,y", "magnitudes_nT": "20000"})

    def answer(prompt: Prompt) -> str:
        keys.append(prompt.key)
        return "done" if prompt.key == "ready" else "perhaps"

    session.resume("R", bench, seed=2, answer=answer)
    assert [key for key in keys if key != "ready"] == [asked]


def test_a_resumed_run_goes_on_after_its_last_finished_turn_in_a_mounting_of_its_own(bench_file: BenchFile) -> None:
    bench, steps = bench_file(), list[str]()
    before = break_off(bench, "z+30uT-nominal")
    outcome = session.resume(
        "R", bench, seed=2, on_item=lambda i: steps.append(i.name) if isinstance(i, Step) else None
    )
    assert outcome.status == "finished", outcome.fault
    assert steps == ["zero", "axes-check", "sync-check", "mount-z", "z+30uT-nominal", "closure-z", "closing"]
    run = session.load_run("R")
    assert [(s.id, s.mounting) for s in run.segments] == [("z+20uT-nominal", "z"), ("z+30uT-nominal", "z.again")]
    rows = [run.rows(index) for index in range(2)]
    assert min(map(len, rows)) > 150
    assert run.t_s[rows[0][-1]] < before < run.t_s[rows[1][0]]


@pytest.mark.parametrize(
    ("at", "said"),
    [
        ("z+30uT-nominal", "turns kept from before the interruption: 1; the zero, the axes and the timing"),
        ("z+20uT-nominal", "no turn was finished before the interruption: it begins anew"),
    ],
)
def test_what_is_kept_and_what_is_measured_anew_is_said_before_the_first_question(
    bench_file: BenchFile, at: str, said: str
) -> None:
    bench, told = bench_file(), list[Item]()
    break_off(bench, at)
    session.resume("R", bench, seed=2, answer=perhaps, on_item=told.append)
    asked = next(n for n, one in enumerate(told) if isinstance(one, Prompt))
    notes = [one.text for one in told[:asked] if isinstance(one, Event) and one.kind == "note"]
    assert [one.startswith(said) for one in notes] == [True]


def test_a_limit_that_was_not_met_before_the_interruption_still_counts_after_it(bench_file: BenchFile) -> None:
    bench, told = bench_file(), list[Item]()
    break_off(bench, "z+30uT-nominal", Measurement(1.0, "z+20uT-nominal: noise", 90.0, 1.0, "nT", 20.0))
    outcome = session.resume("R", bench, seed=2, on_item=told.append)
    assert outcome.status == "finished", outcome.fault
    assert [one.name for one in outcome.failed] == ["z+20uT-nominal: noise"]
    measured = [one.name for one in told if isinstance(one, Measurement)]
    assert measured.index("z+20uT-nominal: noise") < measured.index("zero since the interruption")
    with pytest.raises(LimitNotMet, match="z\\+20uT-nominal: noise: 90 nT"):
        outcome.raise_fault()


def break_off(bench: Path, at: str, *more: Item, given: Mapping[str, str] = TWO_FIELDS) -> float:
    """A run R whose program died when the step `at` had begun and `more` was recorded; returns when that was."""
    control, seen = Control(), list[Item]()

    def tell(item: Item) -> None:
        seen.append(item)
        if isinstance(item, Step) and item.name == at:
            control.stop()

    outcome = session.run("preflight", bench, given, seed=2, control=control, on_item=tell)
    last = next(i for i in seen if isinstance(i, Step) and i.name == at)
    with Store.open() as store:
        writer = store.begin(replace(store.header(outcome.run_id), run_id="R"))
        for item in seen[: seen.index(last) + 1]:
            writer.write(item)
        for item in more:
            writer.write(replace(item, t_s=last.t_s))
        writer.finish("interrupted")
    return last.t_s


def test_what_keeps_no_steps_cannot_be_resumed(bench_file: BenchFile) -> None:
    outcome = session.run("ambient", bench_file(), {"duration_s": "10"})
    with pytest.raises(InputError, match="ambient cannot go on after an interruption"):
        session.resume(outcome.run_id, bench_file())
