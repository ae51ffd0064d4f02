"""When a candidate may be admitted to the model: evidence, size, and what it adds to what is there."""

from __future__ import annotations

from collections.abc import Sequence

from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.selection.related import related_columns, span_of_related

MIN_EVIDENCE = 12.0  # nats, below which nothing is named: odds of 1.6e5 to one
MATERIAL = 0.03  # of the noise's square: a smaller drop of the mean square is not worth a parameter
MIN_SHARE_OF_EXPLAINED = 0.01  # of all that was explained: a smaller part is a detail of the first effect's shape
MIN_SHARE_OF_EXCESS = 0.08  # of what is left above the noise, beside all candidates of the first: this is no detail
OWN_PART = 0.03  # of the drop of a cause that extends another: its own part has to take off as much,
OWN_PART_OF_NOISE = 0.25  # or this part of the noise's square


def min_material_drop(pool: CandidateSet, accepted: Sequence[Candidate], total: float) -> float:
    """The least drop of the mean square that is worth a name beside what is accepted."""
    null = pool.null_model(accepted, related_columns(pool, accepted)).null
    rest = (null.rss / pool.n_data - 1.0) / pool.decimation
    return max(MATERIAL * null.level**2, min(MIN_SHARE_OF_EXPLAINED * total, MIN_SHARE_OF_EXCESS * rest))


def earns_its_extension(pool: CandidateSet, accepted: Sequence[Candidate], found: Scored) -> bool:
    """Whether what a cause adds to the ones that it extends has the evidence that a cause of its own would need.

    A reference that drifts is a constant field where the drift is zero, a loop a curve where it has no width: the
    larger model always fits a little better, and that little may be misfit of the smaller one's form.
    """
    smaller = span_of_related(pool, found.candidate, found.candidate.family.extends)
    if not smaller:
        return True
    own = pool.score(found.candidate, pool.null_model(accepted, smaller))
    least = min(OWN_PART * found.drop, OWN_PART_OF_NOISE * pool.min_noise_level**2)
    return own.evidence >= MIN_EVIDENCE and own.drop >= least
