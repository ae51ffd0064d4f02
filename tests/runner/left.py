"""How a run left the coils."""

from __future__ import annotations

import time

from labcal.runner import Outcome


def left_as(outcome: Outcome) -> str:
    """What was said of the coils when they were read back last, however long this machine took since."""
    assert outcome.lab is not None
    return outcome.lab.sentence(time.monotonic() - outcome.lab.age_s(time.monotonic()))
