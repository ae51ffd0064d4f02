"""What columns take off a residual under the noise that was fitted without them: a product of matrices each."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.loop.noise.coloured import Stage

Array = NDArray[np.float64]
LEAST = 1e-4  # of a column's square must be new to what stands there


@dataclass(frozen=True, slots=True, eq=False)
class Whitened:
    """A stage under one of its spectra: every frequency over the noise's standard deviation there."""

    weight: Array  # (n,) of each frequency
    known: Array  # (n q, b) orthonormal, spans the columns that stand there
    left: Array  # (n q, 1) what they leave of y

    @classmethod
    def of(cls, stage: Stage, tried: int | None = None) -> Whitened:
        """Under the spectrum that fits what the stage leaves, or under the one `tried`, at the stage's own level."""
        spectrum = stage.bands.spectra[stage.null.tried if tried is None else tried]
        weight = np.repeat(spectrum, np.diff(stage.bands.edges)) ** -0.5 / stage.null.level
        known = _basis(_flat(stage.columns, weight))
        return cls(weight, known, _without(known, _flat(stage.y, weight)))

    def drawn(self, signs: Array) -> Array:
        """What is left with other signs (n q, draws), and nothing of the known columns in it."""
        return _without(self.known, self.left * signs)

    def gains(self, X: Array, drawn: Array) -> tuple[Array, NDArray[np.intp]]:
        """What each of c sets of columns X (n, q, c, p) takes off `drawn`, halved (c, draws), and its new columns."""
        moved = X * self.weight[:, None, None, None]
        c, p = moved.shape[2:]
        flat = np.ascontiguousarray(moved.reshape(-1, c * p).T)
        each, carried = flat.reshape(c, p, -1), (flat @ self.known).reshape(c, p, -1)
        own = each @ np.swapaxes(each, 1, 2)
        size = np.maximum(np.sqrt(np.einsum("cpp->cp", own)), 1e-300)
        values, vectors = np.linalg.eigh(
            (own - carried @ np.swapaxes(carried, 1, 2)) / size[:, :, None] / size[:, None]
        )
        new = values > LEAST
        along = np.swapaxes(vectors, 1, 2) @ ((flat @ drawn).reshape(c, p, -1) / size[:, :, None])
        part = np.where(new, 1 / np.where(new, values, 1.0), 0.0)
        return 0.5 * np.sum(along**2 * part[:, :, None], axis=1), new.sum(axis=1)

    def gain(self, X: Array) -> float:
        """What the columns X (n, q, p) take off what is left, halved [nats]."""
        return float(self.gains(X[:, :, None, :], self.left)[0][0, 0])


def _flat(columns: Array, weight: Array) -> Array:
    return (columns * weight[:, None, None]).reshape(-1, columns.shape[2])


def _without(known: Array, left: Array) -> Array:
    return np.asarray(left - known @ (known.T @ left))


def _basis(columns: Array) -> Array:
    """Orthonormal columns that span the given ones."""
    size = np.sqrt(np.sum(columns**2, axis=0))
    scaled = columns / np.maximum(size, 1e-300)
    values, vectors = np.linalg.eigh(scaled.T @ scaled)
    kept = values > 1e-6 * LEAST
    return np.asarray(scaled @ (vectors[:, kept] / np.sqrt(values[kept])))
