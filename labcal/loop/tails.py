"""How often chance gives as much: upper tails of the distributions that the residual's tests need.

Their own few lines: scipy.special takes longer to load than all tests of a run take.
"""

from __future__ import annotations

from math import erfc, exp, inf, lgamma, log, log1p, sqrt

SMALL = 1e-300
SETTLED = 1e-15
ROUNDS = 10_000


def of_normal(z: float) -> float:
    """P(Z > z) of a standard normal number."""
    return 0.5 * erfc(z / sqrt(2))


def of_chi2(freedoms: int, x: float) -> float:
    """P(χ² > x) for an even number of degrees of freedom: e^(−x/2) Σ (x/2)^j / j!, j < freedoms / 2 (DLMF 8.4.10)."""
    half = x / 2
    if half <= 0:
        return 1.0
    if half == inf:
        return 0.0
    return min(1.0, sum(exp(j * log(half) - half - lgamma(j + 1)) for j in range(freedoms // 2)))


def of_f(above: float, below: float, ratio: float) -> float:
    """P(F > ratio) of a ratio of mean squares with `above` over `below` degrees of freedom (DLMF 8.17)."""
    if ratio <= 0:
        return 1.0
    a, b, x = below / 2, above / 2, below / (below + above * ratio)
    if x <= 0:
        return 0.0
    front = exp(a * log(x) + b * log1p(-x) + lgamma(a + b) - lgamma(a) - lgamma(b))
    if x < (a + 1) / (a + b + 2):
        return front * _fraction(a, b, x) / a
    return 1.0 - front * _fraction(b, a, 1 - x) / b


def _fraction(a: float, b: float, x: float) -> float:
    """The continued fraction of the incomplete beta function (DLMF 8.17.22), by Lentz's method."""
    c, d = 1.0, 1 / _off_zero(1 - (a + b) * x / (a + 1))
    found = d
    for m in range(1, ROUNDS):
        even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m))
        odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))
        for term in (even, odd):
            c, d = _off_zero(1 + term / c), 1 / _off_zero(1 + term * d)
            found *= c * d
        if abs(c * d - 1) < SETTLED:
            break
    return found


def _off_zero(value: float) -> float:
    return value if abs(value) > SMALL else SMALL
