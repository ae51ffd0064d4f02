"""Base fits of many variants of a run at once, by linear algebra alone: residual rms and map of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.ml import estimate
from labcal.fit.vector.observations import AXIS, SCALAR, VECTOR, Observations, observe
from labcal.fit.vector.solve import ParameterisationName
from labcal.fit.vector.system import evaluate
from labcal.geometry import cross, rotate
from labcal.loop.noise.nuisance import gram_pinv
from labcal.model.affine import MAP_PARAMETERS
from labcal.record import Run

Array = NDArray[np.float64]
ALTERNATIONS = 5
SLACK = 1.1  # times the rms of magnitudes: at most so much their polynomial may leave


@dataclass(frozen=True, slots=True, eq=False)
class BatchFit:
    """Variants of a run with the same segments, and the base model's residual rms [nT]; infinite where none is fitted.

    Vectors are fitted by a whole affine map, all runs at once. Other rows are fitted by the form `allowed`, one run
    after the other and only when asked for: `lowest` says what is left at least, but for SLACK.
    """

    runs: Sequence[Run]
    parameterisation: ParameterisationName
    as_scalar: bool
    lower_bound: Array  # (tries,) nT
    found: dict[int, tuple[float, Array]]

    @classmethod
    def of(cls, runs: Sequence[Run], parameterisation: ParameterisationName, *, as_scalar: bool) -> BatchFit:
        """Of these runs, as far as linear algebra goes."""
        part = np.repeat(np.arange(len(runs)), [len(run) for run in runs])
        try:
            seen = observe(_stacked(runs), as_scalar=as_scalar)
        except ValueError:
            return cls(runs, parameterisation, as_scalar, np.full(len(runs), np.inf), {})
        rows = _Rows.of(seen, part[seen.rows], len(runs))
        if not bool((seen.kind == VECTOR).all()):
            return cls(runs, parameterisation, as_scalar, _lower_bounds(rows), {})
        left, K = _fit_vectors(rows)
        return cls(runs, parameterisation, as_scalar, left, dict(enumerate(zip(left.tolist(), K, strict=True))))

    def fitted(self, i: int, worth: float = np.inf) -> tuple[float, Array]:
        """Residual rms and K (3, 3) of a run; infinite where its lower bound exceeds `worth`."""
        if self.lower_bound[i] > SLACK * worth or np.isinf(self.lower_bound[i]):
            return np.inf, np.eye(3)
        if i not in self.found:
            self.found[i] = _fit_one(self.runs[i], self.parameterisation, self.as_scalar)
        return self.found[i]

    def least(self) -> float:
        """The least residual rms of any."""
        least = np.inf
        for i in np.argsort(self.lower_bound).tolist():
            least = min(least, self.fitted(i, least)[0])
        return least


def _stacked(tries: Sequence[Run]) -> Run:
    """The rows of all variants, one after the other."""
    names = ("t_s", "segment_index", "reading", "reference_vector", "reference_magnitude", "angle_deg")
    there = [name for name in names if getattr(tries[0], name) is not None]
    joined: dict[str, Any] = {name: np.concatenate([getattr(run, name) for run in tries]) for name in there}
    return replace(tries[0], row_mode=None, channels=(), **joined)


@dataclass(frozen=True, slots=True, eq=False)
class _Rows:
    """The rows of c variants side by side, n each; zeros where a variant has fewer."""

    X: Array  # (c, n, 4) readings, and −1
    target: Array  # (c, n, 3) nT
    axis: Array  # (c, n, 3)
    along: Array  # (c, n) nT
    magnitude: Array  # (c, n) nT
    turning: Array  # (c, n, phases) 1 where the row has that starting phase
    count: NDArray[np.intp]  # (c,) rows

    @classmethod
    def of(cls, seen: Observations, part: NDArray[np.intp], tries: int) -> _Rows:
        """For rows that belong to the variants `part`, in their order."""
        count = np.bincount(part, minlength=tries)
        place = np.arange(len(part)) - (np.cumsum(count) - count)[part]

        def laid(values: Array) -> Array:
            out = np.zeros((tries, int(count.max()), values.shape[1]))
            out[part, place] = values
            return out

        turning = (seen.group[:, None] == np.arange(len(seen.phase_names))).astype(float)
        X = np.column_stack([seen.reading, -np.ones(len(seen))])
        along = np.where(seen.kind == AXIS, seen.along, 0.0)
        vectors, numbers = (laid(X), laid(seen.target), laid(seen.axis)), laid(np.column_stack([along, seen.magnitude]))
        return cls(*vectors, numbers[:, :, 0], numbers[:, :, 1], laid(turning), count)

    def rms(self, square: Array) -> Array:
        """The root of the mean of sums of squares (c,) over the rows of each variant; infinite where there is none."""
        return np.where(self.count > 0, np.sqrt(square / np.maximum(self.count, 1)), np.inf)

    def turned(self, phase: Array) -> Array:
        """The targets from these starting phases (c, phases) [rad]."""
        return rotate(self.axis, -np.einsum("cng,cg->cn", self.turning, phase), self.target)


def _fit_vectors(rows: _Rows) -> tuple[Array, Array]:
    """Least squares of K m − k = p, unweighted.

    A starting phase turns p = v∥ + c v⊥ − s a × v with c = cos φ, s = sin φ: linear in c and s, which come first
    without c² + s² = 1 and then by turns with K and k.
    """
    phase, inverse = _linear_phases(rows), gram_pinv(rows.X)
    for _ in range(ALTERNATIONS if phase.shape[1] else 1):
        p = rows.turned(phase)
        theta = inverse @ (np.swapaxes(rows.X, 1, 2) @ p)
        field = rows.X @ theta
        phase = phase + _phase_steps(rows, field, p)
    square = np.sum((field - p) ** 2, axis=(1, 2))
    return rows.rms(square), np.swapaxes(theta[:, :3], 1, 2)


def _linear_phases(rows: _Rows) -> Array:
    """Phases (c, phases) [rad] from the equations in K, k, c and s."""
    tries, n, phases = rows.turning.shape
    if not phases:
        return np.zeros((tries, 0))
    along = np.sum(rows.target * rows.axis, axis=2, keepdims=True) * rows.axis
    across, side = rows.target - along, cross(rows.axis, rows.target)
    of_map = np.einsum("cnj,ab->cnajb", rows.X, np.eye(3)).reshape(tries, 3 * n, len(MAP_PARAMETERS))
    of_phase = np.stack([-across, side], axis=3)[:, :, :, None, :] * rows.turning[:, :, None, :, None]
    A = np.concatenate([of_map, of_phase.reshape(tries, 3 * n, 2 * phases)], axis=2)
    turned = rows.turning.sum(axis=2, keepdims=True) > 0
    fixed = np.where(turned, along, rows.target).reshape(tries, 3 * n, 1)
    found = (gram_pinv(A) @ (np.swapaxes(A, 1, 2) @ fixed))[:, len(MAP_PARAMETERS) :, 0].reshape(tries, phases, 2)
    return np.asarray(np.arctan2(found[:, :, 1], found[:, :, 0]))


def _phase_steps(rows: _Rows, field: Array, p: Array) -> Array:
    """How much farther each phase has to turn for its p to lie on the field (c, phases) [rad]."""
    across = p - np.sum(p * rows.axis, axis=2, keepdims=True) * rows.axis
    cosine, sine = np.sum(field * across, axis=2), -np.sum(field * cross(rows.axis, p), axis=2)
    sums = np.einsum("cng,kcn->kcg", rows.turning, np.stack([sine, cosine]))
    return np.asarray(np.arctan2(sums[0], sums[1]))


def _lower_bounds(rows: _Rows) -> Array:
    """Lower bounds of what any map leaves of axes and magnitudes (c,) [rms, nT]: two linear problems.

    axis · (K m − k) = along has no more than K and k; |K m − k|² = F² is a polynomial of the second degree in m, whose
    misfit over 2 F is that of |K m − k| as long as it is far less than F.
    """
    m, F = rows.X[:, :, :3], np.maximum(rows.magnitude, 1e-9)[:, :, None]
    on_axis = (rows.axis[:, :, :, None] * rows.X[:, :, None, :]).reshape(*F.shape[:2], len(MAP_PARAMETERS))
    products = np.stack([m[:, :, a] * m[:, :, b] for a in range(3) for b in range(a, 3)], axis=2)
    known = (rows.magnitude > 0)[:, :, None]
    bent = np.where(known, np.concatenate([products, rows.X], axis=2) / (2 * F), 0.0)
    return rows.rms(np.maximum(_residual_squares(on_axis, rows.along), _residual_squares(bent, rows.magnitude / 2)))


def _residual_squares(A: Array, y: Array) -> Array:
    """The sum of squares (c,) that the columns of A (c, n, k) leave of y (c, n)."""
    Q, _ = np.linalg.qr(A)
    left = y[:, :, None] - Q @ (np.swapaxes(Q, 1, 2) @ y[:, :, None])
    return np.asarray(np.sum(left**2, axis=(1, 2)))


def _fit_one(run: Run, parameterisation: ParameterisationName, as_scalar: bool) -> tuple[float, Array]:
    try:
        found = estimate(run, parameterisation=parameterisation, as_scalar=as_scalar, robust=False)
    except (ValueError, np.linalg.LinAlgError):
        return np.inf, np.eye(3)
    at = evaluate(found.observations, found.noise, found.solution.theta, found.solution.phase)
    if bool((found.observations.kind == SCALAR).all()):
        left = np.sum(at.residual * at.field, axis=1) / np.maximum(np.linalg.norm(at.field, axis=1), 1e-9)
    else:
        left = np.linalg.norm(at.residual, axis=1)
    return float(np.sqrt(np.mean(left**2))), found.affine.K
