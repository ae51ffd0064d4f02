"""A cage's matrix and its ambient field from magnitudes alone, as an absolute scalar sensor in the centre tells them.

F = |A (I + ρ∘s) + b0 + drift(t)|: I the currents, s their signs, ρ what a supply lets through at zero behind its
contacts. No magnitude sees a rotation of everything, so the frame is the coils' own: x along coil x, y in the plane of
coils x and y; then A is upper triangular with a positive diagonal (its QR decomposition), and b0 is as definite.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline

from labcal.fit.autocorrelation import variance_inflation
from labcal.uncertainty import Contribution, DeclaredError, covariance_of

Array = NDArray[np.float64]
UPPER = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))  # elements of A, in their order
PARAMETERS = 12  # A's six, b0, ρ; the drift's beyond them
KNOT_S = 60.0  # the place's field follows a cubic spline of such pieces
ROUNDS, SMALL = 30, 1e-9
LARGEST_CONDITION = 1e5


@dataclass(frozen=True, slots=True, eq=False)
class Magnitudes:
    """What a scalar sensor saw: `currents_A` and `signs` (n, 3), magnitudes (n,) [nT] at times (n,)."""

    t_s: Array
    currents_A: Array
    signs: Array  # of the contacts; 0 where the outputs are open
    magnitude_nT: Array

    def __len__(self) -> int:
        return len(self.t_s)

    def select(self, rows: NDArray[np.bool_]) -> Magnitudes:
        """These rows alone."""
        return Magnitudes(self.t_s[rows], self.currents_A[rows], self.signs[rows], self.magnitude_nT[rows])


@dataclass(frozen=True, slots=True, eq=False)
class AmbientSpline:
    """What the place's field does beside its mean: a cubic spline in time."""

    knots_s: Array
    mean: Array  # (q,) of the columns over the rows that were fitted
    coefficients_nT: Array  # (q, 3)

    def columns(self, t_s: Array) -> Array:
        """The spline's columns (n, q), each about its mean; times must lie between the first and the last fitted."""
        columns = BSpline.design_matrix(t_s, self.knots_s, 3).toarray()[:, 1:]  # all of them add up to one: that is b0
        return np.asarray(columns - self.mean)

    def at(self, t_s: Array) -> Array:
        """Field (n, 3) [nT, the coils' frame]."""
        return np.asarray(self.columns(t_s) @ self.coefficients_nT)


def _course(t_s: Array) -> AmbientSpline:
    pieces = max(1, round(float(np.ptp(t_s)) / KNOT_S))
    inner = np.linspace(t_s.min(), t_s.max(), pieces + 1)
    still = AmbientSpline(
        np.r_[[inner[0]] * 3, inner, [inner[-1]] * 3], np.zeros(pieces + 2), np.zeros((pieces + 2, 3))
    )
    return replace(still, mean=still.columns(t_s).mean(axis=0))


@dataclass(frozen=True, slots=True, eq=False)
class ScalarCage:
    """A, b0 (mean through the run) and ρ. Covariances order A's upper elements row by row, b0, ρ (12, 12)."""

    matrix_nT_per_A: Array  # (3, 3) upper triangular: columns are the coil axes
    ambient_nT: Array  # (3,)
    leak_A: Array  # (3,) ρ
    course: AmbientSpline
    covariance_a: Array  # of the residuals
    contributions: tuple[Contribution, ...]  # of what is declared of the sensor
    residual_nT: Array  # (n,) F less the model's

    @property
    def covariance(self) -> Array:
        """All that is known of it."""
        return np.asarray(self.covariance_a + covariance_of(self.contributions, PARAMETERS))

    @property
    def parameters(self) -> Array:
        """(12,) in the covariance's order."""
        upper = np.array([self.matrix_nT_per_A[i, j] for i, j in UPPER])
        return np.concatenate([upper, self.ambient_nT, self.leak_A])

    def magnitude_nT(self, seen: Magnitudes) -> Array:
        """What it makes the sensor see (n,) [nT] at the currents and times of `seen`."""
        I = seen.currents_A + self.leak_A * seen.signs  # noqa: E741  # I is the current, as in the formulas
        b = I @ self.matrix_nT_per_A.T + self.ambient_nT + self.course.at(seen.t_s)
        return np.asarray(np.linalg.norm(b, axis=1))

    def constants(self) -> tuple[Array, Array]:
        """Each coil's constant (3,) [nT/A], the length of its column, and standard uncertainties."""
        return self._derived(lambda A: np.linalg.norm(A, axis=0))

    def angles_deg(self) -> tuple[Array, Array]:
        """How far coils x y, x z and y z are from square (3,) [deg], positive below 90°, and standard uncertainties."""
        return self._derived(_from_square_deg)

    def _derived(self, of: Callable[[Array], Array]) -> tuple[Array, Array]:
        here, C = np.asarray(of(self.matrix_nT_per_A)), self.covariance[:6, :6]
        step = 1e-6 * float(np.abs(self.matrix_nT_per_A).max())
        J = np.column_stack([(of(self.matrix_nT_per_A + step * _one(i, j)) - here) / step for i, j in UPPER])
        return here, np.sqrt(np.diag(J @ C @ J.T))


