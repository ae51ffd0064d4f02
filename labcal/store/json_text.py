"""JSON as text: what is refused before any part of it is looked at, and the line where a fault is."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from typing import Any, NoReturn

from pydantic import ValidationError

from labcal.errors import InputError
from labcal.store.limits import (
    LONGEST_NUMBER,
    MOST_COLUMNS,
    MOST_KEYS,
    MOST_PARTS,
    MOST_SEGMENTS,
    MOST_VALUES,
    shortened,
)

LONG_NUMBER = re.compile(rf"[0-9]{{{LONGEST_NUMBER + 1}}}")


def check_json(text: str, file: str) -> Any:
    """What the JSON says. Refuses what Python or pydantic would let pass: doubled keys, NaN, endless nesting."""
    if text.count("{") + text.count("[") > MOST_PARTS or text.count(",") > MOST_VALUES:
        raise InputError(f"not a run: its JSON has more than {MOST_PARTS} objects or {MOST_VALUES} values", file=file)
    if LONG_NUMBER.search(text):
        raise InputError(f"not a run: a number of more than {LONGEST_NUMBER} digits", file=file)
    try:
        return json.loads(text, object_pairs_hook=_unique, parse_constant=_not_a_number)
    except json.JSONDecodeError as error:
        raise InputError(f"not JSON: {error.msg}", file=file, line=error.lineno, column=error.colno) from None
    except RecursionError:
        raise InputError("not a run: its JSON is nested too deeply", file=file) from None
    except ValueError as error:  # a doubled key, NaN, or an integer of thousands of digits
        raise InputError(str(error), file=file) from None


def refuse_too_many(said: Any, file: str) -> None:
    """Raise InputError for more segments, channels or keys than any run has, before each is looked at."""
    parts = said if isinstance(said, dict) else {}
    segments, channels = parts.get("segments"), parts.get("channels")
    for name, part, most in (("segments", segments, MOST_SEGMENTS), ("channels", channels, MOST_COLUMNS)):
        if isinstance(part, list | dict) and len(part) > most:
            raise InputError(f"{len(part)} {name} are more than {most}: split the run", file=file, column=name)
    of_segments = (one for one in segments if isinstance(one, dict)) if isinstance(segments, list) else ()
    if len(set(parts).union(*of_segments)) > MOST_KEYS:
        raise InputError(f"not a run: more than {MOST_KEYS} different keys", file=file)


def _unique(pairs: Sequence[tuple[str, Any]]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for key, value in pairs:
        if key in found:
            raise ValueError(f"the key {shortened(key)!r} is there twice in one object")
        found[key] = value
    return found


def _not_a_number(word: str) -> NoReturn:
    raise ValueError(f"expected finite numbers, found {word}")


def refuse(error: ValidationError, text: str, file: str) -> NoReturn:
    """Raise InputError for the first fault that was found: what was expected, at which line and key."""
    first = error.errors(include_url=False)[0]
    path = tuple(part for part in first["loc"] if part != "[key]")
    what = first["msg"].removeprefix("Value error, ").replace("Input should be", "expected")
    if first["type"] == "missing":
        what = "the key is missing"
    elif first["type"] != "value_error":
        what += f", found {str(first['input'])[:40]!r}"
    column = shortened(".".join(map(str, path)), 240) or None
    raise InputError(what, file=file, line=line_of(text, path), column=column) from None


def line_of(text: str, path: Sequence[str | int]) -> int:
    """Line (from 1) of the value at `path`, or of the deepest part of the path that is there."""
    at = _past_blanks(text, 0)
    for key in path:
        at = next((start for name, start in _children(text, at) if name == key), at)
    return text.count("\n", 0, at) + 1


def _children(text: str, at: int) -> Iterator[tuple[str | int, int]]:
    """Keys or indices of the valid JSON value at `at`, each with the place where its value begins."""
    close = {"{": "}", "[": "]"}.get(text[at])
    if close is None:
        return
    decoder, index = json.JSONDecoder(), 0
    at = _past_blanks(text, at + 1)
    while text[at] != close:
        key: str | int = index
        if close == "}":
            key, at = decoder.raw_decode(text, at)
            at = _past_blanks(text, _past_blanks(text, at) + 1)
        yield key, at
        at = _past_blanks(text, decoder.raw_decode(text, at)[1])
        if text[at] == ",":
            at = _past_blanks(text, at + 1)
        index += 1


def _past_blanks(text: str, at: int) -> int:
    while at < len(text) and text[at] in " \t\r\n":
        at += 1
    return at
