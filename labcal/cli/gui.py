"""`labcal gui`: starts the technician's window as a process of its own, and watches it."""

from __future__ import annotations

from pathlib import Path

import typer

from labcal.cli import app
from labcal.cli.screen import say_lines


@app.command("gui", rich_help_panel="Begin")
def gui(bench: Path | None = typer.Option(None, help="The bench file; else the last one that was used.")) -> int:
    """Open the technician's window. Where it breaks off, a report is kept and it is started again at the same page."""
    from labcal.system.window_watch import watch

    named = ["--bench", str(bench)] if bench is not None else []
    return watch(named, lambda text: say_lines(text.splitlines(), err=True))
