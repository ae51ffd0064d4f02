"""Where a sensor stands in a cage: by the gradient that a coil pair makes when one of its halves is reversed.

A pair whose halves oppose each other (the one towards + is reversed) makes no field at its middle and one that grows
with the distance from there; what a sensor sees of it, in units of what it sees of the same pairs as they should be,
tells its place. Its scales, its axes and its zero drop out: X = D_n⁻¹ D_r, with the responses D (3, 3) to 1 A in each
coil, is the same for any linear sensor. Coils of straight wires (Biot and Savart); round ones have very many corners.
Lengths in m, fields in nT, currents in A.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.geometry import rotation_vector

Array = NDArray[np.float64]
SQUARE, ROUND = 4, 180  # corners
STEP_M = 1e-4  # of the derivatives
STEPS, ARRIVED_M = 30, 1e-7


@dataclass(frozen=True, slots=True, eq=False)
class Coils:
    """Three pairs: `size_m` (3,) side or diameter, `spacing` (3,) distance of the halves over it, `matrix` nT/A at the
    centre; `imbalance` (3,): what the second half makes more than the first, relative.
    """

    size_m: Array
    spacing: Array
    matrix_nT_per_A: Array
    corners: int = SQUARE
    imbalance: Array | None = None

    def field(self, place_m: Array, reversed_: bool) -> Array:
        """Field (3, 3) [nT/A] at `place_m` (3,), columns are the coils, as they should be or with one half reversed."""
        return np.column_stack([self._of_coil(j, place_m, reversed_) for j in range(3)])

    def _of_coil(self, j: int, place_m: Array, reversed_: bool) -> Array:
        column = self.matrix_nT_per_A[:, j]
        turn = from_axis(j, column)
        by = 0.0 if self.imbalance is None else float(self.imbalance[j])
        halves = np.array([1 - by / 2, 1 + by / 2])  # of the field each makes
        places = np.array([turn.T @ place_m, np.zeros(3)])
        half = [_loop(j, self.size_m[j], side * self.spacing[j], self.corners, places) for side in (-0.5, 0.5)]
        one = halves @ np.array([h[1] for h in half])  # at the centre
        there = (halves * [1, -1] if reversed_ else halves) @ np.array([h[0] for h in half])
        return np.asarray(np.linalg.norm(column) * (turn @ there) / np.linalg.norm(one))


@dataclass(frozen=True, slots=True, eq=False)
class CoilResponses:
    """Responses (3, 3) of one sensor, in its own axes and unit per A, columns are the coils.

    `halves`: the coils (their numbers) that were driven with one half reversed too; other columns of `reversed_` are
    not looked at. `u` of an element by the sensor; `u_current` of the current of each column, relative.
    """

    normal: Array
    reversed_: Array
    halves: tuple[int, ...]
    u: float
    u_current: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class LocatedSensor:
    """Where it stands (3,) [m, C], covariance (3, 3) by noise, and `misfit_m`: the rms of what no place explains, as a
    length; 0 where one coil alone was reversed, whose three numbers fit any three coordinates.
    """

    place_m: Array
    covariance: Array
    misfit_m: float


def from_axis(j: int, column: Array) -> Array:
    """The smallest rotation (3, 3) that turns the axis `j` into the direction of `column` (3,)."""
    ideal, true = np.eye(3)[j], column / np.linalg.norm(column)
    across = np.cross(ideal, true)
    size = np.linalg.norm(across)
    if size < 1e-12:
        return np.eye(3) if true[j] > 0 else rotation_vector(np.pi * np.eye(3)[(j + 1) % 3])
    return rotation_vector(across / size * np.arctan2(size, ideal @ true))


def locate(seen: CoilResponses, coils: Coils, start_m: Array | None = None) -> LocatedSensor:
    """The place at which a sensor sees this. Raises ValueError where the responses tell none."""
    if not seen.halves:
        raise ValueError("no half was reversed: the field of a pair as it should be is flat at its middle")
    if np.linalg.cond(seen.normal) > 100:
        raise ValueError("the sensor does not see three coils in three directions")
    X, weight = _ratio(seen)
    place = np.zeros(3) if start_m is None else np.asarray(start_m, dtype=float)
    for _ in range(STEPS):
        left, J = X - _expected(coils, place, seen.halves), _derivative(coils, place, seen.halves)
        step = np.linalg.lstsq(weight @ J, weight @ left, rcond=None)[0]
        place = place + step
        if np.linalg.norm(place) > coils.size_m.max():
            raise ValueError("what the sensor sees fits no place inside the coils: are the halves reversed as asked?")
        if np.linalg.norm(step) < ARRIVED_M:
            break
    else:
        raise ValueError("what the sensor sees fits no place inside the coils: are the halves reversed as asked?")
    J, left = _derivative(coils, place, seen.halves), X - _expected(coils, place, seen.halves)
    misfit = np.sqrt(np.mean(left**2) / np.mean(J**2) / 3) if left.size > 3 else 0.0
    return LocatedSensor(place, np.asarray(np.linalg.inv((weight @ J).T @ (weight @ J))), float(misfit))


def shifts(seen: CoilResponses, coils: Coils, found: LocatedSensor, u_size_m: float, u_imbalance: float) -> Array:
    """How the place moves (4, 3) [m] where all sizes err alike, as one tape measure does, and each coil's balance."""

    def at(changed: Coils) -> Array:
        return locate(seen, changed, found.place_m).place_m - found.place_m

    size = at(replace(coils, size_m=coils.size_m + u_size_m))
    return np.array([size, *(at(replace(coils, imbalance=u_imbalance * one)) for one in np.eye(3))])


