"""Rotations, unit axes and plane normals. Pure numpy; angles in radians, vectors in the last axis."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def unit(v: ArrayLike) -> Array:
    """`v` (..., 3) at length one. Raises ValueError for a vector of no length."""
    v = np.asarray(v, dtype=float)
    length = np.linalg.norm(v, axis=-1, keepdims=True)
    if not np.all(length > 0):
        raise ValueError("a vector of zero length has no direction")
    return np.asarray(v / length)


def cross(a: ArrayLike, b: ArrayLike) -> Array:
    """A × b along the last axis (..., 3): for few rows several times faster than numpy's."""
    (x, y, z), (u, v, w) = (np.moveaxis(np.asarray(part, dtype=float), -1, 0) for part in (a, b))
    return np.stack([y * w - z * v, z * u - x * w, x * v - y * u], axis=-1)


def skew(v: ArrayLike) -> Array:
    """[v]× (..., 3, 3), so that skew(v) @ w = v × w."""
    v = np.asarray(v, dtype=float)
    out = np.zeros((*v.shape[:-1], 3, 3))
    out[..., 0, 1], out[..., 0, 2], out[..., 1, 2] = -v[..., 2], v[..., 1], -v[..., 0]
    return np.asarray(out - np.swapaxes(out, -1, -2))


def rotation(axis: ArrayLike, angle: ArrayLike) -> Array:
    """R(u, θ): the active right-handed rotation by `angle` [rad] (...) about the unit vector `axis` (3,) or (..., 3).

    Shape (..., 3, 3). Rodrigues: R = I + sin θ [u]× + (1 − cos θ) [u]×².
    """
    K = skew(axis)
    angle = np.asarray(angle, dtype=float)[..., None, None]
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * (K @ K))


def rotate(axis: ArrayLike, angle: ArrayLike, v: ArrayLike) -> Array:
    """R(axis, angle) v without forming matrices: `angle` [rad] (n,), `v` (n, 3) or (3,), result (n, 3)."""
    u, v = np.asarray(axis, dtype=float), np.asarray(v, dtype=float)
    c, s = np.cos(angle)[..., None], np.sin(angle)[..., None]
    along = np.sum(u * v, axis=-1, keepdims=True) * u
    return np.asarray(c * v + s * cross(u, v) + (1 - c) * along)


def rotation_vector(w: ArrayLike) -> Array:
    """exp([w]×): the rotation by |w| [rad] about w (3,); the identity for w = 0."""
    w = np.asarray(w, dtype=float)
    angle = float(np.linalg.norm(w))
    return np.eye(3) if angle == 0 else rotation(w / angle, angle)


def shortest_rotation(a: ArrayLike, b: ArrayLike) -> Array:
    """The rotation (3, 3) by the smallest angle that carries the direction of `a` onto that of `b`.

    Where they are opposite it is a half turn about a fixed axis across them: x, or y where a is along x.
    """
    a, b = unit(a), unit(b)
    c = float(a @ b)
    if c < -1 + 1e-12:
        across = np.eye(3)[int(abs(a[0]) > 0.9)]
        return rotation(unit(across - (across @ a) * a), np.pi)
    K = skew(cross(a, b))
    return np.asarray(np.eye(3) + K + K @ K / (1 + c))


def plane_normal(points: ArrayLike) -> tuple[Array, Array]:
    """Normal (3,) and centroid (3,) of the plane through `points` (n, 3) by orthogonal regression.

    The normal is the direction of least spread; its sign is free.
    """
    points = np.asarray(points, dtype=float)
    centroid = points.mean(axis=0)
    _, _, vt = np.linalg.svd(points - centroid, full_matrices=False)
    return np.asarray(vt[-1]), np.asarray(centroid)
