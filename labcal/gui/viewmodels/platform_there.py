"""What may be said of a platform that nobody has heard of. No widgets."""

from __future__ import annotations

from labcal.bench.coils import state
from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.viewmodels.lab_now import LabNow


def platform_there(now: LabNow, facts: Bench | None) -> str:
    """What may be said of the platform; of a motor that nobody has heard of, that it may turn."""
    instruments = {} if facts is None else facts.instruments
    motor = any(one.role == "platform" and not one.link.startswith("manual://") for one in instruments.values())
    return now.platform_words or (state.MAY_TURN if motor else "")
