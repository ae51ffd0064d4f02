"""A cluster of Dask's own programs: a scheduler and workers of one thread, each a process, on loopback TCP."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

WITHIN_S = 300.0


@dataclass(frozen=True)
class Cluster:
    """Where its scheduler listens, and its processes."""

    address: str
    scheduler: subprocess.Popen[bytes]
    workers: list[subprocess.Popen[bytes]]


@contextmanager
def cluster_of(number: int, folder: Path) -> Iterator[Cluster]:
    """So many workers; all are killed at the end."""
    place = folder / "scheduler.json"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "cwd": folder}
    common = ["--host", "127.0.0.1", "--no-dashboard"]
    tool = [
        sys.executable,
        "-m",
        "distributed.cli.dask_scheduler",
        "--port",
        "0",
        "--scheduler-file",
        str(place),
        *common,
    ]
    processes = [subprocess.Popen(tool, **quiet)]
    try:
        until = time.monotonic() + WITHIN_S
        while not (place.exists() and b"tcp://" in place.read_bytes()):
            assert time.monotonic() < until, "no scheduler"
            time.sleep(0.02)
        address = place.read_text().split('"address": "')[1].split('"')[0]
        worker = [sys.executable, "-m", "distributed.cli.dask_worker", address, *common,
                  "--nthreads", "1", "--no-nanny", "--local-directory", str(folder)]  # fmt: skip
        processes += [subprocess.Popen(worker, **quiet) for _ in range(number)]
        yield Cluster(address, processes[0], processes[1:])
    finally:
        for process in reversed(processes):
            process.kill()
            process.wait()
