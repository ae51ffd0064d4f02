"""Results for programs: one JSON file, or standard output and then nothing else there."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import typer

from labcal.files import write_text

JSON = typer.Option(None, "--json", metavar="FILE", help="Write the result as JSON to FILE; - is standard output.")


def write_json(result: Any, where: str) -> None:
    """Write `result` to the file `where`, whole or not at all, or to standard output where that is `-`."""
    text = json.dumps(result, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    if where == "-":
        print(text, end="")
    else:
        write_text(Path(where), text)
