"""The least of a function of one number between two bounds.

Brent's `fmin` (Algorithms for Minimization without Derivatives, 1973, ch. 5): a parabola through the three best points
where it stays inside and its steps shrink, else a golden section. Its own few lines: scipy.optimize takes a tenth of
the time in which a whole run has to be explained to load.
"""

from __future__ import annotations

from collections.abc import Callable
from math import copysign, sqrt

GOLDEN = 0.5 * (3.0 - sqrt(5.0))
DOUBLE = sqrt(2.2e-16)  # of a value: nearer points have the same function value


def least(f: Callable[[float], float], low: float, high: float, *, within: float, most: int) -> tuple[float, float]:
    """Where `f` is least to about `within`, and its value there, after at most `most` calls."""
    best = second = third = low + GOLDEN * (high - low)
    f_best = f_second = f_third = f(best)
    step = last = 0.0
    for _ in range(most - 1):
        middle, near = 0.5 * (low + high), DOUBLE * abs(best) + within / 3
        if abs(best - middle) <= 2 * near - 0.5 * (high - low):
            break
        to_side = (low if best >= middle else high) - best
        parabola = _to_vertex((best, f_best), (second, f_second), (third, f_third)) if abs(last) > near else None
        if parabola is not None and abs(parabola) < abs(0.5 * last) and low < best + parabola < high:
            step, last = parabola, step
            if min(best + step - low, high - best - step) < 2 * near:
                step = copysign(near, middle - best)
        else:
            step, last = GOLDEN * to_side, to_side
        x = best + max(step, near) if step >= 0 else best + min(step, -near)
        f_x = f(x)
        if f_x <= f_best:
            low, high = (best, high) if x >= best else (low, best)
            (third, f_third), (second, f_second), (best, f_best) = (second, f_second), (best, f_best), (x, f_x)
            continue
        low, high = (x, high) if x < best else (low, x)
        if f_x <= f_second or second == best:
            (third, f_third), (second, f_second) = (second, f_second), (x, f_x)
        elif f_x <= f_third or third in (best, second):
            third, f_third = x, f_x
    return best, f_best


Point = tuple[float, float]


def _to_vertex(best: Point, second: Point, third: Point) -> float | None:
    """How far from the best point the vertex of the parabola through three points lies; None where it is a line."""
    r = (best[0] - second[0]) * (best[1] - third[1])
    q = (best[0] - third[0]) * (best[1] - second[1])
    if q == r:
        return None
    return ((best[0] - second[0]) * r - (best[0] - third[0]) * q) / (2 * (q - r))
