"""`labcal report`: a page for people."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import typer

from labcal.cli import app
from labcal.cli.results import FORCE
from labcal.cli.screen import say


@app.command(rich_help_panel="Certificate")
def report(
    source: str = typer.Argument(..., metavar="RUN|CAL", help="A run, or a calibration file (*.json)."),
    out: Path = typer.Option(..., metavar="FILE", help="FILE.html or FILE.pdf; of a calibration also FILE.xml (DCC)."),
    allowed_signers: Path | None = typer.Option(None, help="Check CAL's signatures against this list, not the lab's."),
    before: Path | None = typer.Option(
        None, metavar="OLDCAL", help="Say what changed since this calibration, not since the lab's own before CAL."
    ),
    force: bool = FORCE,
) -> None:
    """Write the report of a run, or the certificate of a calibration.

    A certificate's PDF is PDF/A-3b with the signed file inside where the extra `paper` is there, else a plain one, and
    stderr says so; its XML needs the extra `dcc`.
    """
    from labcal import session

    session.report(source, out, allowed_signers, before=before, tell=partial(say, err=True), force=force)
    say(out)
