"""Loci of a known rotation axis in a field whose magnitude alone is known: planes across the axis, at unknown heights.

Riwanto et al. 2017, section III-D: while the body turns about ω in a constant field, ω · b does not change. The axis is
the plane's normal; which way along it the normal points is said by the sense in which the readings go round. Without
angles a segment is taken to turn right-handed about its axis.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.special import fdtri

from labcal.fit.vector.observations import AXIS, SCALAR, Locus, Observations, observe
from labcal.fit.vector.solve import Solution
from labcal.fit.vector.system import Evaluated, Noise, blocks, evaluate
from labcal.geometry import cross, unit
from labcal.record import Run, Segment

Array = NDArray[np.float64]
FEWEST_SAMPLES = 8  # of a locus
CLEAR = 4.0  # standard uncertainties by which a locus goes round one way
HALF_TURNED = 1.0  # of the trace of K in nominal units, 3 for a sensor that lies as stated, −1 for one turned by half
CHANCE, LARGER = 1e-6, 1.5  # heights squared over radii squared: beyond this, and beyond chance, there is no plane


def is_turn(segment: Segment) -> bool:
    """Whether the segment is a rotation that states its axis in the body."""
    return segment.kind == "rotation" and segment.axis_body is not None


def forward(run: Run, rows: NDArray[np.intp]) -> Array:
    """Sign of the next change of angle (rows,); zero where an angle is missing, 1 where there are none at all."""
    if run.angle_deg is None or not np.isfinite(run.angle_deg[rows]).any():
        return np.ones(len(rows))
    change = np.diff(run.angle_deg[rows], append=np.nan)
    return np.nan_to_num(np.sign((change + 180) % 360 - 180))


def observe_planes(run: Run) -> Observations:
    """The usable rows of `run`; with a scalar reference, turns about known axes are axis rows of unknown height.

    Raises ValueError as `observe` does.
    """
    seen = observe(run)
    if run.reference.kind != "scalar":
        return seen
    kind, group, axis, loci = seen.kind.copy(), seen.group.copy(), seen.axis.copy(), list[Locus]()
    for index, segment in enumerate(run.segments):
        own = np.flatnonzero(seen.segment == index)
        if segment.axis_body is not None and is_turn(segment) and len(own) >= FEWEST_SAMPLES:
            kind[own], group[own], axis[own] = AXIS, len(loci), unit(segment.axis_body)
            loci.append(_locus(axis[own[0]], seen.reading[own], forward(run, seen.rows[own])[:-1]))
    return replace(seen, kind=kind, group=group, axis=axis, loci=tuple(loci))


def observe_like(run: Run, seen: Observations) -> Observations:
    """`run` in the way in which `seen` was observed: its magnitudes alone, with planes, or all it offers."""
    return observe_planes(run) if seen.loci else observe(run, as_scalar=bool((seen.kind == SCALAR).all()))


def _locus(axis: Array, reading: Array, way: Array) -> Locus:
    return Locus(axis, way @ cross(reading[:-1], reading[1:]), way @ np.diff(reading, axis=0))


def aligned(loci: tuple[Locus, ...], theta: Array) -> Array:
    """The map `theta` (12,) turned as a whole so that all loci go round their axes as well as they can.

    Wahba's problem, by singular values (Markley 1988). K must be no reflection.
    """
    K, k = theta[:9].reshape(3, 3), theta[9:]
    round_axes = np.array([one.round_zero(K, k) for one in loci])
    size = np.maximum(np.linalg.norm(round_axes, axis=1, keepdims=True), 1e-300)
    U, _, Vt = np.linalg.svd(np.array([one.axis for one in loci]).T @ (-round_axes / size))
    R = U @ np.diag([1.0, 1.0, np.linalg.det(U @ Vt)]) @ Vt
    return np.concatenate([(R @ K).ravel(), R @ k])


def sense(field: Array, axis: Array, way: Array, noise: Array) -> tuple[float, float]:
    """How clearly a locus goes round its axis as stated: −axis · Σ way b_s × b_{s+1} [nT²], and its uncertainty.

    `field` (n, 3) [nT] in the order of the rows, `way` (n,) of `forward`, `noise` (3, 3) the covariance of a row [nT²].
    Of the product's errors those of one row stand at its neighbours, across the axis; those of two rows multiply.
    """
    between, neighbours = way[:-1, None], np.zeros_like(field)
    neighbours[:-1] += between * field[1:]
    neighbours[1:] -= between * field[:-1]
    arm = cross(neighbours, axis)
    of_pairs = 2 * len(field) * float(np.linalg.det(noise) * (axis @ np.linalg.inv(noise) @ axis))
    of_rows = float(np.einsum("na,ab,nb->", arm, noise, arm))  # the neighbours' own noise is twice the pairs' in it
    value = float(-axis @ np.sum(between * cross(field[:-1], field[1:]), axis=0))
    return value, float(np.sqrt(max(of_rows - of_pairs, of_rows / 2)))


def in_planes(run: Run, seen: Observations, noise: Noise, found: Solution) -> bool:
    """Whether the loci of this fit go round as the run states, clearly, and lie in planes as far as noise lets one see.

    Magnitudes and heights of any size allow some of b's mirror images as well; the sense in which the loci go round
    and the sign of det K leave one. A field that changes its direction, or a wrong axis, shows in the heights. A sense
    that is not recorded, but taken to be right-handed, leaves none where half a turn is nearer to the nominal frame.
    """
    K = found.theta[:9].reshape(3, 3)
    field, covariance = seen.reading @ K.T - found.theta[9:], K @ noise.covariance(seen.scale) @ K.T
    if np.linalg.det(K) <= 0 or (_without_angles(run) and is_half_turned(K)):
        return False
    for index, locus in enumerate(seen.loci):
        own = np.flatnonzero((seen.kind == AXIS) & (seen.group == index))
        value, u = sense(field[own], locus.axis, forward(run, seen.rows[own]), covariance)
        if value < CLEAR * u:
            return False
    return _heights_are_noise(seen, noise, found)


def _without_angles(run: Run) -> bool:
    """Whether a turn's sense is taken to be right-handed."""
    turns = [run.rows(index) for index, segment in enumerate(run.segments) if is_turn(segment)]
    return run.angle_deg is None or not all(np.isfinite(run.angle_deg[rows]).any() for rows in turns)


