"""Effects of the data: rows that say nothing of the sensor. They are set aside and counted, never modelled."""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Family, Scene, Term
from labcal.record import Run


def nothing(term: Term, scene: Scene) -> Array:
    """No columns."""
    return np.zeros((len(scene), 3, 0))


def no_candidates(run: Run) -> list[Term]:
    """None: `labcal.loop` finds these rows before any effect is tried."""
    return []


OUTLIERS = Family("outliers", "data", nothing, no_candidates, experiment="repeat the segment and look at the link")
SATURATION = Family("saturation", "data", nothing, no_candidates, experiment="repeat at half the field")
