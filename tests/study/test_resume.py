"""The same study gives the same bytes: on one process, two, a cluster, after kill -9 of a worker or of the whole."""

from __future__ import annotations

import csv
import io
import multiprocessing
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from dask_cluster import Cluster, cluster_of
from fleet import build, bytes_of

from labcal.cli import execute as labcal
from labcal.errors import InputError
from labcal.study.engine import on_processes
from labcal.study.job import Job
from labcal.study.run import run_study

NUMBER, WAIT_S = 5, 300.0


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build(tmp_path_factory.mktemp("fleet") / "fleet", NUMBER)


@pytest.fixture(scope="module")
def reference(study: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """What one process makes of it."""
    out = tmp_path_factory.mktemp("reference") / "out"
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(tmp_path_factory.mktemp("home")))
        done = run_study(study, out, processes=1)
    assert (done.jobs, done.without, done.kept_before) == (NUMBER, 0, 0)
    return bytes_of(out)


def test_two_processes_of_which_one_is_killed_give_the_same_bytes(
    study: Path, reference: dict[str, bytes], tmp_path: Path
) -> None:
    killed = list[int]()

    def kill_once(done: int, of: int) -> None:
        if done == 2 and not killed:
            workers = [child for child in multiprocessing.active_children() if child.pid]
            killed.extend(child.pid for child in workers[:1] if child.pid)
            os.kill(killed[0], signal.SIGKILL)

    done = run_study(study, tmp_path / "out", processes=2, progress=kill_once)
    assert len(killed) == 1
    assert done.without == 0
    assert bytes_of(tmp_path / "out") == reference


def test_a_study_that_was_killed_goes_on_to_the_same_bytes(
    study: Path, reference: dict[str, bytes], tmp_path: Path
) -> None:
    out = tmp_path / "out"
    command = [sys.executable, "-m", "labcal", "study", str(study), "--out", str(out), "--processes", "1"]
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    until(lambda: len(list(out.glob("jobs/*.json"))) >= 2)
    process.kill()
    process.wait()
    half = len(list(out.glob("jobs/*.json")))
    assert 2 <= half < NUMBER
    assert not (out / "table.csv").exists()
    (out / "jobs" / f".{'0' * 64}.json.abcd.part").write_bytes(b'{"job"')  # what a killed writer leaves
    first = sorted(out.glob("jobs/*.json"))[0]
    first.write_bytes(first.read_bytes()[:40])  # and what a failing disk does
    done = run_study(study, out, processes=1)
    assert done.kept_before == half - 1
    assert bytes_of(out) == reference


def test_what_is_done_is_not_done_again_and_a_larger_study_takes_it(
    study: Path, reference: dict[str, bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    for name, content in reference.items():
        (out / name).parent.mkdir(parents=True, exist_ok=True)
        (out / name).write_bytes(content)
    monkeypatch.setattr("labcal.study.run.on_processes", lambda *_: pytest.fail("a job was done again"))
    assert run_study(study, out, force=True).kept_before == NUMBER
    assert bytes_of(out) == reference


def test_a_file_of_the_folder_that_somebody_changed_is_kept_until_force_is_said(
    study: Path, reference: dict[str, bytes], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "table.csv").write_text("the work of a week")
    assert labcal(["study", str(study), "--out", str(tmp_path)]) == 2
    assert "--force replaces it" in capsys.readouterr().err
    assert bytes_of(tmp_path) == {"table.csv": b"the work of a week"}


def test_parquet_and_csv_say_the_same(reference: dict[str, bytes]) -> None:
    parquet = pytest.importorskip("pyarrow.parquet", reason="the extra `cluster` is not installed")
    table = parquet.read_table(io.BytesIO(reference["table.parquet"])).to_pylist()
    rows = list(csv.DictReader(io.StringIO(reference["table.csv"].decode())))
    assert [row["calibration"] for row in rows] == [f"cal-{i:03d}.json" for i in range(NUMBER)]
    for one, other in zip(table, rows, strict=True):
        assert list(one) == list(other)
        assert {name: "" if value is None else str(value) for name, value in one.items()} == other


def test_a_job_that_kills_its_workers_ends_the_study_with_a_sentence() -> None:
    deadly = Job("fleet", {"version": Deadly()})
    with pytest.raises(InputError, match="3 workers ended while these jobs were at hand"):
        list(on_processes([deadly], 1))


class Deadly(str):
    """Kills the process that unpickles it."""

    def __reduce__(self) -> tuple[Callable[..., None], tuple[int]]:
        return os._exit, (1,)


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[Cluster]:
    pytest.importorskip("distributed", reason="the extra `cluster` is not installed")
    with cluster_of(2, tmp_path) as found:
        yield found


@pytest.mark.slow
def test_a_cluster_of_which_a_worker_is_killed_gives_the_same_bytes(
    study: Path, reference: dict[str, bytes], tmp_path: Path, cluster: Cluster
) -> None:
    address, workers = cluster.address, cluster.workers

    def kill_at_two(done: int, of: int) -> None:
        if done == 2:
            workers[0].kill()

    done = run_study(study, tmp_path / "out", scheduler=address, progress=kill_at_two)
    assert workers[0].wait() == -signal.SIGKILL
    assert done.without == 0
    assert bytes_of(tmp_path / "out") == reference


@pytest.mark.slow
def test_a_study_on_a_cluster_that_was_killed_goes_on_to_the_same_bytes(
    study: Path, reference: dict[str, bytes], tmp_path: Path, cluster: Cluster
) -> None:
    out, address = tmp_path / "out", cluster.address
    command = [sys.executable, "-m", "labcal", "study", str(study), "--out", str(out), "--scheduler", address]
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    until(lambda: len(list(out.glob("jobs/*.json"))) >= 1)
    process.kill()
    process.wait()
    kept = len(list(out.glob("jobs/*.json")))
    assert not (out / "table.csv").exists()
    assert run_study(study, out, scheduler=address).kept_before == kept
    assert bytes_of(out) == reference


def test_a_scheduler_that_is_not_there_is_said(study: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("distributed", reason="the extra `cluster` is not installed")
    for address, said in (("somewhere://x", "is no address such as"), ("nonsense:::", "scheduler")):
        assert labcal(["study", str(study), "--out", str(tmp_path), "--scheduler", address]) == 2
        told = capsys.readouterr().err
        assert said in told


@pytest.mark.parametrize("missing", ["distributed", "pyarrow"])
def test_without_the_extra_there_is_a_sentence(
    missing: str, study: Path, reference: dict[str, bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.setitem(sys.modules, missing, None)
    if missing == "distributed":
        ask = ["study", str(study), "--out", str(tmp_path), "--scheduler", "tcp://127.0.0.1:1"]
        assert labcal(ask) == 2
        assert "pip install 'labcal[cluster]'" in capsys.readouterr().err
        return
    shutil.copytree(study.parent, tmp_path / "fleet")
    (tmp_path / "out" / "jobs").mkdir(parents=True)
    for name in (name for name in reference if name.startswith("jobs")):
        (tmp_path / "out" / name).write_bytes(reference[name])
    assert labcal(["study", str(tmp_path / "fleet" / "study.toml"), "--out", str(tmp_path / "out")]) == 0
    assert "the table is CSV alone" in " ".join(capsys.readouterr().out.split())
    assert not (tmp_path / "out" / "table.parquet").exists()


def until(true: Callable[[], bool]) -> None:
    """Wait for it."""
    end = time.monotonic() + WAIT_S
    while not true():
        assert time.monotonic() < end, "it did not come to that"
        time.sleep(0.005)