def _one(i: int, j: int) -> Array:
    out = np.zeros((3, 3))
    out[i, j] = 1.0
    return out


def _from_square_deg(A: Array) -> Array:
    u = A / np.linalg.norm(A, axis=0)
    return np.degrees(np.arcsin([u[:, 0] @ u[:, 1], u[:, 0] @ u[:, 2], u[:, 1] @ u[:, 2]]))


def by_components(seen: Magnitudes) -> tuple[Array, Array]:
    """A (3, 3) and b0 (3,) in closed form, from squares: F² = Iᵀ G I + 2 gᵀ I + c with G = AᵀA, g = Aᵀ b0.

    One coil at ±I gives G_jj and g_j (half the sum and a quarter of the difference of F²), two coils at the four signs
    G_jk; all at once by least squares weighted with 1 / 2F, the uncertainty of F². A is G's Cholesky factor.
    Raises ValueError where the currents do not determine them.
    """
    I, F = seen.currents_A, seen.magnitude_nT  # noqa: E741  # I is the current, as in the formulas
    size = float(np.abs(I).max()) or 1.0
    J = I / size
    squares = [J[:, a] * J[:, b] * (1 if a == b else 2) for a, b in UPPER]
    X = np.column_stack([*squares, 2 * J, np.ones(len(F))]) / (2 * F[:, None])
    if len(F) <= X.shape[1] or _open(X):
        raise ValueError("these currents do not determine the coils: each alone in both signs, and every two together")
    found = np.linalg.lstsq(X, F / 2, rcond=None)[0]
    G = np.zeros((3, 3))
    for (a, b), value in zip(UPPER, found[:6], strict=True):
        G[a, b] = G[b, a] = value / size**2
    if np.linalg.eigvalsh(G)[0] <= 0:
        raise ValueError("the magnitudes are those of no three coils: does the sensor follow the currents?")
    A: Array = np.asarray(np.linalg.cholesky(G).T, dtype=np.float64)
    return A, np.asarray(np.linalg.solve(A.T, found[6:9] / size))


def fit_scalar_cage(
    seen: Magnitudes,
    *,
    others: Sequence[tuple[DeclaredError, Array]] = (),
    start: ScalarCage | None = None,
) -> ScalarCage:
    """The most likely A, b0, ρ and drift of the magnitudes `seen`, by Gauss-Newton from `by_components` or `start`.

    dF = b̂ · db with b = A (I + ρ∘s) + b0 + S(t) c, S a cubic spline's columns about their mean. Covariance: of the
    residuals, with degrees of freedom taken off, widened where neighbours in time correlate; and the shift by each of
    `others`, errors that are declared of the sensor, with the magnitudes (n,) as it would have read them.
    Raises ValueError where the rows do not determine all twelve.
    """
    A, b0 = by_components(seen) if start is None else (start.matrix_nT_per_A, start.ambient_nT)
    theta = np.r_[[A[i, j] for i, j in UPPER], b0, np.zeros(3)]
    course = _course(seen.t_s)
    S, drift = course.columns(seen.t_s), course.coefficients_nT
    J, left = np.zeros((0, 0)), np.zeros(0)
    for _ in range(ROUNDS):
        J, left = _linearised(seen, theta, S, drift)
        _refuse(J)
        step = _solved(J, left)
        theta, drift = theta + step[:PARAMETERS], drift + step[PARAMETERS:].reshape(-1, 3)
        if np.abs(J @ step).max() < SMALL:
            break
    spare = len(seen) - J.shape[1]
    wider = variance_inflation(left[:, None], np.zeros(len(left), dtype=np.intp))
    size = np.linalg.norm(J, axis=0)
    bread = np.linalg.inv((J / size).T @ (J / size)) / np.outer(size, size)
    covariance = wider * float(left @ left) / spare * bread
    declared = tuple(_contribution(error, _solved(J, F - seen.magnitude_nT)[:PARAMETERS]) for error, F in others)
    found = replace(course, coefficients_nT=drift)
    return ScalarCage(
        _upper(theta[:6]), theta[6:9], theta[9:12], found, covariance[:PARAMETERS, :PARAMETERS], declared, left
    )


