"""A person who lets a run begin that the check standard keeps from it."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class AnswersFor:
    """Who answers for a run and why, signed where `key` names a key; the passphrase is used and forgotten."""

    who: str
    because: str
    key: str = ""
    passphrase: str = field(default="", repr=False)
