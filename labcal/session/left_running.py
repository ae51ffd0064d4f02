"""Whether a run on a bench was left without an end."""

from __future__ import annotations

from labcal.files.home import home
from labcal.record.left_running import LeftRunning
from labcal.store.left_running import left_running as of_store
from labcal.store.listing import FILE


def left_running(bench: str) -> LeftRunning | None:
    """The last run of the user's store on the bench of this name, where nobody has ended it. Raises InputError."""
    return of_store(home() / FILE, bench)
