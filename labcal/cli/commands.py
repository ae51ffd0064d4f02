"""Registers every command group on the app, in the order of the lab's work."""

from __future__ import annotations

import typer

from labcal.cli import (  # noqa: F401  each registers its commands
    app,
    archive,
    audit,
    bench,
    conformity,
    demo,
    effect,
    fitting,
    gui,
    keys,
    loop,
    numbers,
    plugins,
    report,
    run,
    runs,
    self_test,
    signing,
    study,
    watch,
    years,
)
from labcal.version import __version__


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"labcal {__version__}")
        raise typer.Exit


@app.callback()
def root(
    version: bool = typer.Option(False, "--version", callback=_version, is_eager=True, help="Print the version."),
) -> None:
    """Calibrate a magnetometer before it flies: run the bench, fit, close the loop, sign."""
