"""Who may answer: nothing is energised on a real bench before a person has said so."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest
from scalar_lab import SCALAR, sensor

from labcal import session
from labcal.bench import open_bench
from labcal.errors import InputError
from labcal.record.stream import Event, Item, Prompt
from labcal.runner import procedures, run_procedure, yes_to_all
from labcal.store import Store

BenchFile = Callable[..., Path]
OURS = [name for name, found in procedures().items() if found.function.__module__.startswith("procedures.")]


@pytest.mark.parametrize(
    "name", [pytest.param(one, marks=pytest.mark.slow if n % 3 else ()) for n, one in enumerate(OURS)]
)
def test_yes_on_a_real_bench_refuses_before_anything_is_energised(bench_file: BenchFile, name: str) -> None:
    seen: list[Item] = []
    file = bench_file(sensor(0), *SCALAR) if name == "scalar-cage" else bench_file()
    with closing(open_bench(file)) as bench, Store.open() as store:
        outcome = run_procedure(
            bench, procedures()[name], {}, store=store, answer=yes_to_all(False), on_item=seen.append
        )
    set_points = [item for item in seen if isinstance(item, Event) and item.kind == "set-point"]
    assert not set_points
    if outcome.fault is not None:
        assert isinstance(outcome.fault, InputError)
        assert "--yes cannot answer for a person on a real bench" in str(outcome.fault)
        assert "leave it out and answer at a terminal" in str(outcome.fault)
    else:
        assert not [item for item in seen if isinstance(item, Prompt) and item.acts]


def test_an_answer_stands_in_the_record_and_one_that_is_none_of_the_choices_is_refused(bench_file: BenchFile) -> None:
    outcome = session.run("rotate-axis", bench_file(), answer=lambda prompt: "perhaps")
    assert "'perhaps' is no answer to 'ready': expected done" in outcome.status
    outcome = session.run("rotate-axis", bench_file(), {"rate_deg_per_s": "20", "zero_s": "2"})
    with Store.open() as store:
        answers = {
            i.data["key"]: i.text for i in store.items(outcome.run_id) if isinstance(i, Event) and i.kind == "answer"
        }
    assert answers == {"mount-z": "done", "ready": "done", "mode-nominal": "done"}


def test_a_run_without_a_serial_number_does_not_start(bench_file: BenchFile) -> None:
    with pytest.raises(InputError, match="serial number"):
        session.run("rotate-axis", bench_file(), dut=" ")


def test_who_when_with_what_and_by_which_text_is_in_the_record(bench_file: BenchFile) -> None:
    path = bench_file()
    outcome = session.run("rotate-axis", path, {"rate_deg_per_s": "20"}, dut="EM-07", operator="J. Doe", seed=1)
    with Store.open() as store:
        header = store.header(outcome.run_id)
    assert (header.dut.serial, header.operator, header.procedure) == ("EM-07", "J. Doe", "rotate-axis")
    assert header.parameters["rate_deg_per_s"] == 20.0
    assert header.source_sha256 == procedures()["rotate-axis"].sha256
    assert header.bench == path.read_text(encoding="utf-8")
    assert {i["name"] for i in header.instruments} >= {"supply_x", "stage", "reference", "dut"}
    assert header.simulated
