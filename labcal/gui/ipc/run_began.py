"""When a run began, as its id says it, by the clock of this place."""

from __future__ import annotations

from datetime import UTC, datetime


def began_at(run_id: str) -> str:
    """As the run's row in the lists says it; "" where the id does not."""
    try:
        utc = datetime.strptime(run_id.partition("-")[0], "%Y%m%dT%H%M%S").replace(tzinfo=UTC)
    except ValueError:
        return ""
    return f"{utc.astimezone():%Y-%m-%d %H:%M}"
