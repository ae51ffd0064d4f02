"""The date that a computed reference is of."""

from __future__ import annotations

from datetime import UTC, date, datetime


def day_of(stated: str | date | None, started_utc: str) -> date:
    """The date that is stated, else that of the recording's start."""
    if isinstance(stated, date):
        return stated
    moment = datetime.fromisoformat(stated or started_utc)
    return moment.astimezone(UTC).date() if moment.tzinfo else moment.date()
