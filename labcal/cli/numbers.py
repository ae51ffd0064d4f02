"""`labcal numbers`: the certificates of this lab by number, and those that are void."""

from __future__ import annotations

from dataclasses import asdict

import typer

from labcal.cli import app
from labcal.cli.results import FORCE, JSON, json_path, write_json
from labcal.cli.screen import console, say
from labcal.files.outputs import claim

FORMAT = "labcal-numbers/1"


@app.command(rich_help_panel="Certificate")
def numbers(
    void: str | None = typer.Option(None, metavar="NUMBER", help="Keep this number of a draft as void; say --reason."),
    reason: str = typer.Option("", help="Why it is void."),
    json_file: str | None = JSON,
    force: bool = FORCE,
) -> None:
    """Show the certificate numbers of this lab: taken by a draft, signed, or void with the reason.

    `approve` takes the next of the bench, LAB-BENCH-YEAR-NNNN, or `sign` where nobody approved.
    """
    from rich.table import Column, Table

    from labcal import session

    claim("numbers", json_path(json_file), force=force)
    if void is not None:
        session.void_number(void, reason)
    found = session.numbers()
    if json_file is not None:
        write_json({"format": FORMAT, "numbers": [asdict(one) for one in found]}, json_file, "numbers", force=force)
    if json_file == "-":
        return None
    if not found:
        return say("no certificate has a number yet")
    table = Table(Column("number", no_wrap=True), "taken", "run", "file", "", box=None)
    for one in found:
        state = f"void: {one.reason}" if one.state == "void" else one.state
        table.add_row(one.number, one.utc[:10], one.run_id, one.file, state)
    return console().print(table)
