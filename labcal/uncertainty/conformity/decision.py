"""Whether a measured figure keeps its limit, and how likely that is wrong (JCGM 106:2012; ILAC G8:09/2019).

The figure is taken as normal about its measured value, with no knowledge of it from elsewhere (JCGM 106, 7.1); the
limit is exact. U is the expanded uncertainty, k = 2.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import erfc, isfinite, sqrt
from typing import Literal

from labcal.record.specification import RATIO_UNITS, UNITS, Limit, Specification

COVERAGE = 2.0
Result = Literal["pass", "conditional-pass", "conditional-fail", "fail"]


@dataclass(frozen=True, slots=True)
class Measured:
    """A figure as it was measured, in nT, as a ratio or in degrees: `value` with its standard uncertainty `u`.

    `figure` is the limit's name, `quantity` what it is of. What is never negative (a noise, an rms) is not `signed`.
    """

    figure: str
    quantity: str
    value: float
    u: float
    signed: bool = True
    full_scale_nT: float = 1.0  # what a ratio counts from, where the figure is a field


@dataclass(frozen=True, slots=True)
class Judged:
    """A line of the specification: value and U beside the limit, in `unit`; the rule by name, and what it says.

    `risk` is the specific risk of accepting: how probably the true value is beyond the limit. `tur` is the test
    uncertainty ratio, limit / U; None where U is zero.
    """

    quantity: str
    value: float
    U: float
    limit: float
    unit: str
    rule: str
    result: Result
    risk: float
    tur: float | None


def judge(measured: Measured, limit: Limit, specification: Specification) -> Judged:
    """The line that `measured` gives for `limit`, by the rule of `specification`."""
    factor = UNITS[measured.figure][limit.unit]
    if measured.figure == "linearity" and limit.unit in RATIO_UNITS:
        factor *= measured.full_scale_nT
    value, u = measured.value / factor, measured.u / factor
    U, guard = COVERAGE * u, specification.guard
    return Judged(
        quantity=measured.quantity,
        value=value,
        U=U,
        limit=limit.limit,
        unit=limit.unit,
        rule=rule_in_words(specification),
        result=decide(abs(value), limit.limit, guard * U),
        risk=risk_of_accepting(value, u, limit.limit, signed=measured.signed),
        tur=limit.limit / U if U > 0 else None,
    )


def decide(size: float, limit: float, guard: float) -> Result:
    """PASS up to the limit less the guard band, FAIL beyond the limit and the band (ILAC G8:09/2019, 4.2.3).

    Between them the pass or the failure is conditional. Without a band it is the binary rule of 4.2.1.
    """
    if size <= limit:
        return "pass" if size <= limit - guard else "conditional-pass"
    return "fail" if size > limit + guard else "conditional-fail"


def risk_of_accepting(value: float, u: float, limit: float, *, signed: bool = True) -> float:
    """1 − p_c: the probability that the true value lies beyond ± `limit`, or above it where it has no sign.

    p_c is the conformance probability of a normal figure (JCGM 106:2012, 7.3 one-sided, 7.4 two-sided); of an accepted
    one 1 − p_c is the specific consumer's risk. Summed from the tails, so that small risks keep their digits.
    """
    if u == 0:
        return float(abs(value) > limit)
    below = _normal((-limit - value) / u) if signed else 0.0
    return min(1.0, _normal((value - limit) / u) + below)


def _normal(z: float) -> float:
    """Φ(z), the standard normal distribution; far in its lower tail too."""
    return erfc(-z / sqrt(2)) / 2


def rule_in_words(specification: Specification) -> str:
    """The decision rule as the certificate names it."""
    if specification.guard == 0:
        return "simple acceptance, w = 0 (ILAC G8:09/2019, 4.2.1; JCGM 106:2012, 8.2)"
    return f"guard band w = {specification.guard:g} U, k = 2 (ILAC G8:09/2019, 4.2.3; JCGM 106:2012, 8.3)"


def finite(measured: Measured) -> bool:
    """Whether the figure and its uncertainty are known, so that it can be judged."""
    return isfinite(measured.value) and isfinite(measured.u)


WORDS: dict[Result, str] = {
    "pass": "PASS",
    "conditional-pass": "conditional pass",
    "conditional-fail": "conditional fail",
    "fail": "FAIL",
}


def risk_in_words(risk: float) -> str:
    """A risk in per cent, two figures; one that is all but zero or certain as such."""
    if risk < 1e-4:
        return "< 0.01 %"
    return f"{100 * risk:.2g} %" if risk < 0.995 else "> 99 %"
