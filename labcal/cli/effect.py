"""`labcal effect`: an effect of one's own, begun from what the loop found without a name."""

from __future__ import annotations

from pathlib import Path

import typer

from labcal.cli import DONE, app
from labcal.cli.results import FORCE
from labcal.cli.screen import say

effect = typer.Typer(help="Effects of your own: begin one from a term without a name.", no_args_is_help=True)
app.add_typer(effect, name="effect", rich_help_panel="Extensions")


@effect.command()
def new(
    result: Path = typer.Option(..., "--from", metavar="RESULT.json", help="What close-loop --json wrote."),
    name: str = typer.Option(..., metavar="NAME", help="The effect's id: small letters, digits and hyphens."),
    out: Path = typer.Option(..., metavar="DIR", help="The folder of the package."),
    force: bool = FORCE,
) -> int:
    """Write a package with an effect file whose columns are those of the empirical term, to be filled in."""
    from labcal.session.new_effect import new_effect

    for path in new_effect(result, name, out, force=force):
        say(str(path))
    say(f"Next: pip install -e {out}, then put the physics into the effect's file.")
    return DONE
