"""Axes and quaternions of a recording, as what takes a vector of the cage's frame into the body's."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.importers.mapping import AttitudePart
from labcal.record.assemble import interpolated

Array = NDArray[np.float64]

OFF_ONE = 0.02  # how far a quaternion's length may be from one
STILL_deg = 0.05  # an attitude that stays as near its mean is one attitude


def turned(values: Array, axes: Sequence[str]) -> Array:
    """`values` (n, 3) in new axes: ["y", "x", "-z"] says that the new x is the old y."""
    return np.asarray(values @ signed_permutation(axes).T)


def signed_permutation(axes: Sequence[str]) -> Array:
    """The matrix (3, 3) whose rows pick an old axis each, with its sign."""
    found = np.zeros((3, 3))
    for row, axis in enumerate(axes):
        found[row, "xyz".index(axis[-1])] = -1.0 if axis.startswith("-") else 1.0
    return found


def body_from_cage(when: Array, t: Array, quaternions: Array, part: AttitudePart) -> Array:
    """Attitudes (m, 3, 3) at `when` (m,), from quaternions (n, 4) stamped `t` (n,); NaN where none is near.

    Raises ValueError for quaternions whose length is not one.
    """
    q = quaternions if part.order == "wxyz" else quaternions[:, [3, 0, 1, 2]]
    length = np.linalg.norm(q, axis=1)
    if (off := np.flatnonzero(np.abs(length - 1) > OFF_ONE)).size:
        raise ValueError(f"expected quaternions of length one; that of row {off[0] + 1} is {length[off[0]]:.3g}")
    q = _of_one_sign(q / length[:, None])
    at = interpolated(when, t, q)
    matrix = _matrix(at / np.linalg.norm(at, axis=1)[:, None])
    if part.maps == "body-to-cage":
        matrix = np.swapaxes(matrix, 1, 2)
    return np.asarray(signed_permutation(part.body_axes) @ matrix)


def one_attitude(matrices: Array) -> Array | None:
    """The attitude (3, 3) that all of `matrices` (n, 3, 3) are, within `STILL_deg`; None where it moves."""
    known = matrices[np.isfinite(matrices).all(axis=(1, 2))]
    if not len(known):
        return None
    u, _, vt = np.linalg.svd(known.mean(axis=0))
    mean = u @ np.diag([1.0, 1.0, np.linalg.det(u @ vt)]) @ vt
    off = np.linalg.norm(known - mean, axis=(1, 2)) / np.sqrt(2)  # 2 sin(angle / 2)
    return mean if off.max() < np.radians(STILL_deg) else None


def _of_one_sign(q: Array) -> Array:
    """Quaternions without jumps to their negatives, which mean the same."""
    flips = np.where(np.einsum("ij,ij->i", q[1:], q[:-1]) < 0, -1.0, 1.0)
    return np.asarray(q * np.cumprod(np.concatenate([[1.0], flips]))[:, None])


def _matrix(q: Array) -> Array:
    """The rotations (n, 3, 3) v -> q v q* of unit quaternions (n, 4), scalar part first."""
    w, x, y, z = q.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), -1, 0)
