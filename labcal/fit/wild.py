"""Readings that no field made: a converter that overflowed, a frame that was cut, a number nobody filled in."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.record import Run

WILD = 20.0  # times the largest reference and the median reading together; below it robust weights do the work
MOST = 0.1  # of the rows: more of them are no accident, and have to show


def wild_rows(run: Run) -> NDArray[np.bool_]:
    """Rows (n,) whose reading is twenty times what field and offset can make of it; none where they are many.

    One such row (2 147 483 647 among thousands) is all that the sums of a least squares would hold.
    """
    known = np.isfinite(run.reading).all(axis=1)
    if run.reference.kind == "none" or not known.any():
        return np.zeros(len(run), dtype=np.bool_)
    length = np.linalg.norm(run.reading_nT, axis=1)
    field = run.magnitude_nT[np.isfinite(run.magnitude_nT)]
    found = known & (length > WILD * (field.max(initial=0.0) + np.median(length[known])))
    return found if found.sum() <= MOST * known.sum() else np.zeros(len(run), dtype=np.bool_)


def without_wild(run: Run) -> Run:
    """The run with those readings missing."""
    wild = wild_rows(run)
    return replace(run, reading=np.where(wild[:, None], np.nan, run.reading)) if wild.any() else run
