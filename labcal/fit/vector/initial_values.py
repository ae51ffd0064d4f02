"""Starting values in closed form: maps from ellipsoids and linear least squares, phases from first harmonics."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import AXIS, VECTOR, Observations
from labcal.fit.vector.planes import aligned

Array = NDArray[np.float64]


def starts(seen: Observations, nominal: float, *, symmetric: bool) -> list[tuple[Array, Array]]:
    """Candidates (theta (12,) scaled, phase (unknowns,)), any of which may be the best; `nominal` as in `form`."""
    phases = seen.unknowns
    maps = [*_ellipsoids(seen, nominal), _sphere(seen, nominal)]
    if symmetric:
        return [(theta, np.zeros(phases)) for theta in maps]
    if seen.loci:
        return [(theta, _heights(seen, theta)) for theta in (aligned(seen.loci, one) for one in maps)]
    candidates = []
    if (seen.kind == VECTOR).any():
        candidates.append(_relaxed(seen))
    for theta in maps:
        for turned in (theta, _turned(seen, theta)):
            candidates.append((turned, _phases(seen, turned)))
    return candidates


def _relaxed(seen: Observations) -> tuple[Array, Array]:
    """K, k and the phases from one linear least squares, cos φ and sin φ of each group taken as free numbers.

    p = v∥ + cos φ v⊥ − sin φ a × v is linear in them; only the field along the axes fixes the common scale.
    """
    vector = seen.select(seen.kind == VECTOR)
    n, groups = len(vector), len(vector.phase_names)
    x = np.column_stack([vector.reading, np.full(n, -1.0)])
    A = np.zeros((n, 3, 12 + 2 * groups))
    for axis in range(3):
        A[:, axis, 3 * axis : 3 * axis + 3], A[:, axis, 9 + axis] = x[:, :3], x[:, 3]
    along, across, turned = _parts(vector)
    fixed = np.where((vector.group >= 0)[:, None], along, vector.target)
    for group in range(groups):
        rows = vector.group == group
        A[rows, :, 12 + 2 * group], A[rows, :, 13 + 2 * group] = -across[rows], turned[rows]
    scale = np.sqrt(np.sum(A**2, axis=(0, 1)))
    scale[scale == 0] = 1.0
    y = np.linalg.lstsq((A / scale).reshape(3 * n, -1), fixed.ravel(), rcond=1e-9)[0] / scale
    return y[:12], np.arctan2(y[13::2], y[12::2])


def _heights(seen: Observations, theta: Array) -> Array:
    """The mean of axis · b on each locus in the field of the map `theta`, inside the sphere [nT]."""
    along = np.sum((seen.reading @ theta[:9].reshape(3, 3).T - theta[9:]) * seen.axis, axis=1)
    found = np.zeros(seen.unknowns)
    for locus in range(len(seen.phase_names), seen.unknowns):
        rows = seen.group == locus
        reach = 0.9 * float(seen.magnitude[rows].min())
        found[locus] = np.clip(np.mean(along[rows]), -reach, reach)
    return found


def _phases(seen: Observations, theta: Array) -> Array:
    """The phase of each group that lays its prediction best along the field of the map `theta`."""
    field = seen.reading @ theta[:9].reshape(3, 3).T - theta[9:]
    _, across, turned = _parts(seen)
    cosine, sine = np.sum(field * across, axis=1), -np.sum(field * turned, axis=1)
    groups = range(len(seen.phase_names))
    return np.array([np.arctan2(sine[seen.group == g].sum(), cosine[seen.group == g].sum()) for g in groups])


def _parts(seen: Observations) -> tuple[Array, Array, Array]:
    """The target along its axis, across it, and axis × target (each (n, 3))."""
    along = np.sum(seen.axis * seen.target, axis=1, keepdims=True) * seen.axis
    return along, seen.target - along, np.cross(seen.axis, seen.target)


def _turned(seen: Observations, theta: Array) -> Array:
    """`theta` turned as a whole so that axis · R b = along fits best: a linear R, then the nearest rotation."""
    rows = seen.kind == AXIS
    vector = (seen.kind == VECTOR) & (seen.group >= 0)
    use = rows | vector
    if not use.any():
        return theta
    K, k = theta[:9].reshape(3, 3), theta[9:]
    field = seen.reading[use] @ K.T - k
    along = np.where(rows[use], seen.along[use], np.sum(seen.axis[use] * seen.target[use], axis=1))
    A = (seen.axis[use][:, :, None] * field[:, None, :]).reshape(-1, 9)
    linear, _, rank, _ = np.linalg.lstsq(A, along, rcond=1e-6)
    if rank < 9:
        return theta
    U, _, Vt = np.linalg.svd(linear.reshape(3, 3))
    R = U @ np.diag([1.0, 1.0, np.sign(np.linalg.det(U @ Vt))]) @ Vt
    return np.concatenate([(R @ K).ravel(), R @ k])


def _sphere(seen: Observations, nominal: float) -> Array:
    """Gain as nominal; k from |g m|² − 2 g k·m + c = F², linear in k and c."""
    m = nominal * seen.reading
    A = np.column_stack([2 * m, np.ones(len(m))])
    k = np.linalg.lstsq(A, np.sum(m**2, axis=1) - seen.magnitude**2, rcond=1e-6)[0][:3]
    return np.concatenate([nominal * np.eye(3).ravel(), k])


def _ellipsoids(seen: Observations, nominal: float) -> list[Array]:
    """Maps from mᵀQm − 2qᵀm + c = e F², linear under tr Q = 3: with e free where |ref| varies, else from the size.

    The trace keeps Q from vanishing, which fits a constant |b| exactly (Riwanto et al. (8); Foster & Elkaim's ten
    coefficients with another normalisation).
    """
    m, F2 = nominal * seen.reading, seen.magnitude**2
    length = max(float(np.sqrt(np.mean(F2))), 1e-300)
    m, F2 = m / length, F2 / length**2
    square = np.sum(m**2, axis=1)
    quadratic = [m[:, 0] ** 2 - m[:, 2] ** 2, m[:, 1] ** 2 - m[:, 2] ** 2]
    quadratic += [2 * m[:, a] * m[:, b] for a, b in ((0, 1), (0, 2), (1, 2))]
    A = np.column_stack([*quadratic, *(-2 * m.T), np.ones(len(m)), -F2])
    found = []
    for columns in (slice(0, 10), slice(0, 9)):
        y = np.linalg.lstsq(A[:, columns], -square, rcond=1e-9)[0]
        found += _map_from(y, nominal, length)
    return found


def _map_from(y: Array, nominal: float, length: float) -> list[Array]:
    """K = √(Q/e), k = K m₀ for the coefficients of one ellipsoid; none where Q is not positive."""
    d1, d2, xy, xz, yz = y[:5]
    Q = np.eye(3) + np.array([[d1, xy, xz], [xy, d2, yz], [xz, yz, -d1 - d2]])
    values, vectors = np.linalg.eigh(Q)
    if values[0] <= 1e-3:
        return []
    centre = np.linalg.solve(Q, y[5:8])
    e = y[9] if len(y) == 10 else centre @ Q @ centre - y[8]
    if e <= 0:
        return []
    K = vectors @ np.diag(np.sqrt(values / e)) @ vectors.T
    return [np.concatenate([nominal * K.ravel(), length * (K @ centre)])]
