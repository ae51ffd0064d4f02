"""Least squares beside nuisance columns: projections, in one place."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


SEEN = 1e-4  # of a column's square must be new to the base
NOTHING = 1e-10  # of the largest eigenvalue: directions below carry no information


def orthonormal(columns: Array) -> Array:
    """Columns (n, q, few) at right angles that span the given ones (n, q, b), but for directions that carry nothing."""
    n, q, b = columns.shape
    flat = columns.reshape(n * q, b)
    unit = flat / np.maximum(np.sqrt(np.sum(flat**2, axis=0)), 1e-300)
    left, size, _ = np.linalg.svd(unit, full_matrices=False)
    return np.asarray(left[:, size**2 > NOTHING * size[0] ** 2].reshape(n, q, -1))


def new_to(columns: Array, part: Array) -> Array:
    """What is new in `part` (n, q, p), at right angles to `columns` (n, q, b) and to each other, as these are.

    More than SEEN of the square of a combination of `part` has to be new.
    """
    n, q, _ = part.shape
    X, own = columns.reshape(n * q, -1), part.reshape(n * q, -1)
    cross, left = X.T @ own, own.T @ own
    length = np.maximum(np.sqrt(np.diag(left)), 1e-150)
    values, vectors = np.linalg.eigh((left - cross.T @ cross) / np.outer(length, length))
    new = vectors[:, values > SEEN] / length[:, None] / np.sqrt(values[values > SEEN])
    return np.asarray((own @ new - X @ (cross @ new)).reshape(n, q, -1))


def minimise(A: Array, y: Array, base: int, seen: float = SEEN) -> Array:
    """The x of least |A x − y|² for A (n, q, p), of which the first `base` columns are the base model's.

    Directions of the others that the base nearly contains (to `seen` of their square) stay at zero: a large effect that
    the base undoes is no finding, and nothing that the data support.
    """
    n, q, p = A.shape
    flat = A.reshape(n * q, p)
    gram = flat.T @ flat
    scale = np.sqrt(np.diag(gram))
    scale = np.where(scale > 0, scale, 1.0)
    gram, pull = gram / np.outer(scale, scale), flat.T @ y.ravel() / scale
    inverse = np.linalg.pinv(gram[:base, :base], rcond=NOTHING, hermitian=True)
    carried = inverse @ gram[:base, base:]
    values, vectors = np.linalg.eigh(gram[base:, base:] - gram[base:, :base] @ carried)
    kept = np.where(values > seen, 1 / np.maximum(values, 1e-300), 0.0)
    x = vectors @ (kept * (vectors.T @ (pull[base:] - carried.T @ pull[:base])))
    return np.asarray(np.concatenate([inverse @ (pull[:base] - gram[:base, base:] @ x), x]) / scale)


def spanning(columns: Array, times: Array | float = 1.0, least: float = 1e-4) -> Array:
    """A few columns (n, q, few) that span the given ones, each there so many `times`, to a part `least` of norms."""
    n, q, p = columns.shape
    flat = columns.reshape(n * q, p)
    gram = flat.T @ flat
    size = np.maximum(np.sqrt(np.diag(gram)), 1e-150) / np.sqrt(times)
    values, vectors = np.linalg.eigh(gram / np.outer(size, size))
    kept = values > least**2 * values[-1]
    few = flat @ (vectors[:, kept] / size[:, None] / np.sqrt(values[kept]))
    return np.asarray(few.reshape(n, q, -1))


def _inverse(A: Array, base: int, seen: float) -> Array:
    """Of a Gram matrix, zero in the directions of the effects that the base nearly contains."""
    scale = np.sqrt(np.diag(A))
    scale = np.where(scale > 0, scale, 1.0)
    A = A / np.outer(scale, scale)
    first = np.linalg.pinv(A[:base, :base], rcond=NOTHING, hermitian=True)
    carried = first @ A[:base, base:]
    values, vectors = np.linalg.eigh(A[base:, base:] - A[base:, :base] @ carried)
    second = (vectors * np.where(values > seen, 1 / np.maximum(values, 1e-300), 0.0)) @ vectors.T
    cross = -carried @ second
    whole = np.block([[first + carried @ second @ carried.T, cross], [cross.T, second]])
    return np.asarray(whole / np.outer(scale, scale))
