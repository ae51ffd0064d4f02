"""x̄ and s charts of a check standard, and those of single values with moving ranges (ISO 7870-2).

Limits are three sigma about the centre of a baseline: by A3, B3 and B4 where sigma is estimated from the baseline, by a
sigma that is stated where it is known.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy  # its parts load where they are used: labcal starts a fifth sooner
from numpy.typing import NDArray

from labcal.quality.western_electric import ALL, broken_rules

Array = NDArray[np.float64]
D2 = 2 / float(np.sqrt(np.pi))  # mean of the range of two normal values, in sigma
D3 = float(np.sqrt(2 - 4 / np.pi))  # its standard deviation
FEWEST = 8  # points of a baseline, below which no limit is drawn
DAYS_DIFFER = 0.01  # level of the test whether means vary by more than single values explain


def c4(n: int) -> float:
    """Mean of the standard deviation of n normal values, in sigma."""
    return float(np.sqrt(2 / (n - 1)) * np.exp(scipy.special.gammaln(n / 2) - scipy.special.gammaln((n - 1) / 2)))


def B3_B4(n: int) -> tuple[float, float]:
    """Limits of standard deviations of n: B3 s̄ and B4 s̄."""
    half = 3 * float(np.sqrt(1 - c4(n) ** 2)) / c4(n)
    return max(0.0, 1 - half), 1 + half


@dataclass(frozen=True, slots=True, eq=False)
class Chart:
    """One quantity over time; every array is (g,), a point each. Where a point is one value, s is a moving range.

    The first `baseline` points make centre and sigma (of one value). `z` is a point less the centre in sigma of that
    point, `broken` the rules that it breaks, `spread_out` whether its s is beyond its limits. `differ` says that means
    of the baseline vary by more than the values within a point explain: limits are then too narrow.
    """

    mean: Array
    spread: Array  # NaN: not known, as the moving range of the first point
    n: NDArray[np.intp]
    baseline: int
    centre: float
    sigma: float
    lower: Array
    upper: Array
    spread_centre: Array
    spread_lower: Array
    spread_upper: Array
    z: Array
    broken: tuple[tuple[int, ...], ...]
    spread_out: NDArray[np.bool_]
    differ: bool = False
    single: bool = False  # the spread is a moving range

    @property
    def out_of_control(self) -> bool:
        """Whether the last point breaks a rule or has an s beyond its limits.

        A moving range does not count: the way back from a point that was out is as long as the way there.
        """
        return bool(self.broken[-1]) or (bool(self.spread_out[-1]) and not self.single)


def control_chart(
    groups: Sequence[Sequence[float]],
    baseline: int,
    *,
    sigma: float | None = None,
    centre: float | None = None,
    between: bool = False,
    rules: Sequence[int] = ALL,
) -> Chart:
    """The chart of `groups`, each the values of one point in order of time; the first `baseline` make the limits.

    `sigma` of one value and `centre` are stated where they are known. `between` takes the spread of points from each
    other instead of that within them. Raises ValueError where the baseline is too short, or nothing in it varies.
    """
    if len(groups) < baseline or baseline < (1 if sigma is not None and centre is not None else FEWEST):
        raise ValueError(f"a baseline has at least {FEWEST} points, and here are {min(len(groups), baseline)}")
    values = [np.asarray(group, dtype=float) for group in groups]
    n = np.array([len(group) for group in values])
    mean = np.array([group.mean() for group in values])
    single = between or bool((n[:baseline] == 1).any())
    spread = _moving_range(mean) if single else np.array([_spread_within(group) for group in values])
    found = _sigma(spread[:baseline], n[:baseline], single=single) if sigma is None else sigma
    if not found > 0:
        raise ValueError("the baseline does not vary: a spread of zero has no limits")
    of_point = found * np.ones(len(n)) if between else found / np.sqrt(n)
    middle = float(np.average(mean[:baseline], weights=n[:baseline])) if centre is None else centre
    z = (mean - middle) / of_point
    typical, low, high = _spread_limits(of_point if single else np.full(len(n), found), n, single=single)
    out = np.isfinite(spread) & ((spread > high) | (spread < low))
    differ = not single and _differ(values[:baseline])
    limits = (middle - 3 * of_point, middle + 3 * of_point)
    return Chart(
        mean, spread, n, baseline, middle, float(found), *limits, typical, low, high, z,
        broken_rules(z, rules), out, differ, single,
    )  # fmt: skip


def spread_false_alarm_rate(n: int) -> float:
    """How often s of n values (n = 1: the moving range) is beyond its limits though nothing changed."""
    if n == 1:
        return float(2 * scipy.special.ndtr(-(D2 + 3 * D3) / np.sqrt(2)))
    low, high = (bound * c4(n) for bound in B3_B4(n))
    return float(scipy.special.chdtr(n - 1, (n - 1) * low**2) + scipy.special.chdtrc(n - 1, (n - 1) * high**2))


def _spread_within(group: Array) -> float:
    """Its standard deviation; NaN of one value, as of a point whose repeats are not all there yet."""
    return float(group.std(ddof=1)) if len(group) > 1 else float("nan")


def _moving_range(mean: Array) -> Array:
    return np.concatenate([[np.nan], np.abs(np.diff(mean))])


def _sigma(spread: Array, n: NDArray[np.intp], *, single: bool) -> float:
    """Sigma of one value from the spreads of a baseline; of one point where `single`."""
    if single:
        return float(np.nanmean(spread)) / D2 * float(np.sqrt(np.median(n)))
    constants = np.array([c4(int(m)) for m in n])
    return float(np.mean(spread / constants))


def _spread_limits(sigma: Array, n: NDArray[np.intp], *, single: bool) -> tuple[Array, Array, Array]:
    """Centre, lower and upper limit of each point's spread."""
    if single:
        return D2 * sigma, np.zeros(len(sigma)), (D2 + 3 * D3) * sigma
    of = np.maximum(n, 2)  # a point of one value has no spread to be judged
    typical = sigma * np.array([c4(int(m)) for m in of])
    B = np.array([B3_B4(int(m)) for m in of])
    return typical, B[:, 0] * typical, B[:, 1] * typical


def _differ(groups: Sequence[Array]) -> bool:
    """Whether the means of the groups vary by more than what is within them (F test of one-way ANOVA)."""
    everything = np.concatenate(groups)
    within = float(sum(((group - group.mean()) ** 2).sum() for group in groups))
    among = float(((everything - everything.mean()) ** 2).sum()) - within
    dof = len(groups) - 1, len(everything) - len(groups)
    return bool(scipy.special.fdtrc(*dof, among / dof[0] / (within / dof[1])) < DAYS_DIFFER)
