"""The rows of a run that a fit can use, in one form for every kind of observation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.record import Run, carry

Array = NDArray[np.float64]
VECTOR, AXIS, SCALAR = 3, 2, 1  # kinds, named by how many numbers one row gives


@dataclass(frozen=True, slots=True, eq=False)
class Locus:
    """A turn about a known axis (3,) of B in a field whose direction nothing tells, and the sense of its readings.

    `turn` (3,) = ± Σ m_s × m_{s+1} and `chord` (3,) = ± Σ (m_{s+1} − m_s), minus where the body turned left-handed.
    """

    axis: Array
    turn: Array
    chord: Array

    def round_zero(self, K: Array, k: Array) -> Array:
        """± Σ b_s × b_{s+1} (3,) for b = K m − k: against the axis, as far as the plane is not above zero field."""
        zero = np.linalg.solve(K, k)
        return np.asarray(np.linalg.det(K) * np.linalg.solve(K.T, self.turn - np.cross(zero, self.chord)))


@dataclass(frozen=True, slots=True, eq=False)
class Observations:
    """What is known of b row by row; rows with a missing reading or reference are left out.

    Beside the map, a row may depend on one `unknown`: a vector row on its starting phase, an axis row whose height
    along the axis no reference tells on that of its locus. `phase` in this room is all of them, phases before heights.
    `target` is the reference in B before the starting phases, zero where it is not a vector; `velocity` its rate of
    change. Readings are divided by `scale` (their root mean square length), so that K · scale and k are both in nT.
    """

    rows: NDArray[np.intp]  # (n,) of the run
    kind: NDArray[np.int8]  # (n,) VECTOR, AXIS or SCALAR
    reading: Array  # (n, 3) in units of `scale`
    target: Array  # (n, 3) nT
    axis: Array  # (n, 3) unit vectors of B, zero where there is none
    along: Array  # (n,) axis_cage · ref, nT
    magnitude: Array  # (n,) nT
    group: NDArray[np.intp]  # (n,) the row's unknown, -1 where there is none
    phase_names: tuple[str, ...]
    velocity: Array  # (n, 3) nT/s
    segment: NDArray[np.intp]  # (n,)
    scale: float  # DUT units
    loci: tuple[Locus, ...] = ()  # of unknown height

    def __len__(self) -> int:
        return len(self.rows)

    @property
    def unknowns(self) -> int:
        """How many starting phases and heights are unknown."""
        return len(self.phase_names) + len(self.loci)

    def select(self, rows: NDArray[np.intp] | NDArray[np.bool_] | slice) -> Observations:
        """Return only these rows, every unknown kept."""
        return Observations(
            self.rows[rows],
            self.kind[rows],
            self.reading[rows],
            self.target[rows],
            self.axis[rows],
            self.along[rows],
            self.magnitude[rows],
            self.group[rows],
            self.phase_names,
            self.velocity[rows],
            self.segment[rows],
            self.scale,
            self.loci,
        )


def observe(run: Run, *, as_scalar: bool = False) -> Observations:
    """The usable rows of `run`; with `as_scalar` their magnitude alone. Raises ValueError where there is none."""
    carried = carry(run)
    kind = np.full(len(run), SCALAR, dtype=np.int8)
    if not as_scalar:
        kind[carried.observation == "vector"] = VECTOR
        kind[carried.observation == "axis"] = AXIS
    known = np.where(
        kind == VECTOR,
        np.isfinite(carried.vector).all(axis=1),
        np.isfinite(carried.magnitude) & ((kind != AXIS) | np.isfinite(carried.along_axis)),
    )
    rows = np.flatnonzero(known & np.isfinite(run.reading).all(axis=1))
    if not len(rows):
        raise ValueError("no row has both a reading and a reference")
    reading, chosen = run.reading[rows], kind[rows]
    scale = float(np.sqrt(np.mean(np.sum(reading**2, axis=1)))) or 1.0
    turned = (carried.phase_group[rows] >= 0) & (chosen == VECTOR)
    target = np.where(chosen[:, None] == VECTOR, np.nan_to_num(carried.vector[rows]), 0.0)
    segment = run.segment_index[rows]
    return Observations(
        rows,
        chosen,
        reading / scale,
        target,
        np.nan_to_num(carried.axis_body[rows]) if not as_scalar else np.zeros((len(rows), 3)),
        np.nan_to_num(carried.along_axis[rows]),
        np.nan_to_num(carried.magnitude[rows]),
        np.where(turned, carried.phase_group[rows], -1),
        carried.phase_names if not as_scalar else (),
        _velocity(run.t_s[rows], segment, target),
        segment,
        scale,
    )


def _velocity(t_s: Array, segment: NDArray[np.intp], target: Array) -> Array:
    """d(target)/dt [nT/s] by central differences inside each segment; zero where a segment has one row."""
    out = np.zeros_like(target)
    for start, stop in _stretches(segment):
        if stop - start > 1:
            out[start:stop] = np.gradient(target[start:stop], t_s[start:stop], axis=0)
    return out


def _stretches(segment: NDArray[np.intp]) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(segment)) + 1
    return list(zip([0, *edges.tolist()], [*edges.tolist(), len(segment)], strict=True))
