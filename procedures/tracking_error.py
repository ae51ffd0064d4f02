"""How far the field was from the one that was wanted, as the reference tells it, and as uncertain as that."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.stated import as_positions
from labcal.bench.steps import Work, measured, note
from labcal.record import Run
from labcal.uncertainty.verdicts import u_declared, uncovered

Array = NDArray[np.float64]


def rms_error(bench: Bench, name: str, seen_nT: Array, wanted_nT: Array, limit_nT: float) -> Work[None]:
    """Measure the rms of the error's length, the reference's means (n, 3) [nT, C] less `wanted_nT` (n, 3) or (3,)."""
    positions = as_positions(bench, seen_nT)

    def rms(positions: Run) -> float:
        assert positions.reference_vector is not None
        return float(np.sqrt(np.mean(np.sum((positions.reference_vector - wanted_nT) ** 2, axis=1))))

    value = rms(positions)
    if left := uncovered(positions):
        yield note(bench, left)
    u = float(np.hypot(value / np.sqrt(2 * len(seen_nT)), u_declared(positions, rms)))
    yield from measured(bench, name, value, u, "nT", limit_nT)