def is_half_turned(K: Array) -> bool:
    """Whether half a turn about an axis of the body brings K (3, 3) clearly nearer to the sensor's nominal frame.

    Turned about two axes the other way than supposed, a run gives just that: a mirror image that is none of K's own.
    """
    d = np.diag(K) / np.cbrt(abs(np.linalg.det(K)))
    return bool(max(float(d[axis] - d.sum() + d[axis]) for axis in range(3)) > d.sum() + HALF_TURNED)


def _heights_are_noise(seen: Observations, noise: Noise, found: Solution) -> bool:
    """F test of the misfit along the axes against that across them, unless it is no larger than the noise stated."""
    squares, rows = np.zeros(2), 0.0
    for where, part, part_noise in blocks(seen, noise):
        on, at = part.kind == AXIS, evaluate(part, part_noise, found.theta, found.phase)
        squares += found.weight[where][on] @ _seen_apart(part.axis[on], at, on)
        rows += float(found.weight[where][on].sum())
    free = max(rows - len(seen.loci), 1.0), max(rows - 12, 1.0)
    along, across = squares[0] / free[0], squares[1] / free[1]
    return bool(along <= max(1.0, across * max(LARGER, float(fdtri(free[0], free[1], 1 - CHANCE)))))


def _seen_apart(axis: Array, at: Evaluated, on: NDArray[np.bool_]) -> Array:
    """The misfits (n, 2) of height and of radius, squared over the variances that each has by itself."""
    across = at.field[on] - np.sum(at.field[on] * axis, axis=1, keepdims=True) * axis
    both = np.stack([axis, unit(across)], axis=1)
    covariance = np.linalg.inv(both @ at.information[on] @ both.swapaxes(1, 2))
    seen = np.sum(both * at.residual[on][:, None], axis=2)
    return np.asarray(seen**2 / np.diagonal(covariance, axis1=1, axis2=2))
