"""A study killed and gone on with, on processes and on a Dask cluster: the hashes of docs/study.md.

    python benchmarks/study_killed.py [--sensors 8]

A made-up fleet is worked out again by one process; by a study that is killed (SIGKILL) with a part of its jobs done and
goes on with two processes; and by one that is killed on a cluster of two workers, of which one is killed as well.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
from hashlib import sha256
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "study"))
from dask_cluster import cluster_of
from fleet import build, bytes_of

RESULTS = ("table.csv", "table.parquet", "summary.json", "report.html")
Words = tuple[str, ...]


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sensors", type=int, default=8)
    number = parser.parse_args().sensors
    with tempfile.TemporaryDirectory() as place, cluster_of(2, Path(place)) as cluster:
        study, folder = build(Path(place) / "fleet", number), Path(place)
        scheduler = ("--scheduler", cluster.address)
        show("one process, at one go", *studied(study, folder / "one", ("--processes", "1"), number))
        show("two processes, killed", *studied(study, folder / "two", ("--processes", "2"), number, killed=True))
        done = studied(study, folder / "dask", scheduler, number, killed=True, worker=cluster.workers[0])
        show("two workers of Dask, study and a worker killed", *done)


def studied(
    study: Path,
    out: Path,
    engine: Words,
    number: int,
    *,
    killed: bool = False,
    worker: subprocess.Popen[bytes] | None = None,
) -> tuple[int, dict[str, bytes]]:
    """Do it, killed with some of it done where that is wanted; how many jobs that were, and what it left."""
    command, kept = [sys.executable, "-m", "labcal", "study", str(study), "--out", str(out), *engine], 0
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    if killed:
        process = subprocess.Popen(command, **quiet)
        while len(list(out.glob("jobs/*.json"))) < 2:
            time.sleep(0.01)
        process.kill()
        process.wait()
        if worker is not None:
            worker.kill()
        kept = len(list(out.glob("jobs/*.json")))
        assert kept < number
    subprocess.run(command, check=True, **quiet)
    return kept, bytes_of(out)


def show(how: str, kept: int, left: dict[str, bytes]) -> None:
    """A line of the table."""
    hashes = " | ".join(f"`{sha256(left[name]).hexdigest()[:16]}`" for name in RESULTS)
    print(f"| {how} | {kept or '–'} | {hashes} |", flush=True)


if __name__ == "__main__":
    main()
