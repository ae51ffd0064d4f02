"""The marginal likelihood of a smooth function beside a null model: its coefficients are integrated over their prior.

u ~ N(0, g v I) with noise v S: log L = −½ [N log v + rss / v + q Σ log S + log |I + g A|], A the columns' Gram matrix
under S with the null model eliminated, rss = yᵀ y − g bᵀ (I + g A)⁻¹ b. So smoothness is paid for as it is used
(MacKay, Neural Comput. 4, 415, 1992), under every noise that the null model may take too.

Of many g at once: turned so that A is tridiagonal and b lies along its first axis (Golub & Van Loan, Matrix
Computations, 8.3.1, of A bordered by b), the determinant is the product, and the first element of the inverse the last,
of D_i = 1 + g a_i − g² c_i² / D_{i+1}, a the diagonal and c what stands beside it: a quarter of the eigenvectors' time.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.noise.coloured import NullModel, grams_by_band
from labcal.loop.noise.column_sets import ColumnSets

Array = NDArray[np.float64]
RATIOS = np.logspace(-3, 7, 41)  # g: prior variance over the noise's


@dataclass(frozen=True, slots=True)
class Marginal:
    """The most likely prior and noise of one basis."""

    log: float
    ratio: float  # g
    level: float  # of the white noise, in whitened units
    spectrum: int


@dataclass(frozen=True, slots=True, eq=False)
class NullEliminated:
    """Columns with the null model eliminated, under some of its spectra."""

    null: NullModel
    spectra: Sequence[int]
    gram: Array  # (spectra, p, p)
    xty: Array  # (spectra, p)

    @classmethod
    def of(cls, null: NullModel, X: Array, spectra: Sequence[int]) -> NullEliminated:
        """For transformed columns X (n, q, p)."""
        own, cross = grams_by_band(ColumnSets.alone(X), null.columns_and_y, null.bands)
        return cls._without_null(null, own[:, 0], cross, spectra)

    @classmethod
    def of_product(cls, null: NullModel, functions: Array, whiten: Array, spectra: Sequence[int]) -> NullEliminated:
        """For transformed functions (n, m) on each axis, whitened alike (q, 3) in all rows: a ninth of the work."""
        others = null.columns_and_y.reshape(len(functions), len(whiten), -1)
        pieces = list(itertools.pairwise(null.bands.edges.tolist()))
        square = np.array([functions[a:b].T @ functions[a:b] for a, b in pieces])
        cross = np.array([np.tensordot(others[a:b], functions[a:b], axes=(0, 0)) for a, b in pieces])
        onto = np.einsum("kqbm,qi->kbmi", cross, whiten)
        own = np.einsum("kmn,ij->kminj", square, whiten.T @ whiten)
        p = 3 * functions.shape[1]
        return cls._without_null(null, own.reshape(-1, p, p), onto.reshape(*onto.shape[:2], p), spectra)

    @classmethod
    def _without_null(cls, null: NullModel, each: Array, crossed: Array, spectra: Sequence[int]) -> NullEliminated:
        """From the Gram matrices of each band: (bands, p, p), and (bands, others, p) with null columns and y."""
        from scipy.linalg import solve_triangular

        grams, xtys = [], []
        for t in spectra:
            weight = 1.0 / null.bands.spectra[t]
            own, cross = np.tensordot(weight, each, axes=1), np.tensordot(weight, crossed, axes=1)
            carried = solve_triangular(null.cholesky[t], cross[:-1], lower=True)
            grams.append(own - carried.T @ carried)
            xtys.append(cross[-1] - null.projected_y[t] @ carried)
        return cls(null, spectra, np.array(grams), np.array(xtys))

    def best(self) -> Marginal:
        """The most likely prior of the columns themselves."""
        explained, log_determinant = _integrated(self.gram, self.xty)
        rss = self.null.rss[list(self.spectra)][:, None] - explained
        return self._likeliest(np.maximum(rss, 1e-300), log_determinant)

    def best_times(self, functions: Array) -> Marginal:
        """The most likely prior of the columns times `functions` (p, r)."""
        return replace(self, gram=functions.T @ self.gram @ functions, xty=self.xty @ functions).best()

    def _likeliest(self, rss: Array, occam: Array) -> Marginal:
        null, size = self.null, self.null.y.size
        variance = np.maximum(rss / size, null.min_noise_level**2)
        colour = null.y.shape[1] * (np.log(null.bands.spectra[list(self.spectra)]) @ null.bands.count)
        logs = -0.5 * (size * np.log(variance) + rss / variance + colour[:, None] + occam)
        t, g = np.unravel_index(int(np.argmax(logs)), logs.shape)
        level = float(np.sqrt(variance[t, g]))
        return Marginal(float(logs[t, g]), float(RATIOS[g]), level, int(self.spectra[int(t)]))


def _integrated(gram: Array, b: Array) -> tuple[Array, Array]:
    """What b (t, p) explains, g bᵀ (I + g A)⁻¹ b, and log |I + g A| (t, ratios), of Gram matrices A (t, p, p)."""
    along, beside = _tridiagonal(gram, b)
    left, logs = np.ones((len(b), len(RATIOS))), np.zeros((len(b), len(RATIOS)))
    after = np.append(beside[:, 1:], np.zeros((len(b), 1)), axis=1)
    for a, c in zip(along.T[::-1, :, None], after.T[::-1, :, None], strict=True):
        left = np.maximum(1 + RATIOS * a - np.square(RATIOS * c) / left, 1.0)
        logs += np.log(left)
    return RATIOS * np.square(beside[:, :1]) / left, logs


def _tridiagonal(gram: Array, b: Array) -> tuple[Array, Array]:
    """The diagonals (t, p) of A turned; b's length along the first axis, then what stands beside them (t, p)."""
    from scipy.linalg.lapack import dsytrd, dsytrd_lwork

    t, p = b.shape
    diagonal, beside = np.empty((t, p + 1)), np.empty((t, p))
    work = int(dsytrd_lwork(p + 1, lower=1)[0])
    for k in range(t):
        bordered = np.zeros((p + 1, p + 1), order="F")
        bordered[1:, 0], bordered[1:, 1:] = b[k], gram[k]
        _, diagonal[k], beside[k], _, _ = dsytrd(bordered, lower=1, lwork=work, overwrite_a=1)
    return diagonal[:, 1:], beside
