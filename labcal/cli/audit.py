"""`labcal audit`: who did what, when, on which machine."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.results import FORCE, JSON, json_path, write_json
from labcal.cli.screen import console, say
from labcal.files.outputs import claim

if TYPE_CHECKING:
    from labcal.audit import Audit

FORMAT = "labcal-audit/1"


@app.command(rich_help_panel="Runs")
def audit(json_file: str | None = JSON, force: bool = FORCE) -> int:
    """Show the lab's audit log and check it: exit 0 where all fits, else 1 and the first entry that does not.

    --json FILE, - for standard output: the entries, the head, and what does not fit.
    """
    from labcal import session

    claim("audit", json_path(json_file), force=force)
    found = session.read_audit()
    if json_file is not None:
        write_json({"format": FORMAT, "fits": not found.fault, **asdict(found)}, json_file, "audit", force=force)
    if json_file != "-":
        _show(found)
    return NEGATIVE if found.fault else DONE


def _show(found: Audit) -> None:
    from rich.table import Table

    table = Table("", "UTC", "who", "machine", "did", "to what", box=None)
    for entry in found.entries:
        about = ", ".join(f"{name} {value}" for name, value in entry.about.items())
        who = entry.who if entry.who == entry.login else f"{entry.who} ({entry.login})"
        table.add_row(str(entry.number), entry.utc, who, entry.machine, entry.deed, about)
    if found.entries:
        console().print(table)
    if found.fault:
        return say(f"NOT SOUND: {found.fault}; what is above it fits")
    if not found.entries:
        return say("no entries yet")
    return say(f"sound: {len(found.entries)} entries, head {found.head}")
