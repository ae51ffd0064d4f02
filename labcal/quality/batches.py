"""What batches have in common and what each has of its own: a hierarchical estimate with partial pooling.

y_ij ~ N(θ_j, u_ij² + w²), θ_j ~ N(µ, b²): devices i of batches j. w is that of largest restricted likelihood (REML); b
is integrated over its own likelihood, so that intervals know how little a few batches say of it (Gelman et al.,
Bayesian Data Analysis, 5.4).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

Array = NDArray[np.float64]
FEWEST = 3  # batches, below which nothing is pooled
GRID = 200


@dataclass(frozen=True, slots=True)
class Batch:
    """A batch: its devices, the pooled estimate with standard u, and the plain mean of its own devices."""

    name: str
    devices: int
    value: float
    u: float
    own_mean: float


@dataclass(frozen=True, slots=True)
class Pooled:
    """All batches, the one farthest from zero first; `common` µ, `within` w and `between` b as they were found."""

    batches: tuple[Batch, ...]
    common: float
    u_common: float
    within: float
    between: float
    pooled: bool  # False: too few batches, each stands by itself


def pool(groups: Mapping[str, tuple[Sequence[float], Sequence[float]]]) -> Pooled:
    """The estimate of `groups` {batch: (values, standard uncertainties)}; every batch has a device at least."""
    if not groups or any(len(values) == 0 for values, _ in groups.values()):
        raise ValueError("a batch has no device")
    data = [(np.asarray(y, float), np.nan_to_num(np.asarray(u, float))) for y, u in groups.values()]
    within, between = _reml(data)
    many = len(data) >= FEWEST
    value, u, common, u_common = _integrated(data, within, between) if many else _alone(data, within)
    rows = zip(groups, data, value, u, strict=True)
    batches = [Batch(name, len(y), float(v), float(s), float(y.mean())) for name, (y, _), v, s in rows]
    batches.sort(key=lambda batch: -abs(batch.value))
    return Pooled(tuple(batches), common, u_common, within, between if many else 0.0, many)


def _means(data: Sequence[tuple[Array, Array]], within: float) -> tuple[Array, Array, float]:
    """Mean of each batch, its variance given θ, and the log likelihood of what varies within."""
    mean, variance, log = [], [], 0.0
    for y, u in data:
        precision = 1 / (u**2 + within**2 + _TINY)
        middle = float(precision @ y / precision.sum())
        mean.append(middle)
        variance.append(1 / float(precision.sum()))
        log += 0.5 * float(np.log(precision).sum() - np.log(precision.sum()) - precision @ (y - middle) ** 2)
    return np.array(mean), np.array(variance), log


_TINY = 1e-24


def _log_restricted(mean: Array, variance: Array, between: float) -> tuple[float, float, float]:
    """Log likelihood of b with µ integrated out, the estimate of µ and its variance."""
    precision = 1 / (variance + between**2)
    common = float(precision @ mean / precision.sum())
    log = 0.5 * float(np.log(precision).sum() - np.log(precision.sum()) - precision @ (mean - common) ** 2)
    return log, common, 1 / float(precision.sum())


def _reml(data: Sequence[tuple[Array, Array]]) -> tuple[float, float]:
    """Find w and b of largest restricted likelihood."""
    everything = np.concatenate([y for y, _ in data])
    scale = float(everything.std()) or float(max(u.max() for _, u in data)) or 1.0

    def against(x: Array) -> float:
        within, between = scale * np.abs(x)
        mean, variance, log = _means(data, float(within))
        return -(log + _log_restricted(mean, variance, float(between))[0])

    starts = ([0.5, 0.5], [0.05, 0.8])
    found = min((minimize(against, s, method="Nelder-Mead") for s in starts), key=lambda one: float(one.fun))
    within, between = scale * np.abs(found.x)
    return float(within), float(between)


def _integrated(
    data: Sequence[tuple[Array, Array]], within: float, between: float
) -> tuple[Array, Array, float, float]:
    """θ (j,) with u (j,), µ with u: means over b, each by its restricted likelihood under a flat prior."""
    mean, variance, _ = _means(data, within)
    top = 5 * max(between, float(mean.std(ddof=1))) + float(np.sqrt(variance.max()))
    spread = (np.arange(GRID) + 0.5) / GRID * top
    log, common, u2 = map(np.array, zip(*(_log_restricted(mean, variance, float(b)) for b in spread), strict=True))
    weight = np.exp(log - log.max())
    weight /= weight.sum()
    shrink = variance[None, :] / (variance[None, :] + spread[:, None] ** 2)  # towards µ
    theta = shrink * common[:, None] + (1 - shrink) * mean
    var = (1 - shrink) * variance + shrink**2 * u2[:, None]
    value, mu = weight @ theta, float(weight @ common)
    u = np.sqrt(weight @ (var + (theta - value) ** 2))
    return value, u, mu, float(np.sqrt(weight @ (u2 + (common - mu) ** 2)))


def _alone(data: Sequence[tuple[Array, Array]], within: float) -> tuple[Array, Array, float, float]:
    """Each batch by itself: two say nothing of how batches vary."""
    mean, variance, _ = _means(data, within)
    return mean, np.sqrt(variance), float(mean.mean()), float(np.sqrt(variance.sum()) / len(mean))
