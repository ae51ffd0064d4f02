"""What two workers of `labcal study` get done beside one, on local processes and on a Dask cluster on this computer.

    python benchmarks/study_efficiency.py --jobs 24

Jobs are blind trials of more than a second each. Other programs may be busy here, so the clock alone says little:

- waste: processor time of a job's own thread with two workers over that with one, the median of all pairs;
- beside: what the worker's other threads take of a core while it is at a job, by the clock. They watch sockets and
  timers so many times a second, however little of a core the job is given meanwhile: measured as part of a job on a
  machine with a load of ten they seem ten times as much;
- idle: the part of a worker's time, from its first job to its last, that it spent between two jobs. A worker that
  waits within a job for a processor which somebody else has is not idle: the study has given it work.

Efficiency is (1 - idle) (1 - beside) / waste. A last line says whether all results were the same bytes.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path
from statistics import median
from typing import Any

STUDY = """
format = "labcal-study/1"
kind = "blind"
seeds = {jobs}

[settings]
modes = ["nominal"]
reverse = false
magnitudes_nT = [50000.0]
timing_nT = 50.0
"""


NOTES = "LABCAL_EFFICIENCY_NOTES"  # the folder that workers write into when they did what


def noted_work(job: Any) -> Any:
    """Do a job, and leave a line: its key, when it began and ended [s, monotonic], processor time of it and of all [s].

    A job has one thread of linear algebra, its own.
    """
    from labcal.study.work import work

    begun, own, busy = time.monotonic(), time.thread_time(), time.process_time()
    row = work(job)
    line = f"{job.key} {begun} {time.monotonic()} {time.thread_time() - own} {time.process_time() - busy}\n"
    with Path(os.environ[NOTES], str(os.getpid())).open("a") as file:
        file.write(line)
    return row


def dask_setup(worker: Any) -> None:
    """What a worker of Dask does as it starts (`--preload`): jobs are noted there too."""
    from labcal.study import cluster as on_cluster

    on_cluster.work = noted_work


def taken(folder: Path) -> tuple[dict[str, float], float, float]:
    """Processor time of each job; parts of the workers' time: between jobs, and of other threads while at one."""
    busy, idle, beside, whole = dict[str, float](), 0.0, 0.0, 0.0
    for file in folder.iterdir():
        jobs = [(key, *map(float, rest)) for key, *rest in map(str.split, file.read_text().splitlines())]
        busy.update((key, own) for key, _, _, own, _ in jobs)
        span = jobs[-1][2] - jobs[0][1]
        whole, idle = whole + span, idle + span - sum(end - begin for _, begin, end, _, _ in jobs)
        beside += sum(every - own for *_, own, every in jobs)
    return busy, idle / whole, beside / (whole - idle)


@contextmanager
def cluster(folder: Path, workers: int) -> Iterator[str]:
    """A scheduler and workers of one thread, on loopback; its address."""
    place, quiet = folder / "scheduler.json", {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    common = ["--no-dashboard", "--scheduler-file", str(place)]
    one_thread = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    tool = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", *common]
    processes = [subprocess.Popen(tool, **quiet)]
    try:
        while not (place.exists() and b"tcp://" in place.read_bytes()):
            time.sleep(0.1)
        address = place.read_text().split('"address": "')[1].split('"')[0]
        words = [sys.executable, "-m", "distributed.cli.dask_worker", address, "--host", "127.0.0.1", "--nthreads", "1",
                 "--no-nanny", "--no-dashboard", "--local-directory", str(folder), "--preload", __file__]  # fmt: skip
        processes += [subprocess.Popen(words, **quiet, env=one_thread) for _ in range(workers)]
        yield address
    finally:
        for process in reversed(processes):
            process.kill()
            process.wait()


def bytes_of(folder: Path) -> str:
    """One SHA-256 of all files of a study's results."""
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    return sha256(b"".join(path.name.encode() + path.read_bytes() for path in files)).hexdigest()


def main() -> int:
    """Measure, print."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("--jobs", type=int, default=24)
    given = asked.parse_args()
    from labcal.study import engine
    from labcal.study.run import run_study

    engine.work = noted_work
    found, busy = set[str](), dict[str, dict[str, float]]()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        os.environ["LABCAL_HOME"] = str(folder / "home")
        (folder / "study.toml").write_text(STUDY.format(jobs=given.jobs))

        def measure(who: str, **how: Any) -> None:
            out = folder / who
            run_study(folder / "study.toml", out, **how)
            found.add(bytes_of(out))
            busy[who], idle, beside = taken(Path(os.environ[NOTES]))
            waste = median(cpu / busy["one process"][key] for key, cpu in busy[who].items())
            each = median(busy[who].values())
            efficiency = (1 - idle) * (1 - beside) / waste
            print(f"{who}: a job {each:.2f} s of processor, waste {waste:.3f}, idle {100 * idle:.1f} %, "
                  f"beside {100 * beside:.2f} %, efficiency {efficiency:.3f}", flush=True)  # fmt: skip

        for engine_name, processes in (("one process", 1), ("two processes", 2)):
            measure(engine_name, processes=noted(folder, engine_name, processes))
        noted(folder, "dask", 2)
        with cluster(folder, 2) as address:
            measure("two workers of Dask", scheduler=address)
    print("the same bytes" if len(found) == 1 else f"{len(found)} different results")
    return int(len(found) != 1)


def noted(folder: Path, engine: str, processes: int) -> int:
    """Make a folder for the notes of this engine's workers; returns `processes`."""
    place = folder / f"notes of {engine}"
    place.mkdir()
    os.environ[NOTES] = str(place)
    return processes


if __name__ == "__main__":
    sys.exit(main())
