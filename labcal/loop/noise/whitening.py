"""What columns take off a residual under one noise spectrum: a matrix product for each candidate.

Cheaper than the likelihood under every spectrum (`coloured`): for refining, for pairs and for surrogates.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.loop.noise.coloured import NullModel
from labcal.loop.noise.column_sets import ColumnSets
from labcal.loop.noise.nuisance import MIN_NEW_SHARE, RANK_TOLERANCE, explained_squares, principal_span

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class WhitenedNull:
    """A null model under one of its spectra: every frequency divided by the noise's standard deviation there."""

    weight: Array  # (n,) of each frequency
    basis: Array  # (n q, b) orthonormal, spans the null model's columns
    residual: Array  # (n q, 1) what they leave of y

    @classmethod
    def of(cls, null_model: NullModel, spectrum: int | None = None) -> WhitenedNull:
        """Under the spectrum that fits the null model best, or under number `spectrum`, at the null model's level."""
        number = null_model.null.spectrum if spectrum is None else spectrum
        spread = np.repeat(null_model.bands.spectra[number], np.diff(null_model.bands.edges)) ** 0.5
        weight = 1 / (spread * null_model.null.level)
        columns, y = (part * weight[:, None, None] for part in (null_model.columns, null_model.y))
        basis = principal_span(columns, tolerance=RANK_TOLERANCE).reshape(y.size, -1)
        return cls(weight, basis, _orthogonal(basis, y.reshape(-1, 1)))

    def surrogates(self, signs: Array) -> Array:
        """The residual with other signs (n q, draws), orthogonal to the null model's columns."""
        return _orthogonal(self.basis, self.residual * signs)

    def gains(self, sets: ColumnSets, residuals: Array) -> tuple[Array, NDArray[np.intp]]:
        """Log-likelihood (c, draws) that each of c transformed sets of columns gains on `residuals`; ranks (c,)."""
        schur, xty = self._reduced(sets, residuals)
        explained, new = explained_squares(schur, xty, MIN_NEW_SHARE)
        return 0.5 * explained, new.sum(axis=1)

    def gain(self, X: Array) -> float:
        """Log-likelihood that the columns X (n, q, p) gain on the residual."""
        return float(self.gains(ColumnSets.alone(X), self.residual)[0][0, 0])

    def normal_equations(self, X: Array) -> tuple[Array, Array]:
        """Of columns X (n, q, p) at unit length, the null model eliminated: (p, p), and (p, 1) with the residual."""
        schur, xty = self._reduced(ColumnSets.alone(X), self.residual)
        return schur[0], xty[0]

    def _reduced(self, sets: ColumnSets, residuals: Array) -> tuple[Array, Array]:
        weighted = sets.made_of * self.weight[:, None, None]
        flat = weighted.reshape(-1, weighted.shape[2])
        gram = sets.squares(flat)
        cross, xty = (sets.products(part.T @ flat).T.reshape(*gram.shape[:2], -1) for part in (self.basis, residuals))
        length = np.maximum(np.sqrt(np.einsum("cpp->cp", gram)), 1e-300)
        schur = (gram - cross @ np.swapaxes(cross, 1, 2)) / length[:, :, None] / length[:, None]
        return schur, xty / length[:, :, None]


def _orthogonal(basis: Array, y: Array) -> Array:
    return np.asarray(y - basis @ (basis.T @ y))
