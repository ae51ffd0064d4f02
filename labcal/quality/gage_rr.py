"""Gage R&R: a crossed ANOVA with random factors, as DUT × operator × mounting (AIAG MSA; ISO 22514-7).

Components come from expected mean squares; their intervals are generalised confidence intervals (Hamada and Weerahandi,
J. Quality Technology 32 (2000) 241): mean squares redrawn from their χ² distributions.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.special import fdtrc

Array = NDArray[np.float64]
Term = tuple[int, ...]  # the factors of a term, by their place
ERROR = "repeatability"
POOLED = 0.25  # an interaction of a larger p goes into the repeatability (AIAG)
CATEGORIES = 1.41  # √2: parts that the gage tells apart, in units of its own spread
LARGEST = 1e100  # of a value
DRAWS = 10_000
SEED = 20


@dataclass(frozen=True, slots=True)
class Line:
    """One line of the table: degrees of freedom, sum of squares, mean square, F and p (None: nothing to test by)."""

    source: str
    dof: int
    ss: float
    ms: float
    F: float | None
    p: float | None
    pooled: bool = False


@dataclass(frozen=True, slots=True)
class Component:
    """A standard deviation, its 95 % interval, and its share of the total variance in percent."""

    source: str
    sd: float
    interval: tuple[float, float]
    percent: float  # of the total standard deviation: 100 sd / total
    percent_interval: tuple[float, float]


@dataclass(frozen=True, slots=True)
class GageRR:
    """What a study says of the gage: lines of its table, components, %R&R and distinct categories, each with 95 %."""

    lines: tuple[Line, ...]
    components: tuple[Component, ...]  # each term, then repeatability, reproducibility, gage R&R, part, total
    percent_rr: float
    percent_rr_interval: tuple[float, float]
    categories: int
    categories_interval: tuple[int, int]
    percent_tolerance: float | None = None  # 6 sd of the gage over the tolerance's width


def gage_rr(values: Array, factors: Sequence[str], *, tolerance: float | None = None) -> GageRR:
    """Study of `values`, an axis for each of `factors`, the parts' first, and the last axis for repeats.

    `tolerance` is the width of the tolerance, in the unit of the values. Raises ValueError for fewer than two levels of
    a factor, no repeats to take the repeatability from, or values that do not vary.
    """
    _check(values, factors)
    squares = _sums_of_squares(values)
    if not sum(ss for ss, _ in squares.values()) > 0:
        raise ValueError("all values are the same: there is nothing to take apart")
    kept = _pool(squares)
    dof = np.array([d for _, d in kept.values()], dtype=float)
    ms = np.array([ss for ss, _ in kept.values()]) / dof
    terms, expected = list(kept), _expected(list(kept), values.shape)
    drawn = ms * dof / np.random.default_rng(SEED).chisquare(dof, (DRAWS, len(dof)))
    apart = np.linalg.inv(expected).T
    of = [np.maximum(rows @ apart, 0.0) for rows in (ms[None, :], drawn)]
    return _result(_lines(squares, kept, factors), terms, factors, of[0], of[1], tolerance)


def _check(values: Array, factors: Sequence[str]) -> None:
    if values.ndim != len(factors) + 1:
        raise ValueError(f"{len(factors)} factors and repeats need {len(factors) + 1} axes")
    for name, levels in zip(factors, values.shape, strict=False):
        if levels < 2:
            raise ValueError(f"{name}: a study has at least two, and here is {levels}")
    if values.shape[-1] < 2 and len(factors) < 2:
        raise ValueError("nothing was repeated: there is no repeatability to be found")
    if not np.isfinite(values).all():
        raise ValueError("a value is missing")
    if np.abs(values).max() > LARGEST:
        raise ValueError(f"a value is beyond {LARGEST:g}: its square is no number")


def _sums_of_squares(values: Array) -> dict[Term, tuple[float, int]]:
    """Sum of squares and degrees of freedom of each term; () is the error: without repeats the last term."""
    k, shape = values.ndim - 1, values.shape
    found = dict[Term, tuple[float, int]]()
    for order in range(1, k + 1):
        for term in combinations(range(k), order):
            ss = values.size / _levels(term, shape) * float((_effect(values, term) ** 2).sum())
            found[term] = ss, int(np.prod([shape[i] - 1 for i in term]))
    total = float(((values - values.mean()) ** 2).sum())
    if shape[-1] < 2:
        found[()] = found.pop(tuple(range(k)))
    else:
        ss, dof = (sum(column) for column in zip(*found.values(), strict=True))
        found[()] = max(total - ss, 0.0), values.size - 1 - int(dof)
    return found


def _effect(values: Array, term: Term) -> Array:
    """What the means of the cells of `term` have beyond those of every part of it."""
    total = np.zeros([values.shape[i] for i in term])
    for order in range(len(term) + 1):
        for part in combinations(term, order):
            others = tuple(i for i in range(values.ndim) if i not in part)
            shape = [values.shape[i] if i in part else 1 for i in term]
            total = total + (-1) ** (len(term) - order) * values.mean(axis=others).reshape(shape)
    return total


def _levels(term: Term, shape: Sequence[int]) -> int:
    return int(np.prod([shape[i] for i in term]))


def _pool(squares: Mapping[Term, tuple[float, int]]) -> dict[Term, tuple[float, int]]:
    """The terms that stay: an interaction that the error explains goes into it, the largest first."""
    kept = dict(squares)
    for term in sorted((t for t in squares if len(t) > 1), key=len, reverse=True):
        (ss, dof), (error, error_dof) = kept[term], kept[()]
        part_of_kept = any(set(term) < set(other) for other in kept)
        if not part_of_kept and _p(ss / dof, dof, error / error_dof, error_dof) > POOLED:
            kept[()] = error + ss, error_dof + dof
            del kept[term]
    return kept


def _p(ms: float, dof: int, by: float, by_dof: int) -> float:
    return float(fdtrc(dof, by_dof, ms / by)) if by > 0 else 0.0


def _expected(terms: Sequence[Term], shape: Sequence[int]) -> Array:
    """Mean squares of the terms from their components, (m, m): all factors are random, all cells are full."""
    size = int(np.prod(shape))
    return np.array(
        [[1.0 if not s else size / _levels(s, shape) if set(t) <= set(s) and t else 0.0 for s in terms] for t in terms]
    )


def _lines(
    squares: Mapping[Term, tuple[float, int]], kept: Mapping[Term, tuple[float, int]], factors: Sequence[str]
) -> tuple[Line, ...]:
    lines = []
    for term, (ss, dof) in squares.items():
        by = _denominator(term, squares if term not in kept else kept)
        F = None if by is None or not by[0] > 0 else ss / dof / by[0]
        p = None if F is None or by is None else float(fdtrc(dof, by[1], F))
        lines.append(Line(name(term, factors), dof, ss, ss / dof, F, p, term not in kept))
    if len(kept) < len(squares):
        ss, dof = kept[()]
        lines.append(Line(f"{ERROR} with what was pooled", dof, ss, ss / dof, None, None))
    return tuple(lines)


def _denominator(term: Term, terms: Mapping[Term, tuple[float, int]]) -> tuple[float, int] | None:
    """Mean square and degrees of freedom that a term is tested by; None where no single one has its expectation."""
    if not term:
        return None
    above = [other for other in terms if set(term) < set(other)]
    smallest = [other for other in above if len(other) == len(term) + 1]
    if len(smallest) > 1:
        return None
    ss, dof = terms[smallest[0] if smallest else ()]
    return ss / dof, dof


def name(term: Term, factors: Sequence[str]) -> str:
    """A term in words: "DUT × operator"."""
    return " × ".join(factors[i] for i in term) if term else ERROR


def _result(
    lines: tuple[Line, ...], terms: list[Term], factors: Sequence[str], found: Array, drawn: Array,
    tolerance: float | None,
) -> GageRR:  # fmt: skip
    part, error = terms.index((0,)), terms.index(())
    rest = [i for i in range(len(terms)) if i not in (part, error)]
    groups = {name(terms[i], factors): [i] for i in (*rest, error)}
    groups |= {
        "reproducibility": rest,
        "gage R&R": [*rest, error],
        factors[0]: [part],
        "total": list(range(len(terms))),
    }
    sd, draws = ({g: np.sqrt(v[:, at].sum(axis=1)) for g, at in groups.items()} for v in (found, drawn))
    components = tuple(_component(g, sd[g][0], draws[g], sd["total"][0], draws["total"]) for g in groups)
    gage = next(c for c in components if c.source == "gage R&R")
    distinct = [np.floor(_ratio(CATEGORIES * one[factors[0]], one["gage R&R"])) for one in (sd, draws)]
    low, high = np.quantile(distinct[1], [0.025, 0.975])
    width = None if tolerance is None else 100 * 6 * gage.sd / tolerance
    between = (max(1, int(low)), max(1, int(high)))
    return GageRR(lines, components, gage.percent, gage.percent_interval, max(1, int(distinct[0][0])), between, width)


def _component(source: str, sd: float, drawn: Array, total: float, total_drawn: Array) -> Component:
    share = 100 * _ratio(drawn, total_drawn)
    return Component(source, float(sd), _middle(drawn), float(100 * sd / total), _middle(share))


def _middle(drawn: Array) -> tuple[float, float]:
    low, high = np.quantile(drawn, [0.025, 0.975])
    return float(low), float(high)


def _ratio(a: Array, b: Array) -> Array:
    """Divide a by b; what is divided by nothing is as large as a number here needs to be."""
    return np.asarray(np.minimum(a / np.maximum(b, 1e-300), 1e6))
