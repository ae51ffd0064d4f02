"""What a study does beside its jobs, however many they are: the figures of docs/study.md.

`python benchmarks/study_bookkeeping.py`: the jobs' own work is left out, their rows are made up. Processor time of the
whole command with nothing done before, and once more with all of it kept.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from labcal.study import run
from labcal.study.job import Job, Row

STUDY = 'format = "labcal-study/1"\nkind = "monte-carlo"\n'
MADE_UP = {"why_not": "", "lab_s": 315.5, "rows": 813, "limits_missed": 0, "direction_error_deg": 0.0033,
           "direction_U_deg": 1.0, "magnitude_error_nT": 4.08, "k_error_nT": 0.5}  # fmt: skip


def main() -> None:
    run.on_processes = made_up
    with TemporaryDirectory(prefix="labcal-bookkeeping-") as folder:
        os.environ["LABCAL_HOME"] = f"{folder}/home"
        taken(Path(folder), STUDY + "seeds = 10\n")  # the first has to load what all need
        for seeds in (500, 2000, 8000):
            report(f"one point, {seeds} seeds", taken(Path(folder), STUDY + f"seeds = {seeds}\n"))
        for points in (50, 200, 800):
            fields = [[20e3 + number] for number in range(points)]
            grid = f"seeds = 1\n[grid.settings]\nmagnitudes_nT = {fields}\n"
            report(f"{points} points, one seed", taken(Path(folder), STUDY + grid))


def made_up(jobs: Sequence[Job], processes: int) -> Iterator[tuple[Job, Row]]:
    return ((job, dict(MADE_UP)) for job in jobs)


def taken(folder: Path, text: str) -> tuple[int, float, float]:
    """How many jobs, and what they took the first time and the second [s of a processor]."""
    (file := folder / "study.toml").write_text(text)
    with TemporaryDirectory(dir=folder) as out:
        begun = time.process_time()
        done = run.run_study(file, Path(out))
        between = time.process_time()
        assert run.run_study(file, Path(out)).kept_before == done.jobs
        return done.jobs, between - begun, time.process_time() - between


def report(what: str, found: tuple[int, float, float]) -> None:
    jobs, first, again = found
    print(f"{what}: {1e3 * first / jobs:.2f} ms a job; all kept before {1e3 * again / jobs:.2f} ms", flush=True)


if __name__ == "__main__":
    main()
