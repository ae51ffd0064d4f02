"""The step in which a device tells its readings: what rounding adds to the noise of each."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.record import Run

Array = NDArray[np.float64]
ROUNDING = 12  # step² over the variance of what is rounded to steps: a uniform distribution (GUM 4.3.7)
NEAR = 20.0  # steps between two neighbouring values: farther apart a rounded step does not tell its multiple
OFF = 0.1  # of a step, that a difference may be off a multiple of it


def rounding_noise(run: Run) -> float:
    """Standard deviation of one axis of one reading by its rounding, root mean square of the axes [DUT units]."""
    steps = [_step(column[np.isfinite(column)], whole=run.dut.unit == "count") for column in run.reading.T]
    return float(np.sqrt(np.mean(np.square(steps)) / ROUNDING))


def _step(column: Array, *, whole: bool) -> float:
    """The step that all differences of the readings are multiples of; 0 where there is none.

    Counts may go by several: one in two of any whole numbers is even, one in 2^20 lots of twenty is.
    """
    apart = np.diff(np.unique(column))
    if whole and len(column) and bool((column == np.round(column)).all()):
        return float(np.gcd.reduce(apart.astype(np.int64))) if len(apart) >= NEAR else 1.0
    if not len(apart):
        return 0.0
    step = float(apart.min())
    multiples = apart[apart < NEAR * step] / step
    return step if float(np.abs(multiples - np.round(multiples)).max()) < OFF else 0.0
