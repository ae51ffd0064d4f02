"""Regular expressions that somebody states: only such as come to an end soon, whatever text they meet.

`re` tries one after the other all ways to divide a text among the repetitions and choices of a pattern. How many those
are follows from the pattern and the length of the text: `(a+)+` has 2^n for n letters, `a*a*` n².
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import prod

LONGEST_TEXT = 100  # letters of a text that is matched
LONGEST_PATTERN = 200
MOST_WAYS = 2_000_000  # three free repetitions have half of them; trying all takes a fraction of a second
_PIECE = re.compile(
    r"\\.|\[\^?]?(?:\\.|[^]\\])*]|\(\?(?::|P<\w+>|.)|[()|]|(?:[*+?]|\{\d*,?\d*})[?+]?|.",
    re.DOTALL,
)
_REPEAT = re.compile(r"([*+?])[?+]?|\{(\d*)(,?)(\d*)}[?+]?")


def bounded(pattern: str) -> re.Pattern[str]:
    """`pattern`, compiled. Raises ValueError where it is no regular expression, or one that may take long to match."""
    if len(pattern) > LONGEST_PATTERN:
        raise ValueError(f"has {len(pattern)} letters: at most {LONGEST_PATTERN}")
    try:
        compiled = re.compile(pattern)
    except (re.error, OverflowError) as error:
        raise ValueError(f"is no regular expression: {error}") from None
    if _ways(iter(_PIECE.findall(pattern))) > MOST_WAYS:
        raise ValueError("may take very long to match: at most three * or +, and none around another, or around a |")
    return compiled


def _ways(pieces: Iterator[str]) -> int:
    """At most so many ways to match the pieces up to the end of their group: alternatives add up, parts multiply."""
    others, parts, group = 0, [1], False
    for piece in pieces:
        if piece == ")":
            break
        if piece == "|":
            others, parts = others + prod(parts), [1]
        elif repeat := _REPEAT.fullmatch(piece):
            parts[-1] = _repeated(parts[-1], *_times(*repeat.groups()), group)
        else:
            group = _opens(piece)
            parts.append(_ways(pieces) if group else 1)
    return others + prod(parts)


def _opens(piece: str) -> bool:
    """Whether a group begins. Raises ValueError for what has no count: looking ahead, conditions, flags."""
    if piece.startswith("(?") and piece != "(?:" and not piece.startswith("(?P<"):
        raise ValueError(f"has a {piece}…: of what begins with (? only (?: and (?P<name> are taken")
    return piece.startswith("(")


def _times(sign: str | None, least: str, comma: str, most: str) -> tuple[int, int]:
    """How often at least and at most, in a text of `LONGEST_TEXT`."""
    if sign:
        return int(sign == "+"), 1 if sign == "?" else LONGEST_TEXT
    low = int(least or 0)
    return low, max(low, min(int(most), LONGEST_TEXT) if most else LONGEST_TEXT if comma else low)


def _repeated(ways: int, least: int, most: int, group: bool) -> int:
    """The ways of a part that comes `least` to `most` times. Where it is more than any pattern may have, just that."""
    if ways == 1:
        return max(most - least + 1, least if group else 1)  # a group is tried anew each time, even one of no letters
    if most > MOST_WAYS.bit_length():
        return MOST_WAYS + 1
    return min(MOST_WAYS + 1, sum(int(ways**times) for times in range(least, most + 1)))
