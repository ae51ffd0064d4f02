"""Text that leaves this computer for others to read, as a problem report: what is secret in it is taken out."""

from __future__ import annotations

import os
import re

from labcal.files.home import SECRETS
from labcal.files.text_safety import without_passwords

SHORTEST = 4  # letters of a secret that is looked for: a shorter one stands in other words too
# What a file, or a remark in it, states under such a name: password = "…", token: …, and the same within JSON.
_STATED = re.compile(
    r"(?i)((?:pass(?:word|phrase|wd)|secret|token|api[_-]?key)\w*\\?[\"']?\s*[=:]\s*)"
    r"(\"(?:[^\"\\\n]|\\.)*\"|'[^'\n]*'|\\?[\"']?[^\"'\n\\#]+)"
)
_QUOTE = re.compile(r"\\?[\"']?")


def without_secrets(text: str) -> str:
    """`text` without what this process was given in confidence, passwords in URLs, and what is called a password."""
    for name in SECRETS:
        secret = os.environ.get(name, "")
        if len(secret) >= SHORTEST:
            text = text.replace(secret, f"({name})")
    text = without_passwords(text)  # what a library makes of such an address is not that address
    return _STATED.sub(_starred, text)


def _starred(found: re.Match[str]) -> str:
    """Its quotes stay where they are, so that TOML and JSON are TOML and JSON still."""
    value, opening = found[2], _QUOTE.match(found[2])
    begin = opening[0] if opening else ""
    return f"{found[1]}{begin}***{begin if len(value) > 1 and begin and value.endswith(begin) else ''}"
