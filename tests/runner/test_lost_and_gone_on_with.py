"""A run that lost an instrument: coils first, then `interrupted`; with the instrument back it goes on where it was."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from short_preflight import SHORT

from labcal import session
from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coverage import refuse_unseen
from labcal.errors import InstrumentError, LimitError
from labcal.record.stream import FAULT, Block, Event, Item, Measurement, Prompt, Step
from labcal.runner import Outcome, find, run, run_procedure, yes_to_all
from labcal.runner.resume_state import resume_state
from labcal.session.told import told
from labcal.store import Store

BenchFile = Callable[..., Path]
TWO_FIELDS = SHORT | {"magnitudes_nT": "20000,30000"}
SECOND = "z+30uT-nominal"


def begun(
    bench: Path,
    name: str,
    happens: Callable[[Any], None],
    given: dict[str, str],
    at: str,
    answer: Callable[[Prompt], str] = yes_to_all(True),
) -> Outcome:
    """Run R, to which something happens when the step `at` begins; a step that failed is not tried again."""
    there = list[bool]()
    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(bench, clock=clock, seed=2)) as lab, Store.open() as store:

        def tell(item: Item) -> None:
            if isinstance(item, Step) and item.name == at and not there:
                there.append(True)
                happens(lab)

        return run_procedure(lab, find(name), given, store=store, answer=answer, on_item=tell, run_id="R")


def pulled(name: str) -> Callable[[Any], None]:
    """Its plug is out, and stays out for the rest of this session."""

    def happens(lab: Any) -> None:
        def gone(*_: Any, **__: Any) -> Any:
            raise InstrumentError(f"{name}: the link is gone.", fault="link lost")

        link = lab.instruments()[name]._link
        link.send = link.receive = link.ask = gone

    return happens


def pulled_for(name: str, seconds: float) -> Callable[[Any], None]:
    """Its plug is out, and in again after that time."""

    def happens(lab: Any) -> None:
        link, back_s = lab.instruments()[name]._link, lab.clock.now() + seconds
        for call in ("send", "receive", "ask"):
            setattr(link, call, _gone_until(back_s, lab.clock, name, getattr(link, call)))

    return happens


def _gone_until(back_s: float, clock: VirtualClock, name: str, call: Callable[..., Any]) -> Callable[..., Any]:
    def answers(*given: Any, **more: Any) -> Any:
        if clock.now() < back_s:
            raise InstrumentError(f"{name}: the link is gone.", fault="link lost")
        return call(*given, **more)

    return answers


def events(kind: str) -> list[str]:
    with Store.open() as store:
        return [i.text for i in store.items("R") if isinstance(i, Event) and i.kind == kind]


@pytest.mark.parametrize(
    "name", ["reference", "supply_x", *(pytest.param(name, marks=pytest.mark.slow) for name in ("dut", "stage"))]
)
def test_the_turn_that_lost_an_instrument_is_repeated_and_the_others_are_kept(bench_file: BenchFile, name: str) -> None:
    bench, steps = bench_file(), list[Step]()
    lost = begun(bench, "preflight", pulled(name), TWO_FIELDS, SECOND)
    assert (lost.status, lost.resumable) == ("interrupted", True)
    with pytest.raises(InstrumentError, match=name):  # exit code 3, as before
        lost.raise_fault()
    assert name in lost.ending
    assert [name in said for said in events(FAULT)] == [True]
    with Store.open() as store:
        assert store.status("R") == "interrupted"
    there = session.resume("R", bench, seed=2, on_item=lambda i: steps.append(i) if isinstance(i, Step) else None)
    assert (there.status, there.fault) == ("finished", None)
    assert steps[0].left_s == pytest.approx(sum(step.step_s for step in steps))  # nothing of what is kept
    names = [step.name for step in steps]
    assert names == ["zero", "axes-check", "sync-check", "mount-z", SECOND, "closure-z", "closing"]
    run = session.load_run("R")
    first, *_, last = (one for n, one in enumerate(run.segments) if len(run.rows(n)) > 150)
    assert (first.id, first.mounting, last.mounting) == ("z+20uT-nominal", "z", "z.again")
    assert last.id.startswith(SECOND)


def test_gone_on_with_twice_each_stretch_has_a_mounting_of_its_own(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    bench = bench_file()
    begun(bench, "preflight", pulled("dut"), TWO_FIELDS, SECOND)
    monkeypatch.setattr(run, "resume_state", lambda items: replace(resume_state(items), times=2))
    session.resume("R", bench, seed=2)
    recorded = session.load_run("R")
    turned = [one.mounting for n, one in enumerate(recorded.segments) if len(recorded.rows(n)) > 150]
    assert turned == ["z", "z.again2"]


@pytest.mark.parametrize("at", ["closure-x", "mount-z"])
def test_a_closure_that_an_interruption_kept_from_being_measured_is_made_up(bench_file: BenchFile, at: str) -> None:
    bench, steps = bench_file(), list[Step]()
    begun(bench, "preflight", pulled("reference"), SHORT | {"axes": "x,z"}, at)
    there = session.resume("R", bench, seed=2, on_item=lambda i: steps.append(i) if isinstance(i, Step) else None)
    assert (there.status, there.fault, there.failed) == ("finished", None, ())
    names = [step.name for step in steps]
    made_up = ["mount-x", "closure-x"] if at == "closure-x" else []
    assert names == ["zero", "axes-check", "sync-check", *made_up, "mount-z", "z+20uT-nominal", "closure-z", "closing"]
    assert steps[0].left_s == pytest.approx(sum(step.step_s for step in steps))
    closures = {one.name: one for one in session.load_run("R").closures}
    with Store.open() as store:
        measured = {i.name: i for i in store.items("R") if isinstance(i, Measurement)}
    assert measured["closure x"].verdict == "PASS"
    assert ("closure x" in closures) == (at == "mount-z")  # made up, it has one end in this stretch alone
    (broken,) = told("R").interruptions
    again = {"closure-x": ("mount-x", "closure-x"), "mount-z": ("mount-z",)}[at]
    assert (broken.at, broken.again) == (at, ("zero", "axes-check", "sync-check", *again))
    assert (broken.gone_s, broken.timed) == (None, False)  # a simulated bench: its clock stood meanwhile


def test_a_turn_in_which_the_dut_was_lost_is_asked_about_with_the_coils_at_zero_and_begun_again(
    bench_file: BenchFile,
) -> None:
    asked = list[Prompt]()

    def answer(prompt: Prompt) -> str:
        asked.append(prompt)
        return "retry" if "retry" in prompt.choices else yes_to_all(True)(prompt)

    ended = begun(bench_file(), "preflight", pulled_for("dut", 8.0), TWO_FIELDS, SECOND, answer)
    assert (ended.status, ended.failed) == ("finished", ())
    failed, still = (prompt for prompt in asked if prompt.key == f"failed-{SECOND}")
    assert "coils at zero" in failed.text
    assert still.text.startswith("Still lost: dut")
    (said,) = events(FAULT)
    assert said.startswith("dut: the link is gone")


def test_a_turn_of_which_the_dut_missed_sectors_is_refused() -> None:
    t = np.arange(0.0, 20.0, 0.1)
    angle = Block("angle", "stage", ("angle_deg",), t, 18.0 * t[:, None])
    dut = Block("dut", "dut", ("x",), t[(t < 8) | (t > 11.5)], np.ones((int(np.sum((t < 8) | (t > 11.5))), 1)))
    bench: Any = SimpleNamespace(dut=SimpleNamespace(name="dut"))
    with pytest.raises(InstrumentError, match=r"it sent nothing at 1[0-9][0-9]°–20[0-9]° of this turn"):
        refuse_unseen(bench, [angle, dut])
    refuse_unseen(bench, [angle, Block("dut", "dut", ("x",), t, np.ones((len(t), 1)))])


def beyond(lab: Any) -> None:
    raise LimitError("coil x: 3 A is beyond its limit of 2.5 A", fault="limit reached")


def test_what_would_be_refused_again_is_not_gone_on_with(bench_file: BenchFile) -> None:
    ended = begun(bench_file(), "preflight", beyond, TWO_FIELDS, SECOND)
    assert ended.status.startswith("failed: coil x: 3 A is beyond its limit of 2.5 A")
    assert not ended.resumable


def test_nor_is_a_procedure_that_cannot_skip_what_it_has_done(bench_file: BenchFile) -> None:
    ended = begun(bench_file(), "field-hold", pulled("reference"), {"duration_s": "60"}, "held")
    assert ended.status.startswith("failed: reference: ")
    assert not ended.resumable


@pytest.mark.parametrize("name", ["reference", "stage"])
def test_the_question_about_a_lost_line_has_its_parts_apart(bench_file: BenchFile, name: str) -> None:
    drawings = list[dict[str, Any]]()

    def answer(prompt: Prompt) -> str:
        if prompt.key == f"failed-{SECOND}":
            drawings.append(dict(prompt.drawing))
        return yes_to_all(True)(prompt)

    begun(bench_file(), "preflight", pulled(name), TWO_FIELDS, SECOND, answer)
    (drawn,) = drawings
    assert drawn["no_answer"] == name
    assert drawn["what"].startswith(f"{name}: ")
    assert drawn["remedy"]
    assert drawn["remedy"] not in drawn["what"]
    assert drawn["fault"] == f"{drawn['what']} {drawn['remedy']}"
