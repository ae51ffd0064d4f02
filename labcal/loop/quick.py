"""A base fit by linear algebra alone, for trying a run many times over: what is left, and the map."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.fit.ml import estimate
from labcal.fit.observations import SCALAR, VECTOR, Observations, observe
from labcal.fit.solve import FormName
from labcal.fit.system import evaluate
from labcal.geometry import cross, rotate
from labcal.record import Run

Array = NDArray[np.float64]
ALTERNATIONS = 5


def misfits(tries: Sequence[Run], allowed: FormName, *, as_scalar: bool) -> tuple[Array, Array]:
    """What the base model leaves of runs with the same segments (tries,) [rms, nT], and its K (tries, 3, 3).

    Vectors are fitted by a whole affine map, all tries at once; other rows by the form `allowed`, one after the other.
    Infinite where a try cannot be fitted.
    """
    part = np.repeat(np.arange(len(tries)), [len(run) for run in tries])
    try:
        seen = observe(_joined(tries), as_scalar=as_scalar)
    except ValueError:
        return np.full(len(tries), np.inf), np.tile(np.eye(3), (len(tries), 1, 1))
    if bool((seen.kind == VECTOR).all()):
        return _of_vectors(_Rows.of(seen, part[seen.rows], len(tries)))
    left, K = zip(*(_of_others(run, allowed, as_scalar) for run in tries), strict=True)
    return np.array(left), np.array(K)


def _joined(tries: Sequence[Run]) -> Run:
    """The rows of all tries, one after the other."""
    names = ("t_s", "segment_index", "reading", "reference_vector", "reference_magnitude", "angle_deg")
    there = [name for name in names if getattr(tries[0], name) is not None]
    joined: dict[str, Any] = {name: np.concatenate([getattr(run, name) for run in tries]) for name in there}
    return replace(tries[0], row_mode=None, channels=(), **joined)


@dataclass(frozen=True, slots=True, eq=False)
class _Rows:
    """Vectors of c tries side by side, n rows each; zeros where a try has fewer."""

    X: Array  # (c, n, 4) readings, and −1
    target: Array  # (c, n, 3) nT
    axis: Array  # (c, n, 3)
    turning: Array  # (c, n, phases) 1 where the row has that starting phase
    count: Array  # (c,) rows

    @classmethod
    def of(cls, seen: Observations, part: NDArray[np.intp], tries: int) -> _Rows:
        """For rows that belong to the tries `part`, in their order."""
        count = np.bincount(part, minlength=tries)
        place = np.arange(len(part)) - (np.cumsum(count) - count)[part]

        def laid(values: Array) -> Array:
            out = np.zeros((tries, int(count.max()), values.shape[1]))
            out[part, place] = values
            return out

        turning = (seen.group[:, None] == np.arange(len(seen.phase_names))).astype(float)
        X = np.column_stack([seen.reading, -np.ones(len(seen))])
        return cls(laid(X), laid(seen.target), laid(seen.axis), laid(turning), count.astype(float))

    def turned(self, phase: Array) -> Array:
        """The targets from these starting phases (c, phases) [rad]."""
        return rotate(self.axis, -np.einsum("cng,cg->cn", self.turning, phase), self.target)


def _of_vectors(rows: _Rows) -> tuple[Array, Array]:
    """Least squares of K m − k = p, unweighted.

    A starting phase turns p = v∥ + c v⊥ − s a × v with c = cos φ, s = sin φ: linear in c and s, which come first
    without c² + s² = 1 and then by turns with K and k.
    """
    phase, inverse = _free_phases(rows), _inverse(rows.X)
    for _ in range(ALTERNATIONS if phase.shape[1] else 1):
        p = rows.turned(phase)
        theta = inverse @ (np.swapaxes(rows.X, 1, 2) @ p)
        field = rows.X @ theta
        phase = phase + _turns(rows, field, p)
    square = np.sum((field - p) ** 2, axis=(1, 2))
    left = np.where(rows.count > 0, np.sqrt(square / np.maximum(rows.count, 1.0)), np.inf)
    return left, np.swapaxes(theta[:, :3], 1, 2)


def _inverse(A: Array) -> Array:
    """(AᵀA)⁻¹ of A (c, m, k), columns taken at unit length; directions that A does not have are nought."""
    scale = np.linalg.norm(A, axis=1)
    scale = np.where(scale > 0, scale, 1.0)
    both = scale[:, :, None] * scale[:, None, :]
    return np.asarray(np.linalg.pinv(np.swapaxes(A, 1, 2) @ A / both, rcond=1e-10, hermitian=True) / both)


def _free_phases(rows: _Rows) -> Array:
    """Phases (c, phases) [rad] from the equations in K, k, c and s."""
    tries, n, phases = rows.turning.shape
    if not phases:
        return np.zeros((tries, 0))
    along = np.sum(rows.target * rows.axis, axis=2, keepdims=True) * rows.axis
    across, side = rows.target - along, cross(rows.axis, rows.target)
    of_map = np.einsum("cnj,ab->cnajb", rows.X, np.eye(3)).reshape(tries, 3 * n, 12)
    of_phase = np.stack([-across, side], axis=3)[:, :, :, None, :] * rows.turning[:, :, None, :, None]
    A = np.concatenate([of_map, of_phase.reshape(tries, 3 * n, 2 * phases)], axis=2)
    turned = rows.turning.sum(axis=2, keepdims=True) > 0
    fixed = np.where(turned, along, rows.target).reshape(tries, 3 * n, 1)
    found = (_inverse(A) @ (np.swapaxes(A, 1, 2) @ fixed))[:, 12:, 0].reshape(tries, phases, 2)
    return np.asarray(np.arctan2(found[:, :, 1], found[:, :, 0]))


def _turns(rows: _Rows, field: Array, p: Array) -> Array:
    """How much farther each phase has to turn for its p to lie on the field (c, phases) [rad]."""
    across = p - np.sum(p * rows.axis, axis=2, keepdims=True) * rows.axis
    cosine, sine = np.sum(field * across, axis=2), -np.sum(field * cross(rows.axis, p), axis=2)
    sums = np.einsum("cng,kcn->kcg", rows.turning, np.stack([sine, cosine]))
    return np.asarray(np.arctan2(sums[0], sums[1]))


def _of_others(run: Run, allowed: FormName, as_scalar: bool) -> tuple[float, Array]:
    try:
        found = estimate(run, allowed=allowed, as_scalar=as_scalar, robust=False)
    except (ValueError, np.linalg.LinAlgError):
        return np.inf, np.eye(3)
    at = evaluate(found.seen, found.noise, found.solution.theta, found.solution.phase)
    if bool((found.seen.kind == SCALAR).all()):
        left = np.sum(at.residual * at.field, axis=1) / np.maximum(np.linalg.norm(at.field, axis=1), 1e-9)
    else:
        left = np.linalg.norm(at.residual, axis=1)
    return float(np.sqrt(np.mean(left**2))), found.affine.K
