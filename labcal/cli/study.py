"""`labcal study`: many simulated runs, or a fleet of calibrations worked out again, on processes or a cluster."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.results import FORCE
from labcal.cli.screen import console, say

if TYPE_CHECKING:
    from rich.table import Table

    from labcal.study.run import StudyResult

MOST_BESIDE = 4  # points that stand beside each other on a terminal


@app.command("study", rich_help_panel="Calibration")
def study(
    file: Path = typer.Argument(..., metavar="FILE.toml", help="What is asked: docs/study.md."),
    scheduler: str | None = typer.Option(
        None, metavar="tcp://HOST:PORT", help="Work on the Dask cluster of this scheduler (extra `cluster`)."
    ),
    processes: int | None = typer.Option(
        None, min=1, max=1024, help="Processes of this computer: as many as it has cores."
    ),
    out: Path = typer.Option(Path("study-out"), metavar="DIR", help="The folder for results; it is gone on with."),
    force: bool = FORCE,
) -> int:
    """Run a study: Monte Carlo, blind trials, an optimal design, a fleet. Exit code 1: what was asked is not reached.

    Each job that is done is kept in DIR; the same command goes on where one ended, whatever ended it.
    """
    from labcal.errors import InputError
    from labcal.study.run import run_study

    if scheduler is not None and processes is not None:
        raise InputError("--processes are of this computer; with --scheduler the cluster has its own")
    with _progress() as progress:
        done = run_study(
            file, out, scheduler=scheduler, processes=processes, progress=progress, on_remark=partial(say, err=True),
            force=force,
        )  # fmt: skip
    _show(done)
    return DONE if done.summary.reached else NEGATIVE


@contextmanager
def _progress() -> Iterator[Callable[[int, int], None]]:
    """A bar at a terminal; else a line for every tenth of the jobs."""
    if not sys.stderr.isatty():
        yield _tenths
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console(stderr=True), transient=True) as bar:
        task = bar.add_task("jobs", total=None)
        yield lambda done, of: bar.update(task, completed=done, total=of)


def _tenths(done: int, of: int) -> None:
    if done * 10 // of != (done - 1) * 10 // of:
        say(f"{done} of {of} jobs", err=True)


def _show(done: StudyResult) -> None:
    from labcal.study.table import NO_PARQUET, has_parquet

    screen = console()
    screen.print(_table(done))
    screen.print(done.summary.answer, highlight=False)
    earlier = f", {done.kept_before} of them done before" if done.kept_before else ""
    screen.print(f"{done.jobs} jobs{earlier}; {done.without} without a result.", highlight=False)
    if not has_parquet():
        screen.print(NO_PARQUET, highlight=False)
    for path in done.files:
        screen.print(f"  {path}", highlight=False, soft_wrap=True)


def _table(done: StudyResult) -> Table:
    """A column for each point of the grid where they are few, else a row."""
    from rich.table import Table

    from labcal.study.page import cell_text, heading
    from labcal.study.table import columns

    lines, names = done.summary.lines, columns(done.summary.lines)
    rows = [[heading(name), *(cell_text(line.get(name)) for line in lines)] for name in names]
    if len(lines) > MOST_BESIDE:
        rows = [list(row) for row in zip(*rows, strict=True)]
    table = Table(*rows[0], box=None, pad_edge=False, padding=(0, 2, 0, 0))
    for row in rows[1:]:
        table.add_row(*row)
    return table
