"""Two causes that only show together: each alone brings little, because the other hides it.

Two currents that move nearly alike and act against each other leave the small difference of both; a temperature and a
drift that run against each other leave a curve. The Gram matrix of a short list of columns, under the noise that was
fitted without them, gives what any two explain together; the best few are scored under every noise spectrum.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.noise.coloured import NullModel
from labcal.loop.noise.nuisance import MIN_NEW_SHARE, explained_squares
from labcal.loop.noise.whitening import WhitenedNull

SHORTLIST = 12  # causes whose best candidates are paired
SCORED_IN_FULL = 3  # pairs that are scored under every spectrum


@dataclass(frozen=True, slots=True, eq=False)
class Pair:
    """Two candidates with what they explain together."""

    one: Candidate
    other: Candidate
    evidence: float  # [nats] gain of both less both penalties and the trials
    drop: float  # of the mean square of the whitened residual


def score_pairs(
    pool: CandidateSet,
    null_model: NullModel,
    ranking: Sequence[Scored],
    refused: Collection[Cause],
) -> list[Pair]:
    """The best pairs of different causes beside the null model, most evidence first.

    Paired are the best candidates of the first causes of the ranking, and every cause that follows a channel by its
    smallest candidate. Two causes that are both bound to the run's time are no pair: together they follow any slow
    process.
    """
    short = [c for c in shortlist(pool, ranking) if c.cause not in refused]
    tried = [
        (a, b)
        for a, b in itertools.combinations(range(len(short)), 2)
        if short[a].cause != short[b].cause and not (short[a].family.bound_to_run and short[b].family.bound_to_run)
    ]
    if not tried:
        return []
    gains = _joint_evidence(pool, null_model, short, tried)
    best = sorted(zip(gains, tried, strict=True), key=lambda found: -found[0])[:SCORED_IN_FULL]
    trials = float(np.log(len(tried)))
    found = [_score_pair(pool, null_model, short[a], short[b], trials) for _, (a, b) in best]
    return sorted(found, key=lambda pair: -pair.evidence)


def shortlist(pool: CandidateSet, ranking: Sequence[Scored]) -> list[Candidate]:
    """The candidates that are paired, each once."""
    ranked = [w.candidate for w in sorted(ranking, key=lambda w: -w.gain)]
    smallest: dict[Cause, Candidate] = {}
    for candidate in pool.candidates:
        known = smallest.get(candidate.cause)
        if candidate.term.channels and (known is None or candidate.size < known.size):
            smallest[candidate.cause] = candidate
    first = [smallest[c.cause] for c in ranked if c.cause in smallest][:SHORTLIST]
    return list(dict.fromkeys((*ranked[:SHORTLIST], *first)))


def _joint_evidence(
    pool: CandidateSet, null_model: NullModel, short: list[Candidate], tried: list[tuple[int, int]]
) -> list[float]:
    """The gain of both less their penalties, for each pair tried, under the null model's own noise."""
    columns = [pool.transformed_columns(c) for c in short]
    ends = np.cumsum([0, *(X.shape[2] for X in columns)])
    schur, xty = WhitenedNull.of(null_model).normal_equations(np.concatenate(columns, axis=2))
    penalties = [pool.penalty(c, X.shape[2]) for c, X in zip(short, columns, strict=True)]
    evidence = []
    for a, b in tried:
        both = np.r_[ends[a] : ends[a + 1], ends[b] : ends[b + 1]]
        explained, _ = explained_squares(schur[np.ix_(both, both)], xty[both], MIN_NEW_SHARE)
        evidence.append(0.5 * float(explained[0]) - penalties[a] - penalties[b])
    return evidence


def _score_pair(pool: CandidateSet, null_model: NullModel, one: Candidate, other: Candidate, trials: float) -> Pair:
    columns = np.concatenate([pool.transformed_columns(one), pool.transformed_columns(other)], axis=2)
    found, rank = null_model.with_columns(columns)
    of_one = min(len(one.term.parameters), rank)
    penalty = pool.penalty(one, of_one) + pool.penalty(other, rank - of_one) + trials
    drop = (null_model.null.rss - found.rss) / (pool.n_data * pool.decimation)
    return Pair(one, other, found.log - null_model.null.log - penalty, drop)
