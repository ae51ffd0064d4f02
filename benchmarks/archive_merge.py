"""Two labs' homes pushed into one archive at once, by two processes: the figures of docs/performance.md.

`python benchmarks/archive_merge.py --runs 250 --samples 20000 --calibrations 250`; the PostgreSQL waits for the disk.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests" / "archive"))

from made_lab import signed_calibrations, stored_runs  # noqa: E402
from postgres import Server, server  # noqa: E402

from labcal.session import archiving  # noqa: E402

SITES = ("aalto", "glasgow")


def main() -> None:
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("--runs", type=int, default=250)
    asked.add_argument("--samples", type=int, default=20_000)
    asked.add_argument("--calibrations", type=int, default=250)
    given = asked.parse_args()
    with TemporaryDirectory(prefix="labcal-merge-") as folder, server(hasty=False) as running:
        url = f"{running.url(running.database())}&bundles={folder}/bundles"
        archiving.init_archive(url, None)
        for number, site in enumerate(SITES):
            os.environ["LABCAL_HOME"] = f"{folder}/{site}"
            stored_runs(range(number * given.runs, (number + 1) * given.runs), given.samples)
            signed_calibrations(given.calibrations)
        print(f"each of two homes: {given.runs} runs of {given.samples}, {given.calibrations} calibrations", flush=True)
        for what in ("merged", "the same again"):
            both(running, url, Path(folder), what)


def both(running: Server, url: str, folder: Path, what: str) -> None:
    """Push both homes, the processes begun together."""
    served, begun = running.busy_s(), time.perf_counter()
    processes = [
        subprocess.Popen(
            [sys.executable, "-m", "labcal", "push", "--archive", f"{url}&site={site}"],
            stdout=subprocess.PIPE, text=True, env={**os.environ, "LABCAL_HOME": str(folder / site)},
        )
        for site in SITES
    ]  # fmt: skip
    told = [process.communicate()[0].splitlines()[-1] for process in processes]
    wall = time.perf_counter() - begun
    assert [process.returncode for process in processes] == [0, 0], told
    new = [one.partition("new there ")[2] for one in told]
    print(f"{what}: {wall:.1f} s by the clock, the server {running.busy_s() - served:.1f} s; new: {new}", flush=True)


if __name__ == "__main__":
    main()
