"""What came over a line instead of an answer: first in plain words, the line itself is for the details."""

from __future__ import annotations

import re

QUOTED = re.compile(r"(?P<who>[^:'\"]+): .+ (?:was|is) answered (?:with )?b?['\"].*", re.DOTALL)
NO_MODBUS = re.compile(
    r"(?:address \d+ on (?P<who>[^:()]+) \([^()]*\)|(?P<where>address \d+) on \S+): no valid Modbus reply[.]?"
)
NOT_AS_IT_SHOULD, NO_ANSWER = "does not answer as it should", "no answer"


def plainly(what: str) -> str:
    """The sentence `what` without the signs of a protocol; as it is where it has none."""
    if found := QUOTED.fullmatch(what):
        return f"{found['who']}: {NOT_AS_IT_SHOULD}."
    if found := NO_MODBUS.fullmatch(what):
        return f"{found['who'] or found['where']}: {NO_ANSWER}."
    return what
