"""The line of a TOML text on which a key is stated, for messages to the person who wrote it."""

from __future__ import annotations

import re
from collections.abc import Sequence

HEAD = re.compile(r"\s*(\[\[?)\s*([^\]]+?)\s*\]\]?\s*(?:#.*)?$")
KEY = re.compile(r"\s*([\w.\"'-]+)\s*=")


def line_of(text: str, path: Sequence[str | int]) -> int | None:
    """Line (from 1) of the value at `path`, or of the deepest part of the path that is there; None for none."""
    wanted = [str(part) for part in path]
    counts: dict[str, int] = {}
    table: list[str] = []
    best, deepest = None, 0
    for number, line in enumerate(text.splitlines(), 1):
        here = table
        if head := HEAD.match(line):
            table = here = _table(head[1], head[2], counts)
        elif key := KEY.match(line):
            here = [*table, *_names(key[1])]
        else:
            continue
        same = _in_common(here, wanted)
        if same > deepest and same == len(here[: len(wanted)]):
            best, deepest = number, same
    return best


def _table(brackets: str, name: str, counts: dict[str, int]) -> list[str]:
    names = _names(name)
    if brackets == "[[":
        counts[name] = counts.get(name, -1) + 1
        return [*names, str(counts[name])]
    return names


def _names(key: str) -> list[str]:
    return [name.strip().strip("\"'") for name in key.split(".")]


def _in_common(one: Sequence[str], other: Sequence[str]) -> int:
    same = (a == b for a, b in zip(one, other, strict=False))
    return next((i for i, is_same in enumerate(same) if not is_same), min(len(one), len(other)))
