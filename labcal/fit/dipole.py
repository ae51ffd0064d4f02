"""The magnetic moment of a turned body, permanent and induced, from what a magnetometer near it sees."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.record import period_s

Array = NDArray[np.float64]
MU0_OVER_4PI = 1e-7  # T m/A
PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))  # elements of a symmetric matrix, as they are estimated
CORRELATED_S = 10.0  # what a quadratic does not follow of the place's field is forgotten after so long
STEP_M = 1e-4  # of the derivatives by place


@dataclass(frozen=True, slots=True, eq=False)
class Dwell:
    """What was seen at `place` for a while in one field; dwells of one `session` share the steady field's course."""

    session: int
    place: int
    t_s: Array  # (n,)
    seen_nT: Array  # (n, 3) in C
    field_nT: Array  # (3,) at the body, in C
    cage_from_body: Array | None  # (n, 3, 3); None: the body is away


@dataclass(frozen=True, slots=True, eq=False)
class DipoleFit:
    """m = p + X b. `covariance` (9, 9) orders p, then X's elements xx yy zz xy xz yz."""

    permanent_Am2: Array  # (3,) in B
    induced_Am2_per_T: Array  # (3, 3) in B, symmetric
    covariance: Array

    @property
    def u(self) -> Array:
        """Standard uncertainties (9,)."""
        return np.sqrt(np.diag(self.covariance))

    def with_scale(self, u_scale: float) -> DipoleFit:
        """As uncertain as the scale of the sensor that saw it too, relative: all of the moment follows it."""
        moment = np.concatenate([self.permanent_Am2, [self.induced_Am2_per_T[i, j] for i, j in PAIRS]])
        return replace(self, covariance=self.covariance + u_scale**2 * np.outer(moment, moment))

    def largest_induced_Am2(self, field_nT: float) -> tuple[float, float]:
        """The largest moment [A m²] that `field_nT` induces in any direction, and its standard uncertainty.

        The eigenvalue of X largest in size; d λ = vᵀ dX v for its eigenvector v.
        """
        values, vectors = np.linalg.eigh(self.induced_Am2_per_T)
        v = vectors[:, int(np.argmax(np.abs(values)))]
        by_element = np.array([v[i] * v[j] * (1 if i == j else 2) for i, j in PAIRS])
        u = float(np.sqrt(by_element @ self.covariance[3:, 3:] @ by_element))
        return 1e-9 * field_nT * float(np.abs(values).max()), 1e-9 * field_nT * u


def dipole_field(place_m: ArrayLike) -> Array:
    """The matrix (3, 3) [nT / (A m²)] from a moment at the origin to its field at `place_m` (3,).

    B = µ0 / 4π (3 (m·r̂) r̂ − m) / r³ (Jackson, Classical Electrodynamics, 3rd ed., eq. 5.56).
    """
    r = float(np.linalg.norm(place_m))
    along = np.asarray(place_m) / r
    return np.asarray(1e9 * MU0_OVER_4PI * (3 * np.outer(along, along) - np.eye(3)) / r**3)


def fit_dipole(dwells: Sequence[Dwell], places_m: ArrayLike, u_place_m: float = 0.0) -> DipoleFit:
    """Least squares of p and X over `dwells`, with the steady field of each session and place beside them.

    seen = D(place) A (p + X Aᵀ b) + c(session, t) + K(place) b with A = `cage_from_body`, D = `dipole_field`, c a
    quadratic in time, K what the coils make at the place (without the body away, X's isotropic part would hide in it).
    Covariance: Newey and West, Econometrica 55 (1987), eq. 5, over `CORRELATED_S`; beside it, `u_place_m` of each
    coordinate of `places_m` (k, 3), by derivatives. Raises ValueError where the dwells do not determine all nine.
    """
    steady = _span(_steady(dwells))
    seen = _beside(steady, np.vstack([dwell.seen_nT for dwell in dwells])[:, :, None])[:, :, 0]
    places = np.asarray(places_m, dtype=float)
    columns = _seen_apart(steady, _columns(dwells, places))
    found = _solved(columns, seen)
    scores = np.einsum("nik,ni->nk", columns, seen - columns @ found)
    bread = np.linalg.inv(np.einsum("nik,nil->kl", columns, columns))
    covariance = bread @ newey_west(scores, _lags(dwells)) @ bread
    moved = np.array([_solved(_beside(steady, _columns(dwells, p)), seen) - found for p in _shifted(places)]) / STEP_M
    induced = np.zeros((3, 3))
    for (i, j), value in zip(PAIRS, found[3:], strict=True):
        induced[i, j] = induced[j, i] = value
    return DipoleFit(found[:3], induced, covariance + u_place_m**2 * moved.T @ moved)


