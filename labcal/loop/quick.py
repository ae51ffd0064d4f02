"""A base fit by linear algebra alone, for trying a run many times over: what is left, and the map."""

from __future__ import annotations

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


def misfit(run: Run, allowed: FormName, *, as_scalar: bool) -> tuple[float, Array]:
    """What the base model leaves of `run` (rms, nT) and its K (3, 3); infinite where it cannot be fitted.

    Vectors are fitted by a whole affine map, other rows by the form `allowed`.
    """
    try:
        seen = observe(run, as_scalar=as_scalar)
        if bool((seen.kind == VECTOR).all()):
            return of_vectors(seen)
        return _of_others(run, allowed, as_scalar)
    except (ValueError, np.linalg.LinAlgError):
        return np.inf, np.eye(3)


def of_vectors(seen: Observations) -> tuple[float, Array]:
    """Least squares of K m − k = p, unweighted.

    A starting phase turns p = v∥ + c v⊥ − s a × v with c = cos φ, s = sin φ: linear in c and s, which come first
    without c² + s² = 1 and then by turns with K and k.
    """
    X = np.column_stack([seen.reading, -np.ones(len(seen))])
    phase = _free_phases(seen, X)
    for _ in range(ALTERNATIONS if len(phase) else 1):
        p = _turned(seen, phase)
        theta = _solved(X, p)
        phase = phase + _turns(seen, X @ theta, p)
    left = X @ theta - p
    return float(np.sqrt(np.mean(np.sum(left**2, axis=1)))), np.asarray(theta[:3].T)


def _solved(A: Array, y: Array) -> Array:
    """The shortest least-squares solution by normal equations with columns of unit length: faster than by SVD."""
    scale = np.linalg.norm(A, axis=0)
    scale = np.where(scale > 0, scale, 1.0)
    gram = np.linalg.pinv((A / scale).T @ (A / scale), rcond=1e-10, hermitian=True)
    found = gram @ ((A / scale).T @ y)
    return np.asarray((found.T / scale).T)


def _turned(seen: Observations, phase: Array) -> Array:
    if not len(phase):
        return seen.target
    start = np.where(seen.group >= 0, phase[np.maximum(seen.group, 0)], 0.0)
    out = seen.target.copy()
    turned = seen.group >= 0
    out[turned] = rotate(seen.axis[turned], -start[turned], seen.target[turned])
    return out


def _free_phases(seen: Observations, X: Array) -> Array:
    """Phases (groups,) [rad] from the equations in K, k, c and s."""
    groups = len(seen.phase_names)
    if not groups:
        return np.zeros(0)
    along = np.sum(seen.target * seen.axis, axis=1)[:, None] * seen.axis
    across, side = seen.target - along, cross(seen.axis, seen.target)
    A = [np.kron(X, np.eye(3))]
    for g in range(groups):
        mine = (seen.group == g)[:, None]
        A += [-(across * mine).reshape(-1, 1), (side * mine).reshape(-1, 1)]
    fixed = np.where((seen.group >= 0)[:, None], along, seen.target)
    found = _solved(np.hstack(A), fixed.ravel())[12:].reshape(groups, 2)
    return np.arctan2(found[:, 1], found[:, 0])


def _turns(seen: Observations, field: Array, p: Array) -> Array:
    """How much farther each group has to turn for its p to lie on the field (groups,) [rad]."""
    cosine = np.sum(field * (p - np.sum(p * seen.axis, axis=1)[:, None] * seen.axis), axis=1)
    sine = -np.sum(field * cross(seen.axis, p), axis=1)
    groups = range(len(seen.phase_names))
    sums = np.array([[part[seen.group == g].sum() for g in groups] for part in (sine, cosine)]).reshape(2, -1)
    return np.asarray(np.arctan2(sums[0], sums[1]))


def _of_others(run: Run, allowed: FormName, as_scalar: bool) -> tuple[float, Array]:
    found = estimate(run, allowed=allowed, as_scalar=as_scalar, robust=False)
    at = evaluate(found.seen, found.noise, found.solution.theta, found.solution.phase)
    if bool((found.seen.kind == SCALAR).all()):
        left = np.sum(at.residual * at.field, axis=1) / np.maximum(np.linalg.norm(at.field, axis=1), 1e-9)
    else:
        left = np.linalg.norm(at.residual, axis=1)
    return float(np.sqrt(np.mean(left**2))), found.affine.K
