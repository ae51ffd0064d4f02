"""What is wrong in a trial's record, in the words of the table."""

from __future__ import annotations

import re
from typing import Any

from kinds import Kind, kinds

OF_THE_STORE = re.compile(r"session: .*\b(store|disk|file)\b", re.IGNORECASE)
NOT_AT_ZERO = re.compile(
    r"\bNOT\b|unknown|still flows|not zero|no reply|link was lost|another instrument|switch .* off"
)
OF_TIME = frozenset({"late at zero", "zero heard late"})
LATE_S = 0.1  # of the machine itself, beyond which a trial says nothing about two seconds


def in_time_can_be_told(record: dict[str, Any]) -> bool:
    """Whether the machine let a process run that hardly works: else none could have been in time."""
    return bool(record["machine_late_s"] <= LATE_S)


def late_by_itself(record: dict[str, Any], took_s: float | None) -> bool:
    """Whether it took longer than the limit, by more than the machine kept a process waiting meanwhile."""
    return took_s is None or took_s > record["limit_s"] + record["machine_late_s"]


def faults(record: dict[str, Any]) -> list[str]:
    """Every fault that this trial found; none where all is well."""
    kind = kinds()[record["kind"]]
    found = list[str]()
    if not kind.never:
        if record["at_zero_s"] is None:
            found.append("never at zero")
        elif late_by_itself(record, record["at_zero_s"]):
            found.append("late at zero")
        if not kind.cut and (record["heard_s"] is None or late_by_itself(record, record["heard_s"])):
            found.append("zero heard late")
    found += ["energised again"] * bool(record["rose"])
    found += ["false zero"] * bool(record["false_zero"])
    found += ["rows lost"] * bool(record["rows_lost"] and not _said(record, OF_THE_STORE))
    found += ["current not told"] * bool(record["left_A"] and not kind.never and not _said(record, NOT_AT_ZERO))
    found += ["traceback"] * bool(record["traceback"])
    return found + ["session goes on"] * _goes_on(kind, record)


def _said(record: dict[str, Any], what: re.Pattern[str]) -> bool:
    return any(what.search(words) for _, words in record["words"])


def _goes_on(kind: Kind, record: dict[str, Any]) -> bool:
    """Whether a session that could end did not within thirty seconds of the time when zero was due."""
    return record["code"] is None and not (kind.never or kind.session_stopped or kind.window)
