"""What a check found, and what all of them make."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path
from typing import Literal

Result = Literal["pass", "not shown", "FAIL"]


@dataclass(frozen=True, slots=True)
class Check:
    """One check: `said` is what was found, `todo` what a person does about it. "not shown" is no failure."""

    name: str
    result: Result
    said: str
    todo: str = ""
    picture: bytes | None = None  # PNG


@dataclass(frozen=True, slots=True)
class Computer:
    """What was qualified, when."""

    labcal: str
    folder: Path  # that labcal runs from
    python: str
    system: str
    machine: str
    user: str
    when: datetime


@dataclass(frozen=True, slots=True)
class Qualification:
    """All checks of one installation."""

    computer: Computer
    checks: tuple[Check, ...]

    @property
    def passed(self) -> bool:
        """Whether no check failed."""
        return all(check.result != "FAIL" for check in self.checks)


def guarded(name: str, look: Callable[[], Check]) -> Check:
    """The check that `look` makes; one that cannot be made, for whatever reason, has failed."""
    try:
        return replace(look(), name=name)
    except Exception as error:
        return Check(name, "FAIL", f"{type(error).__name__}: {error}")
