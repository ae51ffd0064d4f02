"""When a run began, by the clock of this place."""

from __future__ import annotations

from datetime import datetime

from labcal.gui.ipc.run_began import began_at as began_at


def now() -> str:
    """As the lists write it."""
    return f"{datetime.now():%Y-%m-%d %H:%M}"
