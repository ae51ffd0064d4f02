"""Least squares beside nuisance columns, and the projections it rests on.

Columns X are of interest, columns N (the base model, accepted effects) are nuisance. Eliminating N leaves the Schur
complement S = XᵀX − XᵀN (NᵀN)⁺ NᵀX (Frisch & Waugh, Econometrica 1, 387, 1933). X may lie in the span of N but for
rounding; directions of X of which less than `min_new_share` of the square is new to N carry no information and are
left out. Shapes: columns are (n, q, p), n rows of q numbers; Gram matrices are (..., p, p).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
MIN_NEW_SHARE = 1e-4  # of a column's square must be new to the nuisance columns
RANK_TOLERANCE = 1e-10  # of the largest eigenvalue of a Gram matrix: directions below carry no information


@dataclass(frozen=True, slots=True, eq=False)
class Reduced:
    """Normal equations with the nuisance columns eliminated, all columns taken at unit length."""

    length: Array  # (b + p,) of the columns: nuisance first
    nuisance_inverse: Array  # (b, b) (NᵀN)⁺
    carried: Array  # (b, p) (NᵀN)⁺ NᵀX
    values: Array  # (r,) of S along the directions that are left
    vectors: Array  # (p, r) these directions, S-orthogonal
    min_new_share: float

    @classmethod
    def of(cls, gram: Array, nuisance: int, min_new_share: float = MIN_NEW_SHARE) -> Reduced:
        """From the Gram matrix (b + p, b + p) whose first `nuisance` = b columns are N."""
        b, length = nuisance, unit_lengths(gram)
        gram = gram / np.outer(length, length)
        pinv = np.linalg.pinv(gram[:b, :b], rcond=RANK_TOLERANCE, hermitian=True)
        inverse = np.asarray(pinv, dtype=np.float64)
        carried = inverse @ gram[:b, b:]
        new = gram[b:, b:] - gram[b:, :b] @ carried
        return cls(length, inverse, carried, *new_directions(gram[b:, b:], new, min_new_share), min_new_share)

    @property
    def inverted(self) -> Array:
        """1 / value (r,), zero where the direction is not new."""
        return np.where(self.values > self.min_new_share, 1 / np.maximum(self.values, 1e-300), 0.0)

    def solve(self, xty: Array) -> Array:
        """Coefficients (b + p,) for the products (b + p,) of the columns with y."""
        b, xty = len(self.carried), xty / self.length
        x = self.vectors @ (self.inverted * (self.vectors.T @ (xty[b:] - self.carried.T @ xty[:b])))
        return np.asarray(np.concatenate([self.nuisance_inverse @ xty[:b] - self.carried @ x, x]) / self.length)

    def inverse(self) -> Array:
        """The generalised inverse (b + p, b + p) of the Gram matrix."""
        of_x = (self.vectors * self.inverted) @ self.vectors.T
        cross = -self.carried @ of_x
        of_nuisance = self.nuisance_inverse + self.carried @ of_x @ self.carried.T
        return np.asarray(np.block([[of_nuisance, cross], [cross.T, of_x]]) / np.outer(self.length, self.length))


def unit_lengths(gram: Array) -> Array:
    """The lengths (p,) of columns with this Gram matrix (p, p), one where a column is zero."""
    square = np.diag(gram)
    return np.asarray(np.sqrt(np.where(square > 0, square, 1.0)), dtype=np.float64)


def new_directions(gram: Array, new: Array, min_new_share: float = MIN_NEW_SHARE) -> tuple[Array, Array]:
    """What is new (r,) along each direction (p, r), S-orthogonal; a share of its own square where one is asked for.

    From the Gram matrix (p, p) of columns of unit length, and `new` = S (p, p), that of what nuisance columns leave.
    """
    values, vectors = np.linalg.eigh(new)
    return _principal(values, vectors, gram) if min_new_share > MIN_NEW_SHARE else (values, vectors)


def _principal(values: Array, vectors: Array, gram: Array) -> tuple[Array, Array]:
    """The share (r,) of its own square that is new in each principal direction (p, r) of columns with this Gram matrix.

    The square of the sine of a principal angle to the nuisance (Hotelling, Biometrika 28, 321, 1936): it does not
    depend on the columns that a span is given by, as an eigenvalue of S at columns of unit length does.
    """
    new = values > MIN_NEW_SHARE
    kept = vectors[:, new]
    to_unit = np.linalg.inv(np.linalg.cholesky(kept.T @ gram @ kept))
    shares, turned = np.linalg.eigh((to_unit * values[new]) @ to_unit.T)
    return shares, kept @ to_unit.T @ turned


def ols_with_nuisance(columns: Array, y: Array, nuisance: int, min_new_share: float = MIN_NEW_SHARE) -> Array:
    """The x of least |A x − y|² for A (n, q, b + p) and y (n, q); the first `nuisance` columns are N.

    Directions of the others that are hardly new stay at zero: a large effect that the base model undoes is no finding.
    """
    flat = columns.reshape(-1, columns.shape[2])
    return Reduced.of(flat.T @ flat, nuisance, min_new_share).solve(flat.T @ y.ravel())


def inverse_gram(gram: Array, nuisance: int, min_new_share: float = MIN_NEW_SHARE) -> Array:
    """The generalised inverse of a Gram matrix, zero in directions of the others that are hardly new."""
    return Reduced.of(gram, nuisance, min_new_share).inverse()


def explained_squares(schur: Array, xty: Array, smallest: Array | float) -> tuple[Array, Mask]:
    """What columns take off sums of squares (..., k), and which of their directions are new (..., p).

    For reduced Gram matrices S (..., p, p), products (..., p, k) with what the nuisance columns leave, and the
    `smallest` eigenvalue of S (a number or (..., 1)) that counts.
    """
    values, vectors = np.linalg.eigh(schur)
    new = values > smallest
    along = np.swapaxes(vectors, -1, -2) @ xty
    share = np.where(new, 1 / np.where(new, values, 1.0), 0.0)
    return np.asarray(np.sum(along**2 * share[..., None], axis=-2)), new


def explained_by_each(gram: Array, cross: Array, xty: Array, nuisance_inverse: Array) -> Array:
    """What each of k sets of columns takes off the sum of squares (k,), beside common nuisance columns.

    Of each set: its Gram matrix (k, p, p), its products (k, p, b) with N and (k, p) with what N leaves.
    """
    schur = gram - cross @ nuisance_inverse @ np.swapaxes(cross, 1, 2)
    return explained_squares(schur, xty[:, :, None], MIN_NEW_SHARE * np.trace(gram, axis1=1, axis2=2)[:, None])[0][:, 0]


def gram_pinv(columns: Array) -> Array:
    """(AᵀA)⁺ (..., k, k) of A (..., m, k), columns taken at unit length; zero in directions that A does not have."""
    length = np.linalg.norm(columns, axis=-2)
    length = np.where(length > 0, length, 1.0)
    both = length[..., :, None] * length[..., None, :]
    gram = np.swapaxes(columns, -1, -2) @ columns / both
    return np.asarray(np.linalg.pinv(gram, rcond=RANK_TOLERANCE, hermitian=True) / both)


def orthonormal(columns: Array) -> Array:
    """Orthonormal columns (n, q, few) that span the given ones (n, q, b), but for directions without information."""
    n, q, b = columns.shape
    flat = columns.reshape(n * q, b)
    unit = flat / np.maximum(np.sqrt(np.sum(flat**2, axis=0)), 1e-300)
    left, size, _ = np.linalg.svd(unit, full_matrices=False)
    return np.asarray(left[:, size**2 > RANK_TOLERANCE * size[0] ** 2].reshape(n, q, -1))


def orthogonal_complement(columns: Array, part: Array) -> Array:
    """What is new in `part` (n, q, p): orthonormal, and orthogonal to the orthonormal `columns` (n, q, b)."""
    n, q, _ = part.shape
    X, own = columns.reshape(n * q, -1), part.reshape(n * q, -1)
    cross, gram = X.T @ own, own.T @ own
    length = np.maximum(np.sqrt(np.diag(gram)), 1e-150)
    values, vectors = np.linalg.eigh((gram - cross.T @ cross) / np.outer(length, length))
    new = values > MIN_NEW_SHARE
    combined = vectors[:, new] / length[:, None] / np.sqrt(values[new])
    return np.asarray((own @ combined - X @ (cross @ combined)).reshape(n, q, -1))


def beside(columns: Array, part: Array) -> Array:
    """What no combination of the orthonormal `columns` (n, q, b) carries of each of `part` (n, q, p)."""
    n, q, _ = part.shape
    X, own = columns.reshape(n * q, -1), part.reshape(n * q, -1)
    return np.asarray((own - X @ (X.T @ own)).reshape(part.shape))


def squares_beside(columns: Array, part: Array) -> float:
    """The sum of squares of `part` (n, q, p) that no combination of the orthonormal `columns` (n, q, b) carries."""
    n, q, _ = part.shape
    X, own = columns.reshape(n * q, -1), part.reshape(n * q, -1)
    return float(np.sum(own**2) - np.sum((X.T @ own) ** 2))


def principal_span(
    columns: Array, times: Array | float = 1.0, tolerance: float = 1e-8, *, common: bool = False
) -> Array:
    """A few orthonormal columns (n, q, few) that span the given ones (n, q, p) to a `tolerance` of squares.

    Each column is counted so many `times`. By the Gram matrix: fast, for columns far more than their rank.
    """
    n, q, p = columns.shape
    flat = columns.reshape(n * q, p)
    gram = flat.T @ flat
    length = np.maximum(np.sqrt(np.diag(gram)), 1e-150) / np.sqrt(times)
    values, vectors = np.linalg.eigh(gram / np.outer(length, length))
    kept = values > tolerance * values.max(initial=0.0)  # of no columns none
    few = flat @ (vectors[:, kept] / length[:, None])
    return np.asarray((few if common else few / np.sqrt(values[kept])).reshape(n, q, -1))


def span_of_combinations(
    columns: Array, mix: Array, times: Array, tolerance: float = 1e-8, *, common: bool = False
) -> Array:
    """The same for the columns that `mix` (m, p) makes of fewer (n, q, m)."""
    n, q, m = columns.shape
    basis, triangle = np.linalg.qr(columns.reshape(n * q, m))
    made = triangle @ mix
    made *= np.sqrt(times) / np.maximum(np.linalg.norm(made, axis=0), 1e-150)
    left, size, _ = np.linalg.svd(made, full_matrices=False)
    kept = size**2 > tolerance * size[0] ** 2
    return np.asarray((basis @ (left[:, kept] * (size[kept] if common else 1.0))).reshape(n, q, -1))
