"""Small TOML files that people write: read in bounded time, every fault one sentence with file, line and column."""

from __future__ import annotations

import codecs
import re
import tomllib
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from labcal.errors import InputError
from labcal.files.plain_file import first_bytes

MOST_BYTES = 1 << 18  # a bench file has a few thousand
DEEPEST = 100  # names in a dotted key: the time to read one grows with the square of them
KEY_SIGNS = re.compile(r"[^\w\"'. \t-]")
TABLE = re.compile(r"(?m)^(?=[ \t]*\[)")
PLACE = re.compile(r" \(at line (\d+), column (\d+)\)$")


def read_toml(path: Path) -> tuple[str, dict[str, Any]]:
    """The text of `path` and what it states. Raises InputError where it is no TOML, or more than a person writes."""
    data = first_bytes(path, MOST_BYTES + 1)
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


def readable_parts(path: Path) -> list[dict[str, Any]]:
    """What stands in a file that is no TOML as a whole: of each table, from "[" to "[", the lines that can be read.

    For the way to zero alone, which takes what it can have. Raises OSError where the file cannot be read.
    """
    text = first_bytes(path, MOST_BYTES).decode(errors="replace").removeprefix("\ufeff")
    return [_lines_read(*part.splitlines()) for part in TABLE.split(text) if part.strip()]


def _lines_read(head: str, *lines: str) -> dict[str, Any]:
    """The table that begins with `head`, without the lines that cannot be read; of what is said twice the first."""
    found = dict[str, Any]()
    for line in ("", *lines):
        with suppress(ValueError, RecursionError):
            add_missing(found, tomllib.loads(f"{head}\n{line}"))
    return found


def add_missing(found: dict[str, Any], more: dict[str, Any]) -> None:
    """Put into the table `found` what it does not have yet of `more`, tables within tables alike."""
    for key, value in more.items():
        if isinstance(value, dict) and isinstance(found.get(key), dict):
            add_missing(found[key], value)
        else:
            found.setdefault(key, value)


def named_files(path: Path) -> list[Path]:
    """`path` and the files that are named anywhere in it, from its own folder or from here."""
    texts = _texts(read_toml(path)[1])
    return [path, *(file for text in texts for file in (path.parent / text, Path(text)) if text and _is_file(file))]


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    for part in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from _texts(part)


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):  # no name of a file
        return False


def _not_toml(said: str, path: Path) -> InputError:
    place = PLACE.search(said)
    line, column = (int(place[1]), int(place[2])) if place else (None, None)
    return InputError(f"is not TOML: {PLACE.sub('', said)}", file=path, line=line, column=column)
