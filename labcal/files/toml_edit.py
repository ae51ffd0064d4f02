"""One value of a TOML text changed, and nothing else: comments, order and blanks stay as a person wrote them."""

from __future__ import annotations

import re
import tomllib
from copy import deepcopy
from typing import Any, NamedTuple

from labcal.errors import InputError

HEADER = re.compile(r"^\s*\[([^\[\]]+)\]\s*(#.*)?$")
BARE = re.compile(r"[A-Za-z0-9_-]+")
Keys = tuple[str, ...]


class ValueSpan(NamedTuple):
    """Where a value stands in its line."""

    line: int
    before: str
    value: str
    after: str  # a comment, with the blanks before it


def edited(text: str, keys: Keys, value: str) -> str:
    """`text` with `keys` stating `value` (a TOML value, as it is to be written); "" takes the line away.

    Raises InputError where `value` is no TOML value, or the text cannot be changed in this one place alone.
    """
    wanted = deepcopy(tomllib.loads(text))
    _set(wanted, keys, _parsed(keys, value) if value else None)
    lines = text.splitlines(keepends=True)
    place = place_of(lines, keys)
    changed = "".join(_added(lines, keys, value) if place is None else _written(lines, place, value))
    try:
        if tomllib.loads(changed) == wanted:
            return changed
    except tomllib.TOMLDecodeError:
        pass
    raise InputError(
        f"{'.'.join(keys)} is written in a way that is not changed from here: change it in the file itself"
    )


def stated(text: str, keys: Keys) -> str | None:
    """The value of `keys` as it is written; None where no line of its own states it."""
    place = place_of(text.splitlines(keepends=True), keys)
    return None if place is None else place.value


def place_of(lines: list[str], keys: Keys) -> ValueSpan | None:
    """The line that states `keys` whole; None where there is none."""
    for number, (table, line) in enumerate(zip(_tables(lines), lines, strict=True)):
        found = re.match(rf"""^(\s*["']?{re.escape(keys[-1])}["']?\s*=\s*)(.*?)(\s*)$""", line, re.DOTALL)
        if table == keys[:-1] and found and (value := _whole_value(found[2])) is not None:
            return ValueSpan(number, found[1], value, found[2][len(value) :] + found[3])
    return None


def _whole_value(rest: str) -> str | None:
    """What stands before the comment; a # within a string begins none."""
    ends = [*(m.start() for m in re.finditer("#", rest)), len(rest)]
    return next((rest[:end].rstrip() for end in ends if _value(rest[:end]) is not None), None)


def _value(text: str) -> Any:
    try:
        return tomllib.loads(f"x = {text.strip()}").get("x")
    except (tomllib.TOMLDecodeError, RecursionError, ValueError):
        return None


def _parsed(keys: Keys, value: str) -> Any:
    found = None if "\n" in value else _value(value)
    if found is None or _whole_value(value) != value.strip():
        raise InputError(
            f"{'.'.join(keys)}: {value!r} is no value of TOML: 2.5, true, [1.0, 2.0] or text between quotation marks"
        )
    return found


def _set(table: dict[str, Any], keys: Keys, value: Any) -> None:
    for key in keys[:-1]:
        table = table.setdefault(key, {})
        if not isinstance(table, dict):
            raise InputError(f"{'.'.join(keys)}: {key} is no table")
    table[keys[-1]] = value
    if value is None:
        del table[keys[-1]]


def _tables(lines: list[str]) -> list[Keys]:
    """The table that each line belongs to."""
    found, here = list[Keys](), Keys()
    for line in lines:
        if head := HEADER.match(line.rstrip("\r\n")):
            here = _path(head[1]) or here
        found.append(here)
    return found


def _path(name: str) -> Keys:
    try:
        table: Any = tomllib.loads(f"[{name}]")
    except tomllib.TOMLDecodeError:
        return ()  # a row of a list
    keys = Keys()
    while table:
        (key,) = table
        keys, table = (*keys, key), table[key]
    return keys


def _written(lines: list[str], place: ValueSpan, value: str) -> list[str]:
    new = [f"{place.before}{value.strip()}{place.after}"] if value else []
    return [*lines[: place.line], *new, *lines[place.line + 1 :]]


def _added(lines: list[str], keys: Keys, value: str) -> list[str]:
    """With a line more: in the place of one that was commented out, else at the end of its table."""
    if not value:
        return lines
    new, tables = f"{_key(keys[-1])} = {value.strip()}", _tables(lines)
    mine = [n for n, table in enumerate(tables) if table == keys[:-1]]
    for n in mine:
        if found := re.match(rf"^#\s*{re.escape(keys[-1])}\s*=[^#]*(#.*)?$", lines[n].rstrip("\r\n")):
            return [*lines[:n], f"{new}  {found[1] or ''}".rstrip() + "\n", *lines[n + 1 :]]
    if not mine:
        head = ".".join(map(_key, keys[:-1]))
        return [*lines, "" if not lines or lines[-1].endswith("\n") else "\n", f"\n[{head}]\n{new}\n"]
    full = [n for n in mine if lines[n].strip() and not lines[n].lstrip().startswith("#")]
    at = full[-1] + 1 if full else mine[0]
    end = "" if at == 0 or lines[at - 1].endswith("\n") else "\n"
    return [*lines[:at], f"{end}{new}\n", *lines[at:]]


def _key(name: str) -> str:
    return name if BARE.fullmatch(name) else '"' + name.replace("\\", "\\\\").replace('"', '\\"') + '"'
