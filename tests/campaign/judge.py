"""What a trial showed, judged from the lab's own truth and from what labcal said, each with its time."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

ZERO_A = 0.005  # below it a coil is at zero; a supply at set-point zero lets a tenth of it through
FLOWS_A = 0.02  # above it a sentence that says zero is false
SAME_A = 0.0015  # the coarsest step of a supply here, and a half
READ_LATE_S = 0.3  # between a sentence and when the campaign has read it
OF_ONE = re.compile(r"coil ([xyz]) [+-]?[\d.]+ A, zero")
OF_ALL = re.compile(r"coils (?:are |stay |stayed |were )?at zero", re.IGNORECASE)
DENIED = re.compile(r"not at zero|not confirmed|by the supply's word only|unless|until", re.IGNORECASE)

Flow = Sequence[Sequence[float]]  # (from when [s], from what [A], to what [A]), an exponential each
Orders = Sequence[Sequence[float]]  # (when [s], magnitude [A])


@dataclass(frozen=True)
class Claim:
    """A sentence that said at `t_s` that these axes are at zero."""

    t_s: float
    axes: str
    words: str


def flowing(flow: Flow, tau_s: float, t_s: float) -> float:
    """The magnitude of the current at one moment [A]."""
    row = [row for row in flow if row[0] <= t_s][-1:] or [flow[0]]
    since, start, end = row[0]
    fading = math.exp(-(t_s - since) / tau_s) if row[0] is not flow[0] else 0.0
    return abs(end + (start - end) * fading)


def zero_for_good(flow: Flow, tau_s: float, now_s: float) -> float | None:
    """Since when the current has been at zero; None where it is not."""
    if flowing(flow, tau_s, now_s) >= ZERO_A:
        return None
    for k in range(len(flow) - 1, 0, -1):
        since, start, end = flow[k]
        if abs(start) >= ZERO_A or abs(end) >= ZERO_A:
            ratio = max((abs(start) - abs(end)) / max(ZERO_A - abs(end), 1e-9), 1.0)
            return since + tau_s * math.log(ratio) if abs(end) < ZERO_A else flow[k + 1][0]
    return 0.0


def zero_heard(heard: Orders, due_s: float) -> float | None:
    """When after `due_s` the supply first heard zero or off [s]; `due_s` where that was its last order before."""
    before = [level for t_s, level in heard if t_s <= due_s]
    if before[-1:] == [] or before[-1] <= SAME_A:
        return due_s
    return next((t_s for t_s, level in heard if t_s > due_s and level <= SAME_A), None)


def first_zero(orders: Orders, since_s: float) -> float:
    """When zero or off was first among the orders after `since_s`; never (inf) where it was not."""
    return next((t_s for t_s, level in orders if t_s >= since_s and level <= SAME_A), math.inf)


def rises(sent: Orders, ordered_s: float) -> list[tuple[float, float, float]]:
    """Orders since zero was ordered that are larger than one already sent since: (when, level, least before)."""
    least, found = math.inf, list[tuple[float, float, float]]()
    for t_s, level in sent:
        if t_s >= ordered_s:
            if level > least + SAME_A:
                found.append((t_s, level, least))
            least = min(least, level)
    return found


def claims(said: Sequence[tuple[float, str]]) -> list[Claim]:
    """Every sentence that says of a coil that it is at zero."""
    found = list[Claim]()
    for t_s, words in said:
        if DENIED.search(words):
            continue
        axes = "xyz" if OF_ALL.search(words) else "".join(OF_ONE.findall(words))
        if axes:
            found.append(Claim(t_s, axes, words))
    return found


def false_claims(said: Sequence[tuple[float, str]], truth: Mapping[str, Any]) -> list[tuple[float, str, float, str]]:
    """(when, axis, what flowed then [A], words) of each sentence that said zero while current flowed."""
    return [
        (claim.t_s, axis, flowed, claim.words)
        for claim in claims(said)
        for axis in claim.axes
        if (flowed := _least_flowing(truth, axis, claim.t_s)) > FLOWS_A
    ]


def _least_flowing(truth: Mapping[str, Any], axis: str, t_s: float) -> float:
    flow, tau_s = truth["flow"][axis], truth["tau_s"][axis]
    moments = [t_s - READ_LATE_S * k / 10 for k in range(11)]
    return min(flowing(flow, tau_s, moment) for moment in moments)
