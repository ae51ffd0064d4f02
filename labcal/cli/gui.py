"""`labcal gui`: starts the technician's window as a process of its own."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import typer

from labcal.cli import app
from labcal.files.home import for_children


@app.command("gui", rich_help_panel="Begin")
def gui(bench: Path | None = typer.Option(None, help="The bench file; else the last one that was used.")) -> int:
    """Open the technician's window."""
    named = ["--bench", str(bench)] if bench is not None else []
    return subprocess.run(
        [sys.executable, "-P", "-m", "labcal.gui", *named], env=for_children(), check=False
    ).returncode
