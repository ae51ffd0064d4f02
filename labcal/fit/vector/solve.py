"""Levenberg-Marquardt on the system of residuals, with a robust loss; the cost is linear in the samples."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import Observations
from labcal.fit.vector.system import Noise, blocks, evaluate, normal

Array = NDArray[np.float64]
ParameterisationName = Literal["affine", "symmetric", "gain-offset", "offset"]
# Square root of the 99.9 % point of chi-squared with 1, 2 and 3 degrees of freedom: where the weight begins to fall.
HUBER_THRESHOLD = np.array([np.nan, 3.2905, 3.7169, 4.0331])


@dataclass(frozen=True, slots=True, eq=False)
class Parameterisation:
    """Which maps are allowed: the twelve scaled parameters are `fixed + basis @ q`."""

    name: ParameterisationName
    fixed: Array  # (12,)
    basis: Array  # (12, q)

    def nearest(self, theta: Array) -> Array:
        """The coordinates q of the allowed map nearest to `theta` (12,)."""
        return np.asarray(np.linalg.lstsq(self.basis, theta - self.fixed, rcond=None)[0])


def parameterise(name: ParameterisationName, nominal: float) -> Parameterisation:
    """Affine (12 parameters), symmetric K (9), one gain and k (4), or k alone (3).

    `nominal` is the scaled gain of a perfect sensor [nT per scale unit].
    """
    fixed, eye = np.zeros(12), np.eye(12)
    if name == "affine":
        return Parameterisation(name, fixed, eye)
    if name == "symmetric":
        pairs = [eye[:, 3 * a + b] + (eye[:, 3 * b + a] if a != b else 0.0) for a in range(3) for b in range(a, 3)]
        return Parameterisation(name, fixed, np.column_stack([*pairs, eye[:, 9:]]))
    gain = eye[:, [0, 4, 8]].sum(axis=1)
    if name == "gain-offset":
        return Parameterisation(name, fixed, np.column_stack([gain, eye[:, 9:]]))
    return Parameterisation(name, gain * nominal, eye[:, 9:])


@dataclass(frozen=True, slots=True)
class Loss:
    """The loss of a row by its normalised length d: ½ d² up to the threshold, then falling influence.

    `reach` is where the influence ends, in thresholds (Hampel's two-part redescender); infinite is Huber's loss. With
    the threshold at 99.9 % and a reach of 4 the efficiency at the normal distribution is 0.997 (one number a row).
    """

    threshold: float = 1.0  # in units of HUBER_THRESHOLD
    reach: float = 4.0

    def weights_and_losses(self, cost: Array, kind: NDArray[np.int8]) -> tuple[Array, Array]:
        """Weight and loss of each row (n,) for `cost` = d² and its kind."""
        if np.isinf(self.threshold):
            return np.ones(len(cost)), cost / 2
        a = self.threshold * HUBER_THRESHOLD[kind]
        d = np.sqrt(cost)
        if np.isinf(self.reach):
            return np.minimum(1.0, a / np.maximum(d, 1e-300)), np.where(d <= a, cost / 2, a * d - a**2 / 2)
        b = self.reach * a
        inner = np.clip(d, a, b)
        fall = a * (b * (inner - a) - (inner**2 - a**2) / 2) / (b - a)
        weight = np.where(d <= a, 1.0, a * (b - inner) / ((b - a) * np.maximum(d, 1e-300)))
        return weight, np.where(d <= a, cost / 2, a**2 / 2 + fall)


TOLERANCE = 1e-8  # of a step's squared length in standard uncertainties
SLACK = 0.1  # rise of the loss at which the equations still decide: unbiased, they are not quite its gradient
LEAST_SQUARES = Loss(threshold=np.inf, reach=np.inf)
ROBUST = Loss()


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """Where the loss is least, and its curvature there."""

    theta: Array  # (12,) K · scale row by row, then k [nT]
    phase: Array  # (groups,) [rad]
    normal: Array  # (q + groups)² of the form's coordinates and the phases, weights included
    loss: float
    converged: bool
    cost: Array  # (n,) rᵀ C⁻¹ r of each row
    weight: Array  # (n,)


def solve(
    seen: Observations,
    noise: Noise,
    parameterisation: Parameterisation,
    theta: Array,
    phase: Array,
    loss: Loss = ROBUST,
    *,
    iterations: int = 60,
    correction: Array | float = 0.0,
) -> Solution:
    """Minimise the loss from a start; `correction` (n, 3) nT is subtracted from K m − k (effects)."""
    phases = len(phase)
    B = np.zeros((12 + phases, parameterisation.basis.shape[1] + phases))
    B[:12, : parameterisation.basis.shape[1]], B[12:, parameterisation.basis.shape[1] :] = (
        parameterisation.basis,
        np.eye(phases),
    )
    y = np.concatenate([parameterisation.nearest(theta), phase])
    here = _assemble(seen, noise, parameterisation, y, B, loss, correction)
    damping, converged = 1e-8, False
    for _ in range(iterations):
        step = _step(here.normal, here.gradient, damping)
        there = _assemble(seen, noise, parameterisation, y + step, B, loss, correction)
        expected = float(step @ here.normal @ step)
        unit = max(1.0, here.loss / len(seen))
        if there.loss <= here.loss + max(expected, SLACK * unit):
            y, here, damping = y + step, there, max(damping / 10, 1e-12)
            if expected < TOLERANCE * unit:
                converged = True
                break
        else:
            damping = max(damping, 1e-6) * 10
            if damping > 1e8:
                break
    theta, phase = _split(parameterisation, y)
    return Solution(theta, phase, here.normal, here.loss, converged, here.cost, here.weight)


@dataclass(frozen=True, slots=True, eq=False)
class _Assembled:
    normal: Array
    gradient: Array
    loss: float
    cost: Array
    weight: Array


def _assemble(
    seen: Observations,
    noise: Noise,
    parameterisation: Parameterisation,
    y: Array,
    B: Array,
    loss: Loss,
    correction: Array | float,
) -> _Assembled:
    theta, phase = _split(parameterisation, y)
    N, g, total = np.zeros((len(B), len(B))), np.zeros(len(B)), 0.0
    cost, weight = np.empty(len(seen)), np.empty(len(seen))
    for rows, part, part_noise in blocks(seen, noise):
        offset = correction[rows] if isinstance(correction, np.ndarray) else correction
        at = evaluate(part, part_noise, theta, phase, offset)
        weight[rows], losses = loss.weights_and_losses(at.cost, part.kind)
        cost[rows] = at.cost
        total += float(losses.sum())
        dN, dg = normal(part, at, weight[rows])
        N, g = N + dN, g + dg
    return _Assembled(B.T @ N @ B, B.T @ g, total, cost, weight)


def _split(parameterisation: Parameterisation, y: Array) -> tuple[Array, Array]:
    q = parameterisation.basis.shape[1]
    return parameterisation.fixed + parameterisation.basis @ y[:q], y[q:]


def _step(N: Array, g: Array, damping: float) -> Array:
    """Marquardt's step: the diagonal is raised by `damping`; directions without information do not move."""
    if not (np.isfinite(N).all() and np.isfinite(g).all()):
        raise np.linalg.LinAlgError("the normal equations are not finite")
    scale = np.sqrt(np.maximum(np.diag(N), 1e-300))
    A = N / np.outer(scale, scale) + damping * np.eye(len(N))
    return np.asarray(-np.linalg.lstsq(A, g / scale, rcond=1e-13)[0] / scale)