def with_matrix(matrix_nT_per_A: Array, seen: Magnitudes) -> Array:
    """The ambient field (3,) [nT, the matrix' frame] that comes nearest to `seen` with this matrix, as it stands."""
    made = seen.currents_A @ matrix_nT_per_A.T
    b0 = _balls(made, seen.magnitude_nT)
    for _ in range(ROUNDS):
        b = made + b0
        F = np.linalg.norm(b, axis=1)
        b0 = b0 + np.linalg.lstsq(b / F[:, None], seen.magnitude_nT - F, rcond=None)[0]
    return b0


def _balls(made: Array, F: Array) -> Array:
    """b0 (3,) of F² − |made|² = 2 made · b0 + |b0|², the last term taken as free."""
    X = np.column_stack([2 * made, np.ones(len(F))])
    return np.asarray(np.linalg.lstsq(X, F**2 - np.sum(made**2, axis=1), rcond=None)[0][:3])


def _upper(elements: Array) -> Array:
    out = np.zeros((3, 3))
    for (i, j), value in zip(UPPER, elements, strict=True):
        out[i, j] = value
    return out


def largest_En(one: ScalarCage, other: ScalarCage) -> float:
    """|difference| / √(U² + U²) of A's element that differs most (k = 2, ISO 13528:2022, 9.7); b0 has its own time."""
    apart = (one.parameters - other.parameters)[:6]
    return float(np.abs(apart / (2 * np.sqrt(np.diag(one.covariance_a + other.covariance_a)[:6]))).max())


def _linearised(seen: Magnitudes, theta: Array, S: Array, drift: Array) -> tuple[Array, Array]:
    """DF / d parameters (n, 12 + 3 q) and what is left of F (n,)."""
    A = _upper(theta[:6])
    I = seen.currents_A + theta[9:12] * seen.signs  # noqa: E741  # I is the current, as in the formulas
    b = I @ A.T + theta[6:9] + S @ drift
    F = np.linalg.norm(b, axis=1)
    u = b / F[:, None]
    of_A = np.column_stack([u[:, i] * I[:, j] for i, j in UPPER])
    of_drift = (S[:, :, None] * u[:, None, :]).reshape(len(u), -1)
    return np.column_stack([of_A, u, (u @ A) * seen.signs, of_drift]), seen.magnitude_nT - F


def _refuse(J: Array) -> None:
    rows, columns = J.shape
    if rows < columns + 8:
        raise ValueError(f"{rows} magnitudes are too few: coils, ambient field and its course need {columns + 8}")
    if _open(J):
        raise ValueError(
            "these currents do not determine coils and ambient field: turn the field all round, in two sizes"
        )


def _open(J: Array) -> bool:
    """Whether the columns (n, p) leave a direction open."""
    size = np.linalg.norm(J, axis=0)
    return not size.all() or float(np.linalg.cond(J / size)) > LARGEST_CONDITION


def _solved(J: Array, y: Array) -> Array:
    size = np.linalg.norm(J, axis=0)
    return np.asarray(np.linalg.lstsq(J / size, y, rcond=None)[0] / size)


def _contribution(error: DeclaredError, shift: Array) -> Contribution:
    return Contribution(error.source, "B", "normal", error.u, error.unit, np.inf, shift)
