"""The lab as it is to hands, and what may be said of a platform that nobody has heard of. No widgets."""

from __future__ import annotations

from dataclasses import replace

from labcal.bench.coils import state
from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.viewmodels.lab_now import LabNow


def lab_there(now: LabNow, facts: Bench | None) -> LabNow:
    """An emulated one is no more once its run is over, whatever turned in it."""
    if facts is None or not facts.virtual_time or now.driven:
        return now
    read = now.coil_words != state.NOT_READ
    return replace(
        now, coil_words=now.coil_words if read else "", platform_words="", platform_old_s=None, platform_lost=False
    )


def platform_there(now: LabNow, facts: Bench | None) -> str:
    """What may be said of the platform; of a motor that nobody has heard of, that it may turn."""
    instruments = {} if facts is None else facts.instruments
    motor = any(one.role == "platform" and not one.link.startswith("manual://") for one in instruments.values())
    return now.platform_words or (state.MAY_TURN if motor else "")
