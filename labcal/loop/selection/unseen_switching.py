"""Loads that were switched between two samples of their telemetry: rows that the channel does not decide.

Drawn straight from sample to sample, a switched load seems to be on its way for as long as a sample takes. Whether it
was is for the readings to say: where a cause that follows the channel misses more on the ways than beside them, the
channel was not there. A cause that follows after a delay rests on what the channel was then: its ways lie as much
later. The weather is never switched.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import gammaln  # scipy.stats would load for a second

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.selection.select import Selection
from labcal.model.effects import DELAY, Term
from labcal.model.effects.regressors import WEATHER, stretches
from labcal.model.switched import drawn_between_levels
from labcal.record import Run

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


def switched_unseen(pool: CandidateSet, found: Selection) -> Mask:
    """Rows (N,) of the whole problem on ways that a cause misses more than the rows beside them."""
    left = _misfit(pool, found.accepted)
    out = np.zeros(len(left), dtype=bool)
    for term, effects in _resting_on_channels(found):
        ways = ways_of(pool.whole.run, term)
        known = ~ways & pool.valid
        if not ways.any() or not known.any():
            continue
        own = left if effects is found.accepted else _misfit(pool.without_rows(~known), effects)
        if _is_as_good(own[known], left[known]) and misses_more(own, ways):
            out |= ways
    return out


def _is_as_good(squares: Array, others: Array) -> bool:
    """Whether a fit that leaves these squares is not behind the one that leaves the others by what decides."""
    behind = 0.5 * len(squares) * np.log(np.mean(squares) / np.mean(others))
    return bool(behind <= policy.POLICY.equivalent_nats)


def _resting_on_channels(found: Selection) -> Iterator[tuple[Term, Sequence[Candidate]]]:
    """Forms that follow channels, each with the effects that it is judged with: those accepted, or it alone."""
    parts = [part.term for chosen in found.accepted for part in chosen.parts]
    yield from ((term, found.accepted) for term in parts)
    known = {name for term in parts for name in term.channels}
    for scored in found.rankings[0] if found.rankings else ():
        term = scored.candidate.term
        if scored.evidence >= policy.POLICY.min_evidence and not known.issuperset(term.channels):
            known.update(term.channels)
            yield term, (scored.candidate,)


def ways_of(run: Run, term: Term) -> Mask:
    """Rows (n,) that rest on a way between two levels of one of its channels."""
    out, late = np.zeros(len(run), dtype=bool), term.of(DELAY)
    edges = np.array([*(part.start for part in stretches(run.segment_index)), len(run)])
    for channel in run.channels:
        if channel.name in term.channels and channel.quantity not in WEATHER:
            ways = drawn_between_levels(channel.values, edges)
            out |= ways if late is None else _later(ways, run, late.value)
    return out


def _later(ways: Mask, run: Run, delay_s: float) -> Mask:
    """Rows (n,) that were on a way a delay ago."""
    out = np.zeros_like(ways)
    for part in stretches(run.segment_index):
        t_s = run.t_s[part]
        out[part] = np.interp(t_s - delay_s, t_s, ways[part].astype(float)) > 0
    return out


def misses_more(squares: Array, ways: Mask) -> bool:
    """Whether more of the largest squares lie on the ways than chance puts there: of n rows m, of the m largest k."""
    n, m = len(squares), int(ways.sum())
    largest = np.argsort(squares)[n - m :]
    return by_chance(n, m, int(ways[largest].sum())) < policy.POLICY.significance


def by_chance(n: int, m: int, k: int) -> float:
    """The probability that m of n rows, drawn without looking, hold k or more of m others (hypergeometric)."""
    there = np.arange(max(k, 2 * m - n, 0), m + 1)
    chosen = _ln_choose(m, there) + _ln_choose(n - m, m - there) - _ln_choose(n, m)
    return float(np.exp(chosen).sum())


def _ln_choose(n: int, k: ArrayLike) -> Array:
    """The logarithm of the number of ways to choose `k` of `n`."""
    k = np.asarray(k)
    return np.asarray(gammaln(n + 1) - gammaln(k + 1) - gammaln(n - k + 1))


def _misfit(pool: CandidateSet, effects: Sequence[Candidate]) -> Array:
    """Squares (N,) of what the effects leave in each row of the whole problem."""
    return np.asarray(np.mean(pool.residual_everywhere(effects)[0] ** 2, axis=1))
