"""Jobs on the simulated bench: their numbers against the twin's truth, and how many processes pay."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal.errors import InputError
from labcal.fit import fit
from labcal.study.accuracy import errors
from labcal.study.engine import on_processes
from labcal.study.job import Job
from labcal.study.jobs import jobs_of
from labcal.study.run import run_study
from labcal.study.simulated import SimulatedRun, record, truth
from labcal.study.specification import read_study
from labcal.study.trials import design, lab_time
from labcal.study.work import work

ROOT = Path(__file__).parents[2]
SHORT = """format = "labcal-study/1"
kind = "{kind}"
seeds = 2
{more}
[lab.twin]
mounting_error_deg = 0.02
surprise = false
[settings]
axes = ["x", "y"]
magnitudes_nT = [50000.0]
modes = ["nominal"]
reverse = false
timing_nT = 100.0
zero_s = 4
dwell_s = 1
u_mounting_deg = 0.02
"""
PROCEDURES = """format = "labcal-study/1"
kind = "monte-carlo"
seeds = 1
accuracy_deg = 0.2
[[grid.procedure]]
name = "turned"
procedure = "preflight"
settings = { axes = ["y", "z"], magnitudes_nT = [5e4], modes = ["nominal"], reverse = false, zero_s = 4, dwell_s = 1 }
[[grid.procedure]]
name = "at rest"
procedure = "field-sphere"
settings = { n_directions = 12, magnitudes_nT = [50000.0] }
"""


def jobs(folder: Path, kind: str, more: str = "") -> list[Job]:
    file = folder / "study.toml"
    file.write_text(SHORT.format(kind=kind, more=more))
    return jobs_of(read_study(file), file)[0]


@pytest.fixture(scope="module")
def settings(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, Any]:
    return jobs(tmp_path_factory.mktemp("study"), "monte-carlo")[0].settings


@pytest.fixture(scope="module")
def recorded(settings: Mapping[str, Any], tmp_path_factory: pytest.TempPathFactory) -> SimulatedRun:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(tmp_path_factory.mktemp("home")))
        return record(settings)


def test_the_truth_is_the_map_that_a_fit_comes_near(recorded: SimulatedRun, settings: Mapping[str, Any]) -> None:
    found = fit(recorded.run, holdout=False)
    assert found.affine is not None
    turned, longer = errors(found.affine, truth(settings["bench"]), 50_000.0)
    assert 0 < turned < 0.2
    assert 0 < longer < 60


def test_lab_time_of_all_rotations_is_that_of_the_run_and_the_hands(recorded: SimulatedRun) -> None:
    time_ = lab_time(recorded, 180.0)
    everything = np.ones((1, 2), dtype=np.bool_)
    assert [segment.mounting for segment in recorded.run.segments] == ["x", "y"]
    assert time_.of(everything)[0] == pytest.approx(recorded.lab_s - recorded_before(recorded) + 2 * 180.0)
    one = np.array([[True, False]])
    spared = dict(recorded.steps)
    y = sum(spared[step] for step in ("mount-y", "closure-y", recorded.run.segments[1].id)) + 180.0
    assert time_.of(one)[0] == pytest.approx(time_.of(everything)[0] - y)


def recorded_before(recorded: SimulatedRun) -> float:
    """Lab time before the first step: instruments are identified."""
    return recorded.lab_s - sum(seconds for _, seconds in recorded.steps)


def test_a_job_has_the_name_of_what_it_depends_on_and_of_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = jobs(tmp_path, "monte-carlo")
    again = jobs(tmp_path, "monte-carlo", "accuracy_deg = 0.3")[0]  # asked of the results, not of the job
    assert first.key == again.key != second.key
    assert jobs(tmp_path, "monte-carlo", "field_nT = 4e4")[0].key != first.key
    assert jobs(tmp_path, "blind")[0].key != first.key
    assert replace(first, places={"run": "elsewhere"}).key == first.key
    monkeypatch.setattr("labcal.session.working_out.sources", lambda: "another day")
    assert jobs(tmp_path, "monte-carlo")[0].key != first.key


def test_a_bench_that_fails_or_a_limit_that_refuses_is_told_in_the_row(settings: Mapping[str, Any]) -> None:
    job = Job("monte-carlo", {**settings, "given": {**settings["given"], "magnitudes_nT": "99000", "axes": "x"}})
    job.settings["bench"]["dut"]["limits"]["field_nT"] = 30_000.0
    row = work(job)
    assert "30000" in str(row["why_not"]).replace(" ", "").replace("30 000", "30000")


def test_another_version_on_a_worker_is_refused(settings: Mapping[str, Any]) -> None:
    with pytest.raises(InputError, match="install the same"):
        work(Job("monte-carlo", {**settings, "version": "0.0.1"}))
    with pytest.raises(InputError, match=r"this worker has 0\.1\.0 [0-9a-f]{12}, the study was begun by 0\.1\.0"):
        work(Job("monte-carlo", {**settings, "version": "0.1.0"}))


@pytest.mark.slow
def test_procedures_are_compared_each_with_its_own_settings(tmp_path: Path) -> None:
    file = tmp_path / "study.toml"
    file.write_text(PROCEDURES)
    assert [job.settings["procedure"] for job in jobs_of(read_study(file), file)[0]] == ["preflight", "field-sphere"]
    summary = run_study(file, tmp_path / "out", processes=1).summary
    turned, at_rest = summary.lines
    assert (turned["procedure"], at_rest["procedure"]) == ("turned", "at rest")
    quick, slow = (float(line["lab_min"] or 0) for line in (at_rest, turned))
    assert 0 < quick < slow
    assert "procedure = at rest" in summary.answer
    refused = tmp_path / "refused.toml"
    refused.write_text(PROCEDURES.replace('"field-sphere"', '"no-such"'))
    with pytest.raises(InputError, match="no-such"):
        jobs_of(read_study(refused), refused)


@pytest.mark.parametrize("name", ["study", "design", "procedures"])
def test_the_examples_are_studies(name: str) -> None:
    file = ROOT / "examples" / f"{name}.toml"
    found, remarks = jobs_of(read_study(file), file)
    assert not remarks
    assert len({job.key for job in found}) == len(found) > 1


@pytest.mark.slow
def test_the_quickest_rotations_are_as_accurate_as_they_promise(tmp_path: Path) -> None:
    more = "accuracy_deg = 0.1"
    row = design({**jobs(tmp_path, "design", more)[0].settings, "accuracy_deg": 0.15, "seed": 3})
    assert row["why_not"] == ""
    assert float(row["direction_U_deg"] or 9) <= 0.15
    assert float(row["direction_error_deg"] or 9) < 2 * 0.15
    assert float(row["predicted_U_deg"] or 9) == pytest.approx(float(row["direction_U_deg"] or 0), rel=0.15)


@pytest.mark.slow
def test_blind_trials_say_what_was_hidden_and_what_was_named(tmp_path: Path) -> None:
    (tmp_path / "study.toml").write_text('format = "labcal-study/1"\nkind = "blind"\nseeds = [4, 5]\n')
    done = run_study(tmp_path / "study.toml", tmp_path / "out")
    assert done.without == 0
    [line] = done.summary.lines
    assert sum(int(line[word] or 0) for word in ("right", "among others", "rival", "missed", "wrong")) == 2


@pytest.mark.slow
def test_cost_is_linear_and_two_workers_take_half_the_time(tmp_path: Path) -> None:
    """Of jobs of some seconds each; workers have begun before the time is taken. The machine has to be idle."""
    several = [replace(job, settings={**job.settings, "seed": seed}) for job in jobs(tmp_path, "monte-carlo")[:1]
               for seed in range(12)]  # fmt: skip
    taken = {(n, processes): seconds(several[:n], processes) for n, processes in ((6, 1), (12, 1), (12, 2))}
    print(taken)
    assert taken[12, 1] / taken[6, 1] == pytest.approx(2.0, rel=0.15)
    assert taken[12, 1] / taken[12, 2] / 2 >= 0.9


def seconds(some: list[Job], processes: int) -> float:
    """From the first row to the last, for as many rows: starts of processes are left out."""
    began, count = 0.0, 0
    for count, _ in enumerate(on_processes(some, processes), 1):
        if count == processes:
            began = time.perf_counter()
    return (time.perf_counter() - began) * len(some) / (count - processes)
