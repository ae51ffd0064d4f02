"""What a segment offers an estimator, and the reference carried into the body. Decided here and nowhere else."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.geometry import rotate, shortest_rotation
from labcal.record.run import Run, Segment

Array = NDArray[np.float64]
Observation = Literal["vector", "axis", "scalar"]


def offers(run: Run, segment: Segment) -> Observation:
    """`vector`: reference in the body's frame, or axis with angle. `axis`: axis without angle. `scalar`: all else."""
    if run.reference.kind != "vector" or run.reference_vector is None:
        return "scalar"
    if segment.reference_frame == "body":
        return "vector"
    if segment.kind != "rotation":
        return "vector" if segment.kind == "static" and segment.body_from_cage is not None else "scalar"
    if segment.axis_body is None or segment.axis_cage is None:
        return "scalar"
    return "vector" if _has_angle(run, segment) else "axis"


def _has_angle(run: Run, segment: Segment) -> bool:
    if run.angle_deg is None:
        return False
    rows = run.segment_index == run.segments.index(segment)
    return bool(rows.any()) and bool(np.isfinite(run.angle_deg[rows]).any())


@dataclass(frozen=True, slots=True, eq=False)
class Carried:
    """The reference seen from the body, before the unknown starting phases are applied.

    Row i is `vector[i]` [nT, B] where `observation[i]` is "vector"; with `phase_group[i] >= 0` it still has to be
    turned: p = R(axis_body[i], -phase[group]) vector[i]. For "axis" rows only `axis_body[i] · b = along_axis[i]`
    and the magnitude are known, for "scalar" rows the magnitude alone.
    """

    observation: NDArray[np.str_]  # (n,)
    vector: Array  # (n, 3) NaN where not "vector"
    axis_body: Array  # (n, 3) NaN where there is no axis
    axis_cage: Array  # (n, 3) NaN where there is no axis
    along_axis: Array  # (n,) axis_cage · ref [nT], NaN where there is no axis
    magnitude: Array  # (n,) [nT]
    phase_group: NDArray[np.intp]  # (n,) -1 where nothing is unknown
    phase_names: tuple[str, ...]  # of each group: the mounting's or the segment's name

    def prediction(self, phase_rad: Array) -> Array:
        """P (n, 3) [nT, B] for the starting phases (groups,) [rad]."""
        p = self.vector.copy()
        turned = self.phase_group >= 0
        if turned.any():
            phase = phase_rad[self.phase_group[turned]]
            p[turned] = rotate(self.axis_body[turned], -phase, p[turned])
        return p


def carry(run: Run) -> Carried:
    """Carry the reference of every row into the body as far as the run's declarations reach."""
    n = len(run)
    vector, axis_body, axis_cage = (np.full((n, 3), np.nan) for _ in range(3))
    along, observation = np.full(n, np.nan), np.full(n, "scalar", dtype="<U6")
    group, names = np.full(n, -1, dtype=np.intp), list[str]()
    for index, segment in enumerate(run.segments):
        rows = run.rows(index)
        observation[rows] = kind = offers(run, segment)
        if kind == "scalar" or run.reference_vector is None:
            continue
        reference = run.reference_vector[rows]
        if segment.axis_body is not None and segment.axis_cage is not None:
            axis_body[rows], axis_cage[rows] = segment.axis_body, segment.axis_cage
            along[rows] = reference @ np.asarray(segment.axis_cage)
        if kind == "vector":
            vector[rows] = _into_body(run, segment, rows, reference)
            if segment.kind == "rotation" and segment.body_from_cage is None and segment.reference_frame == "cage":
                name = segment.mounting or segment.id
                if name not in names:
                    names.append(name)
                group[rows] = names.index(name)
    return Carried(observation, vector, axis_body, axis_cage, along, run.magnitude_nT, group, tuple(names))


def _into_body(run: Run, segment: Segment, rows: NDArray[np.intp], reference: Array) -> Array:
    """v_B = R(axis_body, -angle) · body_from_cage · v_C; without body_from_cage the shortest turn of the axes."""
    if segment.reference_frame == "body":
        return reference
    if segment.body_from_cage is not None:
        at_zero = np.asarray(segment.body_from_cage)
    else:
        at_zero = shortest_rotation(np.asarray(segment.axis_cage), np.asarray(segment.axis_body))
    fixed = reference @ at_zero.T
    if not stands_turned(run, segment):
        return np.asarray(fixed)
    assert run.angle_deg is not None
    return rotate(np.asarray(segment.axis_body), -np.radians(run.angle_deg[rows]), fixed)


def stands_turned(run: Run, segment: Segment) -> bool:
    """Whether the platform's angle turns what `body_from_cage` says, which holds at angle zero.

    At rest it does where the segment states its axis: the platform stands at an angle.
    """
    if segment.kind == "rotation":
        return run.angle_deg is not None
    return segment.kind == "static" and segment.axis_body is not None and _has_angle(run, segment)
