"""Rows in gaps that nothing tells are left out, for every rival alike, once a cause that rests on them has weight."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from numpy.typing import NDArray

from labcal.model.gaps import bridged
from labcal.record import Run

Mask = NDArray[np.bool_]


def unresolved_gaps(run: Run, channels: Collection[str]) -> Mask:
    """Rows (n,) in gaps of these channels that nothing can tell."""
    sure = np.ones(len(run), dtype=bool)
    for channel in run.channels:
        if channel.name in channels:
            sure &= bridged(run.t_s, channel.values)[1]
    return ~sure
