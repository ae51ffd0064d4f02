"""Results for programs: one JSON file, or standard output and then nothing else there; and what may be replaced."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import typer

from labcal.files.atomic import write_text
from labcal.files.outputs import claim
from labcal.files.text_safety import escape_unseen

JSON = typer.Option(None, "--json", metavar="FILE", help="Write the result as JSON to FILE; - is standard output.")
FORCE = typer.Option(
    False, "--force", help="Replace a file that is there; never the store, what the command reads, or a signed file."
)


def write_json(result: Any, where: str, command: str, *, inputs: Iterable[Path] = (), force: bool = False) -> None:
    """Write `result` to the file `where`, whole or not at all, or to standard output where that is `-`.

    Raises InputError where `command`, which read `inputs`, may not write there (`labcal.files.outputs`).
    """
    text = escape_unseen(json.dumps(result, indent=1, ensure_ascii=False, allow_nan=False)) + "\n"
    if where == "-":
        sys.stdout.write(text)
        return
    [output] = claim(command, Path(where), inputs=inputs, force=force)
    with output.writing() as file:
        write_text(file, text)


def json_path(where: str | None) -> Path | None:
    """The file that `--json` names; None for standard output."""
    return None if where in (None, "-") else Path(str(where))
