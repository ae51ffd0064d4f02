"""`labcal self-test`: the installation qualification."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.results import FORCE
from labcal.cli.screen import say

if TYPE_CHECKING:
    from labcal.self_test import Check


@app.command("self-test", rich_help_panel="Begin")
def self_test(
    out: Path | None = typer.Option(
        None, metavar="FILE.pdf", help="Keep the page here; without it, in `self-tests` of labcal's folder."
    ),
    force: bool = FORCE,
) -> int:
    """Qualify this installation: versions, files, a simulated preflight, loop, signature, the window; keep a page.

    Exit 0 where no check failed, else 1. What could not be shown (no instrument plugged in) is said, and is no failure.
    """
    from labcal import self_test as testing

    keep = testing.place_for(out, force=force)
    found = testing.qualify(lambda name: say(f"  … {name}"), _tell)
    page = testing.write_page(found, keep)
    say("passed" if found.passed else "NOT PASSED")
    say(page)
    return DONE if found.passed else NEGATIVE


def _tell(check: Check) -> None:
    mark = {"pass": "✓", "FAIL": "✕"}.get(check.result, "–")
    say(f"{mark} {check.name}: {check.said}")
    if check.todo:
        say(f"  {check.todo}")
