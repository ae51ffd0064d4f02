"""Propagation of distributions (JCGM 101:2008), in plain numpy: no derivative, no formula of labcal's.

What is known of a calibration is drawn source by source; each draw is put through the measurement's own equations.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation
from scipy.stats import norm

DRAWS = 40_000


@dataclass(frozen=True)
class Drawn:
    """Draws of K (n, 3, 3), k (n, 3), the couplings (n, 3) of a current, and of one reading's noise (n, 3)."""

    K: np.ndarray
    k: np.ndarray
    coupling: np.ndarray
    noise: np.ndarray


def draws(theta: np.ndarray, sources: object, reading_nT: float, seed: int = 1, n: int = DRAWS) -> Drawn:
    """Each declared error and the reading's declared noise normal; the fit's noise Student's t, as its level is found.

    A turn is a turn, by whatever angle: what of an error is one goes through the rotation, not through its tangent.
    """
    draw = np.random.default_rng(seed)
    dof = sources.noise.dof
    normal = draw.standard_normal((n, len(sources.declared)))
    of_fit = draw.multivariate_normal(np.zeros(len(theta)), sources.noise.covariance, n, method="eigh")
    level = np.sqrt(dof / draw.chisquare(dof, n))[:, None]
    tangents = _tangents(theta)
    shifts = np.array([one.shift for one in sources.declared])
    angles = np.linalg.lstsq(tangents[:, :9].T, shifts[:, :9].T, rcond=None)[0].T
    angles[[" about " not in one.source for one in sources.declared]] = 0.0
    turns = Rotation.from_rotvec(normal @ angles).as_matrix()
    found = theta + normal @ (shifts - angles @ tangents) + of_fit * level
    noise = reading_nT * draw.standard_normal((n, 3))
    K, k, coupling = turns @ found[:, :9].reshape(n, 3, 3), *(found[:, i : i + 3, None] for i in (9, 12))
    return Drawn(K, (turns @ k)[:, :, 0], (turns @ coupling)[:, :, 0], noise)


def _tangents(theta: np.ndarray) -> np.ndarray:
    """What a small turn about each axis does to K, k and coupling (3, p), per radian."""
    columns = np.column_stack([theta[:9].reshape(3, 3), theta[9:12], theta[12:15]])
    turned = [np.cross(axis, columns, axisb=0, axisc=0) for axis in np.eye(3)]
    return np.array([np.concatenate([t[:, :3].ravel(), t[:, 3], t[:, 4]]) for t in turned])


def field(d: Drawn, reading: np.ndarray, current_A: float) -> np.ndarray:
    """b (n, 3) of one reading beside a current so far from its reference value."""
    return np.einsum("nij,nj->ni", d.K, reading + d.noise) - d.k - current_A * d.coupling


def figures(d: Drawn) -> np.ndarray:
    """(n, 9): scale factors, zero readings, angles between the sensitive axes less 90°, by the inverse's rows."""
    inverse = np.linalg.inv(d.K)
    length = np.sqrt(np.sum(inverse**2, axis=2))
    zero = np.linalg.solve(d.K, d.k[:, :, None])[:, :, 0]
    angles = [
        90 - np.degrees(np.arccos(np.sum(inverse[:, a] * inverse[:, b], axis=1) / length[:, a] / length[:, b]))
        for a, b in ((0, 1), (1, 2), (2, 0))
    ]
    return np.column_stack([1 / length, zero, *angles])


def tolerance(u: float, digits: int) -> float:
    """δ = ½ 10^l, with u = c 10^l and c an integer of so many digits that mean something (JCGM 101, 7.9.2)."""
    return float(0.5 * 10.0 ** (np.floor(np.log10(u)) - (digits - 1)))


def ends(values: np.ndarray, probability: float) -> np.ndarray:
    """The ends (2,) of the interval that holds that much of the draws, as much missing on either side."""
    return np.quantile(values, [(1 - probability) / 2, (1 + probability) / 2])


def spread_of_ends(n: int, probability: float) -> float:
    """Standard deviation of an end by n normal draws, in units of u: sqrt(p (1 − p) / n) over the density there."""
    p = (1 - probability) / 2
    return float(np.sqrt(p * (1 - p) / n) / norm.pdf(norm.ppf(p)))
