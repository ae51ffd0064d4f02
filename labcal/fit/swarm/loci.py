"""What a run gives the rotation-axis methods: readings, magnitudes, and the loci whose rotation axis is known."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.planes import FEWEST_SAMPLES, is_turn
from labcal.fit.vector.planes import forward as sense_of_turn
from labcal.record import Run, Segment

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Loci:
    """Rows with a reading and a magnitude; `locus[i]` is -1 for a row whose rotation axis is not known."""

    reading: Array  # (n, 3) readings times nominal_nT_per_unit [nT]
    magnitude: Array  # (n,) [nT]
    locus: NDArray[np.intp]  # (n,) into `axes`
    axes: Array  # (l, 3) rotation axes in B
    along: Array  # (n,) axis · b [nT] where the reference is a vector, else NaN
    forward: Array  # (n,) sense of turning from this row to the next of its locus: 1 right-handed about the axis, or -1

    def __len__(self) -> int:
        return len(self.magnitude)

    @property
    def axis(self) -> Array:
        """The axis (n, 3) of each row, zero where none is known."""
        return np.vstack([self.axes, np.zeros(3)])[self.locus]

    def rows(self, locus: int) -> NDArray[np.intp]:
        """Row numbers of one locus, in the order they were taken."""
        return np.flatnonzero(self.locus == locus)


def loci_of(run: Run, *, with_axes: bool = True) -> Loci:
    """Return the usable rows of `run`; each rotation segment that states its `axis_body` is a locus.

    Without angles a segment is taken to turn right-handed about its axis, all the way. Raises ValueError where no row
    has a reading and a magnitude.
    """
    magnitude = run.magnitude_nT
    rows = np.flatnonzero(np.isfinite(run.reading).all(axis=1) & np.isfinite(magnitude) & (magnitude > 0))
    if not len(rows):
        raise ValueError("no row has both a reading and a reference")
    locus, along = np.full(len(rows), -1, dtype=np.intp), np.full(len(rows), np.nan)
    axes, forward = list[Array](), np.ones(len(rows))
    for index, segment in enumerate(run.segments if with_axes else ()):
        of_segment = np.flatnonzero(run.segment_index[rows] == index)
        if not is_turn(segment) or len(of_segment) < FEWEST_SAMPLES:
            continue
        locus[of_segment] = len(axes)
        axes.append(np.asarray(segment.axis_body, dtype=float))
        along[of_segment] = _along(run, segment, rows[of_segment])
        forward[of_segment] = sense_of_turn(run, rows[of_segment])
    return Loci(run.reading_nT[rows], magnitude[rows], locus, np.reshape(axes, (-1, 3)), along, forward)


def _along(run: Run, segment: Segment, rows: NDArray[np.intp]) -> Array:
    """axis_cage · ref (rows,), which the turn does not change; NaN where the reference is no vector of C."""
    if run.reference_vector is None or segment.axis_cage is None or segment.reference_frame == "body":
        return np.full(len(rows), np.nan)
    return np.asarray(run.reference_vector[rows] @ np.asarray(segment.axis_cage))


def reading_noise_nT(run: Run, loci: Loci) -> float:
    """Standard deviation of one axis of one reading [nT]: declared, else from the second differences of readings.

    Second differences hold a smooth motion back, and their median holds jumps back; where the motion is fast the
    figure is too large, which does no harm to a weight.
    """
    if run.dut.noise_nT:
        return run.dut.noise_nT
    if len(loci) < 3:
        return 1.0
    second = np.diff(loci.reading, n=2, axis=0)
    return max(float(np.median(np.abs(second)) / 0.6745 / np.sqrt(6)), 1e-9)