def _ratio(seen: CoilResponses) -> tuple[Array, Array]:
    """X by columns of the reversed coils (3 h,), and the root of its inverse covariance (3 h, 3 h).

    dX = D_n⁻¹ (dD_r − dD_n X), every element of D uncertain by the same u: columns are correlated by D_n. A current's
    error scales a row of X (of the coil as it should be) or a column (of the reversed one).
    """
    inverse, picked = np.linalg.inv(seen.normal), list(seen.halves)
    X = inverse @ seen.reversed_[:, picked]
    covariance = seen.u**2 * np.kron(np.eye(len(picked)) + X.T @ X, inverse @ inverse.T)
    rows = np.vstack([np.diag(column) for column in X.T])  # (3 h, 3)
    columns = np.kron(np.eye(len(picked)), np.ones((3, 1))) * X.T.ravel()[:, None]
    covariance += seen.u_current**2 * (rows @ rows.T + columns @ columns.T)
    return X.T.ravel(), np.linalg.inv(np.linalg.cholesky(covariance))


def _expected(coils: Coils, place: Array, halves: tuple[int, ...]) -> Array:
    X = np.linalg.solve(coils.field(place, False), coils.field(place, True))
    return np.asarray(X[:, list(halves)].T.ravel())


def _derivative(coils: Coils, place: Array, halves: tuple[int, ...]) -> Array:
    def along(step: Array) -> Array:
        return (_expected(coils, place + step, halves) - _expected(coils, place - step, halves)) / (2 * STEP_M)

    return np.column_stack([along(STEP_M * direction) for direction in np.eye(3)])


def _loop(axis: int, size_m: float, at: float, corners: int, places: Array) -> Array:
    """Field (n, 3) at `places` (n, 3), in a unit of its own, of a loop about `axis`, `at` sizes from the middle."""
    angles = 2 * np.pi * (np.arange(corners + 1) + 0.5) / corners
    radius = size_m / 2 / (np.cos(np.pi / corners) if corners == SQUARE else np.sqrt(np.sinc(2 / corners)))
    flat = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), np.full(corners + 1, at * size_m)])
    return _wire(np.roll(flat, axis + 1, axis=1), places)


def _wire(corners: Array, places: Array) -> Array:
    """Of straight pieces from corner to corner: Σ (r₁ × r₂) (1/r₁ + 1/r₂) / (r₁ r₂ + r₁·r₂)."""
    r = places[:, None, :] - corners
    size = np.linalg.norm(r, axis=2)
    first, second, one, two = r[:, :-1], r[:, 1:], size[:, :-1], size[:, 1:]
    by = (1 / one + 1 / two) / (one * two + np.einsum("nki,nki->nk", first, second))
    return np.asarray((np.cross(first, second) * by[..., None]).sum(axis=1))
