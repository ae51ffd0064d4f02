"""K and k of a sensor at rest from means in many fields: linear least squares, the drift of its zero beside it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.fit.autocorrelation import variance_inflation
from labcal.model import AffineMap
from labcal.uncertainty import Contribution, DeclaredError, covariance_of

Array = NDArray[np.float64]
UNKNOWNS = 5  # of one component: a row of K, k, drift
SPARE = 3  # fields beyond the unknowns
LARGEST_CONDITION = 1e3


@dataclass(frozen=True, slots=True, eq=False)
class SphereFit:
    """b = K m − k − d (t − t̄). Covariances (12, 12) order K row by row, then k.

    `covariance_a` is what the residuals show, `covariance` that and `contributions` of what is declared.
    """

    affine: AffineMap  # k in the middle of the run
    drift_nT_per_s: Array  # (3,)
    u_drift_nT_per_s: Array  # (3,)
    covariance_a: Array
    contributions: tuple[Contribution, ...]
    residual_nT: Array  # (n, 3) b − K m + k + d (t − t̄), with the sign of calibrated less reference

    @property
    def covariance(self) -> Array:
        """All that is known of the uncertainty of K and k."""
        return np.asarray(self.covariance_a + covariance_of(self.contributions, 12))

    @property
    def u(self) -> Array:
        """Standard uncertainties (12,) of K row by row, then k."""
        return np.sqrt(np.diag(self.covariance))


def fit_sphere(
    reading: ArrayLike,
    field_nT: ArrayLike,
    t_s: ArrayLike,
    others: Sequence[tuple[DeclaredError, Array]] = (),
) -> SphereFit:
    """Least squares of fields (n, 3) [nT] on mean readings (n, 3) at `t_s` (n,).

    `others` are errors that are declared of the fields, each with the fields (n, 3) as they would have been stated with
    one standard deviation of it: the same least squares moves by so much.

    With A = [m, −1, −(t − t̄)] (n, 5) and residuals' covariance S = RᵀR / (n − 5) (3, 3), cov = S ⊗ (AᵀA)⁻¹
    (Gauss-Markov, several responses), widened where neighbours in time correlate. The noise of a mean of some seconds
    is some 1e-4 of the field, so that what it takes off K (attenuation, its square) is below 1e-7.
    Raises ValueError where the fields do not determine K, k and drift.
    """
    m, b, t = (np.asarray(v, dtype=float) for v in (reading, field_nT, t_s))
    size = float(np.sqrt(np.mean(np.sum(m**2, axis=1)))) or 1.0
    lasts = float(np.ptp(t)) or 1.0
    A = np.column_stack([m / size, -np.ones(len(m)), -(t - t.mean()) / lasts])
    _refuse(A)
    X = np.linalg.lstsq(A, b, rcond=None)[0]  # (5, 3): a column for each component
    residual = A @ X - b
    scatter = residual.T @ residual / (len(m) - UNKNOWNS)
    wider = variance_inflation(residual, np.zeros(len(m), dtype=np.intp))
    unit = np.diag([1 / size] * 3 + [1.0, 1 / lasts])
    each = unit @ np.linalg.inv(A.T @ A) @ unit
    affine = AffineMap(X[:3].T / size, X[3])
    return SphereFit(
        affine,
        X[4] / lasts,
        np.sqrt(wider * np.diag(scatter) * each[4, 4]),
        wider * _placed(scatter, each[:4, :4]),
        tuple(_contribution(error, np.linalg.lstsq(A, there - b, rcond=None)[0], size) for error, there in others),
        residual,
    )


def _contribution(error: DeclaredError, X: Array, size: float) -> Contribution:
    """What the error does to K row by row, then k (12,), by the solution (5, 3) of the change alone."""
    shift = AffineMap(X[:3].T / size, X[3]).parameters
    return Contribution(error.source, "B", "normal", error.u, error.unit, np.inf, shift)


def _refuse(A: Array) -> None:
    if len(A) < UNKNOWNS + SPARE:
        raise ValueError(f"{len(A)} fields are too few: K, k and drift need {UNKNOWNS + SPARE}")
    if np.linalg.cond(A) > LARGEST_CONDITION:
        raise ValueError("these fields do not determine K, k and drift: they lie in a plane, or follow the time")


def _placed(scatter: Array, each: Array) -> Array:
    """Cov (12, 12) of K row by row, then k, from `scatter` (3, 3) of components and `each` (4, 4) of [row of K, k]."""
    place = [[3 * i, 3 * i + 1, 3 * i + 2, 9 + i] for i in range(3)]
    out = np.zeros((12, 12))
    for i in range(3):
        for j in range(3):
            out[np.ix_(place[i], place[j])] = scatter[i, j] * each
    return out
