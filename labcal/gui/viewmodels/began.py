"""When a run began, by the clock of this place."""

from __future__ import annotations

from datetime import UTC, datetime


def now() -> str:
    """As the lists write it."""
    return f"{datetime.now():%Y-%m-%d %H:%M}"


def began_at(run_id: str) -> str:
    """When a run of this id began by the clock of this place, as its row in the lists says it; "" where it does not."""
    try:
        utc = datetime.strptime(run_id.partition("-")[0], "%Y%m%dT%H%M%S").replace(tzinfo=UTC)
    except ValueError:
        return ""
    return f"{utc.astimezone():%Y-%m-%d %H:%M}"
