"""What the processes of a study are started with."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest
from dask_cluster import WITHIN_S, cluster_of

from labcal.files.home import SECRETS
from labcal.study.cluster import on_worker
from labcal.study.job import Cell, Job
from labcal.system.workers import environment_of_workers

CANARY = "c4nary"


def test_no_secret_and_one_thread_of_linear_algebra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("MKL_NUM_THREADS", raising=False)
    for name in (*SECRETS, "OMP_NUM_THREADS"):
        monkeypatch.setenv(name, CANARY)
    before = dict(os.environ)
    looked = [sys.executable, "-c", "import os; print(dict(os.environ))"]
    with environment_of_workers():
        told = subprocess.run(looked, check=True, capture_output=True, text=True).stdout
    assert CANARY not in told
    assert told.count("_THREADS': '1'") == 4
    assert dict(os.environ) == before


def threads_of_linear_algebra(_: int) -> set[int]:
    """On a worker of a cluster, within a job."""
    from threadpoolctl import threadpool_info

    import_module("scipy.linalg")
    return {one["num_threads"] for one in threadpool_info() if one["user_api"] == "blas"}


def in_a_job(of: int) -> set[int]:
    """As `on_worker` does a job."""
    found = set[int]()

    def looks(job: Job) -> dict[str, Cell]:
        found.update(threads_of_linear_algebra(of))
        return {}

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("labcal.study.cluster.work", looks)
        on_worker(Job("fleet", {}))
    return found


@pytest.mark.slow
@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="one core has one thread of linear algebra anyway")
def test_each_worker_of_dask_has_one_thread_of_linear_algebra_in_a_job(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    distributed = pytest.importorskip("distributed", reason="the extra `cluster` is not installed")
    here = str(Path(__file__).parent)
    monkeypatch.setenv("PYTHONPATH", here)
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
        monkeypatch.setenv(name, "2")  # somebody started them so
    with cluster_of(2, tmp_path) as cluster, distributed.Client(cluster.address, set_as_default=False) as client:
        client.wait_for_workers(2, timeout=WITHIN_S)
        outside = client.run(threads_of_linear_algebra, 0)
        assert len(outside) == 2
        assert all(found == {2} for found in outside.values())
        assert all(found == {1} for found in client.run(in_a_job, 0).values())