def newey_west(scores: Array, lags: int) -> Array:
    """Covariance (k, k) of the sum of correlated rows (n, k): Σ_l w_l Σ_t (s_t s_{t−l}ᵀ + its transpose), Bartlett's w.

    Newey and West, Econometrica 55 (1987), eq. 5; in no direction less than of independent rows, which short stretches
    with a trend taken off would pretend.
    """
    alone, together = scores.T @ scores, np.zeros((scores.shape[1],) * 2)
    for lag in range(1, min(lags, len(scores) - 1) + 1):
        shifted = scores[lag:].T @ scores[:-lag]
        together += (1 - lag / (lags + 1)) * (shifted + shifted.T)
    L = np.linalg.cholesky(alone)
    more, directions = np.linalg.eigh(np.linalg.solve(L, np.linalg.solve(L, together).T))
    root = L @ directions
    return np.asarray(alone + (root * np.maximum(more, 0.0)) @ root.T)


def _steady(dwells: Sequence[Dwell]) -> Array:
    """Columns (n, q): for each session 1, t, t²; for each place the independent parts of its fields."""
    lengths = [len(dwell.t_s) for dwell in dwells]
    t = np.concatenate([dwell.t_s for dwell in dwells])
    session, place = (np.repeat(of, lengths) for of in ([k.session for k in dwells], [k.place for k in dwells]))
    field = np.repeat([dwell.field_nT for dwell in dwells], lengths, axis=0)
    columns = list[Array]()
    for one in np.unique(session):
        inside = session == one
        u = np.where(inside, (t - t[inside].mean()) / max(np.ptp(t[inside]), 1e-9), 0.0)
        columns += [inside.astype(float), u, u**2]
    for one in np.unique(place):
        columns += list(np.where((place == one)[:, None], field, 0.0).T)
    return np.column_stack(columns)


def _span(columns: Array) -> Array:
    """An orthonormal basis (n, r) of what the columns reach."""
    u, s, _ = np.linalg.svd(columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300), full_matrices=False)
    return np.asarray(u[:, s > 1e-9 * s[0]])


def _beside(steady: Array, columns: Array) -> Array:
    """Columns (n, 3, k) without what `steady` (n, r) explains of them, each component by itself."""
    return np.asarray(columns - np.einsum("nr,rik->nik", steady, np.einsum("nr,nik->rik", steady, columns)))


def _seen_apart(steady: Array, columns: Array) -> Array:
    """As `_beside`. Raises ValueError where nothing is left of a column: a moment along the one axis turned about."""
    left = _beside(steady, columns)
    if np.any(np.linalg.norm(left, axis=(0, 1)) < 1e-6 * np.linalg.norm(columns, axis=(0, 1))):
        raise ValueError("these turns do not determine all of the moment")
    return left


def _columns(dwells: Sequence[Dwell], places_m: Array) -> Array:
    """(n, 3, 9): the field [nT] of 1 A m² along each body axis, and of 1 A m²/T of each element of X."""
    return np.concatenate([_of_dwell(dwell, dipole_field(places_m[dwell.place])) for dwell in dwells])


def _of_dwell(dwell: Dwell, dipole: Array) -> Array:
    if dwell.cage_from_body is None:
        return np.zeros((len(dwell.t_s), 3, 9))
    body = 1e-9 * np.einsum("nij,i->nj", dwell.cage_from_body, dwell.field_nT)  # T
    turned = np.einsum("ij,njk->nik", dipole, dwell.cage_from_body)
    induced = [
        turned[:, :, i] * body[:, j, None] + (turned[:, :, j] * body[:, i, None] if i != j else 0.0) for i, j in PAIRS
    ]
    return np.concatenate([turned, np.stack(induced, axis=2)], axis=2)


def _solved(columns: Array, seen: Array) -> Array:
    A = columns.reshape(-1, 9)
    scale = np.linalg.norm(A, axis=0)
    return np.asarray(np.linalg.lstsq(A / scale, seen.ravel(), rcond=None)[0] / scale)


def _shifted(places: Array) -> list[Array]:
    """The places with one coordinate after another a step further."""
    return [places + STEP_M * one.reshape(places.shape) for one in np.eye(places.size)]


def _lags(dwells: Sequence[Dwell]) -> int:
    period = period_s(dwells[0].t_s)
    return int(CORRELATED_S / period) if np.isfinite(period) else 0
