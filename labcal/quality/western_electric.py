"""The Western Electric rules on a control chart, and how often each gives a false alarm.

Western Electric, Statistical Quality Control Handbook (1956); run lengths by the Markov chain of Champ and Woodall,
Technometrics 29 (1987) 393. All assumes normal, independent points and limits that are known.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache
from itertools import pairwise

import numpy as np
import scipy  # its parts load where they are used: labcal starts a fifth sooner
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
RULES = {
    1: "a point beyond 3 sigma",
    2: "two of three points beyond 2 sigma on one side",
    3: "four of five points beyond 1 sigma on one side",
    4: "eight points in a row on one side of the centre",
}
ALL = tuple(RULES)
ZONES = (-np.inf, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, np.inf)
MIDDLES = (-3.5, -2.5, -1.5, -0.5, 0.5, 1.5, 2.5, 3.5)
LONGEST = 8  # points that a rule looks back, the last one counted


def broken_rules(z: ArrayLike, rules: Iterable[int] = ALL) -> tuple[tuple[int, ...], ...]:
    """The rules that each point breaks; `z` (n,) are points less the centre, in sigma of a point, in order of time.

    The point that completes a pattern breaks the rule: a point inside its zone never does.
    """
    points = np.asarray(z, dtype=float)
    return tuple(tuple(r for r in rules if breaks(r, points[: i + 1])) for i in range(len(points)))


def breaks(rule: int, z: Sequence[float] | Array) -> bool:
    """Whether the last of the points `z` breaks `rule`."""
    last, side = z[-1], np.sign(z[-1])
    if rule == 1:
        return bool(abs(last) > 3)
    beyond, of, need = {2: (2.0, 3, 2), 3: (1.0, 5, 4), 4: (0.0, 8, 8)}[rule]
    seen = [side * value > beyond for value in z[-of:]]
    return bool(seen[-1]) and sum(map(bool, seen)) >= need


def average_run_length(rules: Iterable[int] = ALL) -> float:
    """Points until the first false alarm on the mean, of a process that never changes (ARL₀)."""
    return _run_length(tuple(sorted(set(rules))))


@cache
def _run_length(rules: tuple[int, ...]) -> float:
    """The mean number of steps to absorption from the empty history."""
    chance = np.diff(scipy.special.ndtr(ZONES))
    start: tuple[float, ...] = ()
    number, todo, steps = {start: 0}, [start], list[tuple[int, int, float]]()
    while todo:
        history = todo.pop()
        for middle, p in zip(MIDDLES, chance, strict=True):
            if any(breaks(rule, (*history, middle)) for rule in rules):
                continue
            after = _what_counts((*history, middle), rules)
            if after not in number:
                number[after] = len(number)
                todo.append(after)
            steps.append((number[history], number[after], float(p)))
    stay = np.zeros((len(number), len(number)))
    for origin, after_at, p in steps:
        stay[origin, after_at] += p
    return float(np.linalg.solve(np.eye(len(number)) - stay, np.ones(len(number)))[0])


def _what_counts(history: tuple[float, ...], rules: tuple[int, ...]) -> tuple[float, ...]:
    """The history as far as a rule can still look at it: a point is as far out as some rule asks at its age."""
    kept = list[float]()
    for age, value in enumerate(reversed(history[-LONGEST + 1 :]), 1):
        zones = [bound for rule, reach, bound in ((2, 2, 2.0), (3, 4, 1.0)) if rule in rules and age <= reach]
        zones += [0.0] if 4 in rules and _one_side(history[-age:]) else []
        beyond = max((bound for bound in zones if abs(value) > bound), default=None)
        kept.append(0.0 if beyond is None else float(np.sign(value)) * (beyond + 0.5))
    while kept and kept[-1] == 0.0:
        kept.pop()
    return tuple(reversed(kept))


def _one_side(values: Sequence[float]) -> bool:
    return all(a * b > 0 for a, b in pairwise(values))
