"""A sentence without its figures and reasons. No widgets."""

from __future__ import annotations

import re

ENDS = re.compile(r";|[ \u00a0\u202f]?:(?=[ \u00a0\u202f])")  # in "at 18:02:20" no colon is followed by a space


def in_brief(words: str) -> str:
    """`words` up to the first semicolon or colon; a time stays whole."""
    return ENDS.split(words, maxsplit=1)[0]
