"""`labcal demo`: the whole line on the simulated bench."""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from labcal.cli import app
from labcal.cli.progress import at_a_terminal
from labcal.cli.results import FORCE
from labcal.cli.screen import console, say

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

    from labcal.demo import Demo
    from labcal.record.stream import Item


OPENING = "opening the simulated bench"
EVERY_S = 3.0


class LogLines:
    """What is being done, where it goes into a file or a pipe: a line every few seconds shows that it goes on."""

    def __init__(self) -> None:
        self._began_s = self._last_s = time.monotonic()

    def __call__(self, doing: str) -> None:
        """Say it, where nothing was said for a while."""
        now = time.monotonic()
        if now - self._last_s >= EVERY_S:
            self._last_s = now
            say(f"  ... {now - self._began_s:.0f} s, {doing}", err=True)


@app.command("demo", rich_help_panel="Begin")
def demo(
    seed: int = typer.Option(0, min=0, help="Repeats everything: the simulated lab and the effect that it hides."),
    out: Path = typer.Option(Path("demo-out"), metavar="DIR", help="The folder for what the demo writes."),
    force: bool = FORCE,
) -> None:
    """Run the whole preflight on the simulated bench: cage check, record, fit, close the loop, sign, verify, report."""
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    from labcal.demo import demo as run_demo
    from labcal.demo.folder import make_room

    make_room(out, force=force)
    began = time.monotonic()
    columns = (TextColumn("{task.description:<34}", markup=False), BarColumn(), TimeElapsedColumn())
    with at_a_terminal(Progress(*columns, console=console(stderr=True))) as progress:
        task = progress.add_task(OPENING, total=None)
        log = (lambda doing: None) if progress.console.is_terminal else LogLines()

        def stage(name: str) -> None:
            progress.update(task, description=name, total=None, completed=0)
            log(name)

        def on_item(item: Item) -> None:
            _step(progress, task, item)
            log(progress.tasks[task].description)

        done = run_demo(out, seed, stage=stage, on_item=on_item)
        progress.update(task, description="done", total=1, completed=1)
    _show(done, time.monotonic() - began)


def _step(progress: Progress, task: TaskID, item: Item) -> None:
    """Move the bar at each step of a procedure."""
    from labcal.record.stream import Step

    if isinstance(item, Step):
        progress.update(task, description=item.name, total=item.total, completed=item.number - 1)


def _show(done: Demo, seconds: float) -> None:
    """The result in one table, then what lies where."""
    from rich.table import Table

    closed, screen = done.closed, console(file=sys.stdout, soft_wrap=True)
    table = Table(title="SIMULATED preflight", show_header=False, title_justify="left", box=None, padding=(0, 2, 0, 0))
    causes = ", ".join(" ".join((e.effect, *e.channels)) for e in closed.accepted) or "none"
    table.add_row("run", f"{done.run_id}, {done.rows} samples")
    missed = ", ".join(m.name for m in done.limits_missed)
    table.add_row("limits", missed or "all met (cage check, preflight)")
    table.add_row("held-out error", f"{closed.before.holdout_rms_nT:.1f} nT → {closed.after.holdout_rms_nT:.1f} nT")
    table.add_row("noise alone", f"{closed.noise_floor_nT:.1f} nT")
    table.add_row("cause found", causes)
    table.add_row("verdict", f"{closed.verdict}: {closed.summary}")
    table.add_row("signature", "valid" if done.verification.valid else "DOES NOT HOLD")
    table.add_row("time", f"{seconds:.0f} s")
    screen.print(table, highlight=False)
    for path in sorted(p for p in done.folder.iterdir() if p.is_file()):
        screen.print(f"  {path}", highlight=False)
