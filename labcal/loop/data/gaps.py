"""Rows in unresolved gaps of a channel: left out, for every candidate alike, once a cause with evidence rests on it."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from numpy.typing import NDArray

from labcal.model.gaps import bridged
from labcal.record import Run

Mask = NDArray[np.bool_]


def unresolved_gaps(run: Run, channels: Collection[str]) -> Mask:
    """Rows (n,) in gaps of these channels whose values cannot be inferred."""
    sure = np.ones(len(run), dtype=bool)
    for channel in run.channels:
        if channel.name in channels:
            sure &= bridged(run.t_s, channel.values)[1]
    return ~sure
