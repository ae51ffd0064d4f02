"""Small TOML files that people write: read in bounded time, every fault one sentence with file, line and column."""

from __future__ import annotations

import codecs
import re
import tomllib
from pathlib import Path
from typing import Any

from labcal.errors import InputError

MOST_BYTES = 1 << 18  # a bench file has a few thousand
DEEPEST = 100  # names in a dotted key: the time to read one grows with the square of them
KEY_SIGNS = re.compile(r"[^\w\"'. \t-]")
PLACE = re.compile(r" \(at line (\d+), column (\d+)\)$")


def read_toml(path: Path) -> tuple[str, dict[str, Any]]:
    """The text of `path` and what it states. Raises InputError where it is no TOML, or more than a person writes."""
    with path.open("rb") as file:
        data = file.read(MOST_BYTES + 1)
    if len(data) > MOST_BYTES:
        raise InputError(f"is longer than {MOST_BYTES // 1024} KiB: no file of this kind is", file=path)
    if data.startswith(codecs.BOM_UTF8):
        raise InputError("begins with a byte order mark: save it as UTF-8 without one", file=path, line=1)
    try:
        text = data.decode()
    except UnicodeDecodeError as error:
        raise InputError("is not UTF-8 text", file=path, line=data[: error.start].count(b"\n") + 1) from error
    for number, line in enumerate(text.splitlines(), 1):
        if max(part.count(".") for part in KEY_SIGNS.split(line)) > DEEPEST:
            raise InputError(f"a key of more than {DEEPEST} names: it is nested too deeply", file=path, line=number)
    try:
        return text, tomllib.loads(text)
    except RecursionError as error:
        raise InputError("is nested too deeply", file=path) from error
    except ValueError as error:  # TOMLDecodeError, and numbers of thousands of digits
        raise _not_toml(str(error), path) from error


def _not_toml(said: str, path: Path) -> InputError:
    place = PLACE.search(said)
    line, column = (int(place[1]), int(place[2])) if place else (None, None)
    return InputError(f"is not TOML: {PLACE.sub('', said)}", file=path, line=line, column=column)
