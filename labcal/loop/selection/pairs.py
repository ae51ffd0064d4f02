"""Two causes that only show together: each alone brings little, because the other hides it.

Two currents that move nearly alike and act against each other leave the small difference of both; a temperature and a
drift that run against each other leave a bend. From the Gram matrix of a short list of columns under the noise that was
fitted without them, what any two bring together is a small solution; the best few are weighed in full.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import Search, Weighed
from labcal.loop.noise.coloured import Stage

Array = NDArray[np.float64]
SHORT = 12  # causes whose best looks are paired
WEIGHED = 3  # pairs that are weighed in full
NEW = 1e-4  # of a column's square must be new to the base and to the other cause


@dataclass(frozen=True, slots=True, eq=False)
class Pair:
    """Two candidates with what they bring together."""

    one: Candidate
    other: Candidate
    weight: float  # [nats] gain of both less both prices and the pairs tried
    drop: float  # of the mean square of the whitened residual


def pairs(
    search: Search, stage: Stage, ranking: Sequence[Weighed], refused: Collection[tuple[str, tuple[str, ...]]]
) -> list[Pair]:
    """The heaviest pairs of different causes beside what the stage holds, heaviest first.

    Paired are the best looks of the first causes of the ranking, and every cause that follows a channel in its plainest
    look. Two causes that are both bound to the run's time are no pair: together they follow any slow process.
    """
    short = [c for c in listed(search, ranking) if c.cause not in refused]
    tried = [
        (a, b)
        for a, b in itertools.combinations(range(len(short)), 2)
        if short[a].cause != short[b].cause and not (short[a].family.bound_to_run and short[b].family.bound_to_run)
    ]
    if not tried:
        return []
    gains = _together(search, stage, short, tried)
    best = sorted(zip(gains, tried, strict=True), key=lambda found: -found[0])[:WEIGHED]
    looks = float(np.log(len(tried)))
    found = [_weighed(search, stage, short[a], short[b], looks) for _, (a, b) in best]
    return sorted(found, key=lambda pair: -pair.weight)


def listed(search: Search, ranking: Sequence[Weighed]) -> list[Candidate]:
    """The short list, each look once."""
    ranked = [w.candidate for w in sorted(ranking, key=lambda w: -w.gain)]
    plain: dict[tuple[str, tuple[str, ...]], Candidate] = {}
    for candidate in search.candidates:
        known = plain.get(candidate.cause)
        if candidate.form.channels and (known is None or candidate.size < known.size):
            plain[candidate.cause] = candidate
    first = [plain[c.cause] for c in ranked if c.cause in plain][:SHORT]
    return list({id(c.form): c for c in (*ranked[:SHORT], *first)}.values())


def _together(search: Search, stage: Stage, short: list[Candidate], tried: list[tuple[int, int]]) -> list[float]:
    """Half the drop of the whitened sum of squares by both, less their prices, for each pair tried."""
    weight = np.repeat(stage.bands.spectra[stage.null.tried], np.diff(stage.bands.edges)) ** -0.5 / stage.null.level
    columns = [search.moved(c) for c in short]
    ends = np.cumsum([0, *(X.shape[2] for X in columns)])
    base, X, y = (_flat(part, weight) for part in (stage.columns, np.concatenate(columns, axis=2), stage.y))
    own = np.maximum(np.sum(X**2, axis=0), 1e-300)
    carried = np.linalg.pinv(base.T @ base, rcond=1e-10, hermitian=True) @ (base.T @ np.hstack([X, y]))
    G, pull = X.T @ X - (X.T @ base) @ carried[:, :-1], X.T @ y - (X.T @ base) @ carried[:, -1:]
    scale = np.sqrt(own)
    G, pull = G / np.outer(scale, scale), pull[:, 0] / scale
    gains = []
    for a, b in tried:
        at = np.r_[ends[a] : ends[a + 1], ends[b] : ends[b + 1]]
        values, vectors = np.linalg.eigh(G[np.ix_(at, at)])
        kept = values > NEW
        along = vectors.T @ pull[at]
        gain = 0.5 * float(np.sum(along[kept] ** 2 / values[kept]))
        gains.append(
            gain - search.price(short[a], ends[a + 1] - ends[a]) - search.price(short[b], ends[b + 1] - ends[b])
        )
    return gains


def _weighed(search: Search, stage: Stage, one: Candidate, other: Candidate, looks: float) -> Pair:
    found, rank = stage.beside(np.concatenate([search.moved(one), search.moved(other)], axis=2))
    of_one = min(len(one.form.parameters), rank)
    price = search.price(one, of_one) + search.price(other, rank - of_one) + looks
    drop = (stage.null.rss - found.rss) / (search.data * search.rows_each)
    return Pair(one, other, found.log - stage.null.log - price, drop)


def _flat(columns: Array, weight: Array) -> Array:
    return np.asarray((columns * weight[:, None, None]).reshape(-1, columns.shape[2]))
