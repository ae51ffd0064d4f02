"""How far the field was from the one that was wanted, as the reference tells it, and as uncertain as that."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.stated import as_positions
from labcal.bench.steps import Work, measured, note
from labcal.record import Run
from labcal.uncertainty.verdicts import rms, u_of_size, uncovered

Array = NDArray[np.float64]


def rms_error(bench: Bench, name: str, seen_nT: Array, wanted_nT: Array, limit_nT: float) -> Work[None]:
    """Measure the rms of the error's length, the reference's means (n, 3) [nT, C] less `wanted_nT` (n, 3) or (3,)."""
    positions = as_positions(bench, seen_nT)

    def errors(run: Run) -> Array:
        assert run.reference_vector is not None
        return (run.reference_vector - wanted_nT).ravel()

    value = float(of_length(errors(positions)))
    if left := uncovered(positions):
        yield note(bench, left)
    u = float(np.hypot(value / np.sqrt(2 * len(seen_nT)), u_of_size(positions, errors, of_length, 0.0)))
    yield from measured(bench, name, value, u, "nT", limit_nT)


def of_length(errors_nT: Array) -> Array:
    """Root mean square (…) of the length of vectors, all components (…, 3 n) in one row."""
    return np.asarray(np.sqrt(3) * rms(errors_nT))
