"""Text that is shown to people as it stands: nothing in it commands a terminal or turns the direction of reading."""

from __future__ import annotations

import json
import os
import re
import sys
from io import TextIOWrapper
from typing import Any

# What a terminal obeys, what turns the direction of reading, and what XML or UTF-8 cannot write.
_ACTS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff\ufffe\uffff]")
# What a reader does not see, or not where it stands: the same, with zero widths, marks of direction, joiners and tags.
_UNSEEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\xad\u061c\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f\ud800-\udfff"
    "\ufeff\ufff9-\ufffb\ufffe\uffff\U000e0000-\U000e0fff]"
)
# Of a URL: up to the last @, for one that is not written %40 is part of the password; or as a setting after the ?.
_PASSWORD = re.compile(r"(?<=://)([^\s/:@]*:)\S*(?=@)|([?&](?:ssl)?password=)[^\s&]*")


def in_utf8() -> None:
    """What this process says is UTF-8, as JSON is, whatever the system's own encoding; nowhere, if nobody listens."""
    sys.stdout, sys.stderr = sys.stdout or open(os.devnull, "w"), sys.stderr or open(os.devnull, "w")  # noqa: SIM115
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="backslashreplace")


def without_passwords(text: str) -> str:
    """`text` with *** in place of the password in every URL."""
    return _PASSWORD.sub(lambda found: f"{found[1] or found[2]}***", text)


def replace_unseen(text: str) -> str:
    """`text` as a terminal may get it, with U+FFFD in place of every character that acts or is not seen."""
    return _UNSEEN.sub("\ufffd", text)


def one_line(text: str) -> str:
    """`text` as `seen`, with a blank in place of tabs and line ends: nothing in it begins a line of its own."""
    if text.isascii() and text.isprintable():
        return text
    return replace_unseen(re.sub(r"[\t\r\n]+", " ", text))


def escape_unseen(json_text: str) -> str:
    """JSON that means the same, with an escape in place of every character that acts or is not seen."""
    return _UNSEEN.sub(lambda found: json.dumps(found[0])[1:-1], json_text)


def checked_text(text: str) -> str:
    """`text` itself. Raises ValueError where it holds a character that acts; a tab and a line end do not."""
    if found := _ACTS.search(text):
        raise ValueError(f"holds the control character U+{ord(found[0]):04X}")
    return text


def replace_control(value: Any) -> Any:
    """`value` (JSON) with U+FFFD in place of every character in its texts that acts."""
    if isinstance(value, str):
        return _ACTS.sub("\ufffd", value)
    if isinstance(value, dict):
        return {replace_control(key): replace_control(item) for key, item in value.items()}
    return [replace_control(item) for item in value] if isinstance(value, list | tuple) else value
