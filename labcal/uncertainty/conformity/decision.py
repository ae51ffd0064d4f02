"""Whether a measured figure keeps its limit, and how likely that is wrong (JCGM 106:2012; ILAC G8:09/2019).

The figure is taken as normal about its measured value, with no knowledge of it from elsewhere (JCGM 106, 7.1), as
Student's t where its uncertainty has few degrees of freedom (JCGM 101, 6.4.9.7); the limit is exact. U is the expanded
uncertainty of 95.45 %, k = 2 where there are many.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import erfc, inf, isfinite, sqrt
from typing import Literal

from labcal.record.specification import RATIO_UNITS, UNITS, Limit, Specification
from labcal.uncertainty.budget import coverage_factor

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
    dof: float = inf  # of u


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
    U, guard = coverage_of(measured.dof) * u, specification.guard
    return Judged(
        quantity=measured.quantity,
        value=value,
        U=U,
        limit=limit.limit,
        unit=limit.unit,
        rule=rule_in_words(specification),
        result=decide(abs(value), limit.limit, guard * U),
        risk=risk_of_accepting(value, u, limit.limit, signed=measured.signed, dof=measured.dof),
        tur=limit.limit / U if U > 0 else None,
    )


def decide(size: float, limit: float, guard: float) -> Result:
    """PASS up to the limit less the guard band, FAIL beyond the limit and the band (ILAC G8:09/2019, 4.2.3).

    Between them the pass or the failure is conditional. Without a band it is the binary rule of 4.2.1.
    """
    if size <= limit:
        return "pass" if size <= limit - guard else "conditional-pass"
    return "fail" if size > limit + guard else "conditional-fail"


def coverage_of(dof: float) -> float:
    """The coverage factor of U: 2, or Student's t for the same 95.45 % of few degrees of freedom."""
    return coverage_factor(dof) if isfinite(dof) else COVERAGE


def risk_of_accepting(value: float, u: float, limit: float, *, signed: bool = True, dof: float = inf) -> float:
    """1 − p_c: the probability that the true value lies beyond ± `limit`, or above it where it has no sign.

    p_c is the conformance probability of a normal figure (JCGM 106:2012, 7.3 one-sided, 7.4 two-sided); of an accepted
    one 1 − p_c is the specific consumer's risk. Summed from the tails, so that small risks keep their digits.
    """
    if u == 0:
        return float(abs(value) > limit)
    below = _below((-limit - value) / u, dof) if signed else 0.0
    return min(1.0, _below((value - limit) / u, dof) + below)


def _below(z: float, dof: float) -> float:
    """The standard normal distribution at z, or Student's t of few degrees of freedom; far in the lower tail too."""
    if not isfinite(dof):
        return erfc(-z / sqrt(2)) / 2
    from scipy.special import stdtr

    return float(stdtr(dof, z))


def rule_in_words(specification: Specification) -> str:
    """The decision rule as the certificate names it."""
    if specification.guard == 0:
        return "simple acceptance, w = 0 (ILAC G8:09/2019, 4.2.1; JCGM 106:2012, 8.2)"
    return f"guard band w = {specification.guard:g} U (ILAC G8:09/2019, 4.2.3; JCGM 106:2012, 8.3)"


def finite(measured: Measured) -> bool:
    """Whether the figure and its uncertainty are known, so that it can be judged."""
    return isfinite(measured.value) and isfinite(measured.u)


WORDS: dict[Result, str] = {
    "pass": "PASS",
    "conditional-pass": "conditional pass",
    "conditional-fail": "conditional fail",
    "fail": "FAIL",
}


def ratio_in_words(ratio: float | None) -> str:
    """A test uncertainty ratio with a decimal, below one with two figures; a dash where there is none."""
    if ratio is None:
        return "–"
    if ratio > 1000:
        return "> 1000"
    return f"{ratio:.1f}" if ratio >= 1 else f"{ratio:.2g}"


def risk_in_words(risk: float) -> str:
    """A risk in per cent, two figures; one that is all but zero or certain as such."""
    if risk < 1e-4:
        return "< 0.01 %"
    return f"{100 * risk:.2g} %" if risk < 0.995 else "> 99 %"
