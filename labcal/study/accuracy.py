"""How well a map gives a field: its expanded uncertainty and, where the truth is known, its error, at the worst place.

The places are a field of one magnitude B along 26 directions of the body, those of a cube's faces, edges and corners.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from labcal.model import AffineMap
from labcal.model.affine import jacobian

Array = NDArray[np.float64]
COVERAGE = 2.0  # k of an expanded uncertainty


def directions() -> Array:
    """Unit vectors (26, 3)."""
    corners = np.array([c for c in itertools.product((-1.0, 0.0, 1.0), repeat=3) if any(c)])
    return np.asarray(corners / np.linalg.norm(corners, axis=1)[:, None])


def sensitivities(affine: AffineMap, field_nT: float) -> Array:
    """d(turn of the field's direction, rad) / d(K row by row, k), (26, 2, 12): across each direction two ways."""
    ways = directions()
    reading = np.linalg.solve(affine.K, (field_nT * ways + affine.k_nT).T).T
    return np.asarray(_across(ways) @ jacobian(reading) / field_nT)


def direction_U_deg(sensitivity: Array, covariance: Array) -> Array:
    """U (k = 2) of the field's direction where it is worst, (m,) deg, for the covariances (m, 12, 12) of a map.

    Of the two ways across a direction that in which it is most uncertain. An infinite covariance gives infinity.
    """
    spread = np.einsum("nai,mij,nbj->mnab", sensitivity, covariance, sensitivity, optimize=True)
    a, b, c = spread[..., 0, 0], spread[..., 0, 1], spread[..., 1, 1]
    largest = (a + c) / 2 + np.hypot((a - c) / 2, b)
    return np.asarray(np.degrees(COVERAGE * np.sqrt(np.max(largest, axis=1))))


def errors(found: AffineMap, truth: AffineMap, field_nT: float) -> tuple[float, float]:
    """The largest error of the field's direction [deg] and of its magnitude [nT], where `truth` gave the readings."""
    ways = directions()
    reading = np.linalg.solve(truth.K, (field_nT * ways + truth.k_nT).T).T
    field = found.apply(reading)
    size = np.linalg.norm(field, axis=1)
    sine = np.linalg.norm(np.cross(ways, field), axis=1)
    turned = np.degrees(np.arctan2(sine, np.sum(ways * field, axis=1)))
    return float(turned.max()), float(np.abs(size - field_nT).max())


def _across(ways: Array) -> Array:
    """Two unit vectors across each direction and across each other, (n, 2, 3)."""
    near = np.eye(3)[np.argmin(np.abs(ways), axis=1)]
    first = np.cross(ways, near)
    first /= np.linalg.norm(first, axis=1)[:, None]
    return np.stack([first, np.cross(ways, first)], axis=1)
