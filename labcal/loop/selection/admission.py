"""When a candidate may be admitted to the model: evidence, size, and what it adds to what is there."""

from __future__ import annotations

from collections.abc import Sequence

from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import Search, Weighed
from labcal.loop.selection.related import _spanned, neighbourhood

NAMED = 12.0  # nats of weight below which nothing is named: odds of 1.6e5 to one
MATERIAL = 0.03  # of the noise's square: a smaller drop of the mean square is not worth a parameter
SHARE = 0.01  # of all that was explained: a smaller part is a detail of the first effect's shape
SHARE_OF_REST = 0.08  # of what still lies above the noise, beside all looks of the first: this is more than a detail
OWN_PART = 0.03  # of the drop of a cause that extends another: what is its own has to bring as much,
OWN_PART_OF_NOISE = 0.25  # or this part of the noise's square


def _material(search: Search, accepted: Sequence[Candidate], total: float) -> float:
    """The least drop of the mean square that is worth a name beside what is accepted."""
    null = search.stage(accepted, neighbourhood(search, accepted)).null
    rest = (null.rss / search.data - 1.0) / search.rows_each
    return max(MATERIAL * null.level**2, min(SHARE * total, SHARE_OF_REST * rest))


def earned(search: Search, accepted: Sequence[Candidate], found: Weighed) -> bool:
    """Whether what a cause adds to those that it extends weighs as much as a cause of its own would have to.

    A reference that drifts is a constant field where the drift is nought, a loop a curve where it has no width: the
    larger model always does a little better, and that little may be misfit of the smaller one's form.
    """
    smaller = _spanned(search, found.candidate, found.candidate.family.extends)
    if not smaller:
        return True
    own = search.weigh(found.candidate, search.stage(accepted, smaller))
    return own.weight >= NAMED and own.drop >= min(OWN_PART * found.drop, OWN_PART_OF_NOISE * search.lowest**2)
