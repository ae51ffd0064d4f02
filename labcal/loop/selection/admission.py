"""When a candidate may be admitted to the model: evidence, size, and what it adds to what is there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.noise.coloured import NullModel
from labcal.loop.selection.misfit import evidence_over_misfit, misfits
from labcal.loop.selection.related import beginnings, other_forms, related, related_columns

LIKELIEST = 3  # related forms of what is accepted that may be as likely as another cause


def min_material_drop(pool: CandidateSet, accepted: Sequence[Candidate]) -> float:
    """The least drop of the mean square that is worth a name beside what is accepted."""
    null_model = pool.null_model(accepted, related_columns(pool, accepted))
    return material_beside(pool, null_model) if accepted else policy.POLICY.material_share * null_model.null.level**2


def material_beside(pool: CandidateSet, null_model: NullModel) -> float:
    """The same beside a null model that has causes in it: a part of what that leaves above the noise."""
    law, null = policy.POLICY, null_model.null
    rest = (null.rss / pool.n_data - 1.0) / pool.decimation
    return max(law.material_share * null.level**2, law.min_share_of_excess * rest)


def is_its_own(pool: CandidateSet, accepted: Sequence[Candidate], found: Scored) -> bool:
    """Whether a cause has the evidence of a name beside whatever the accepted forms may miss."""
    least = policy.POLICY.min_evidence
    return not accepted or all(nats >= least for nats in _beside_each(pool, accepted, found.candidate))


def evidence_of_its_own(pool: CandidateSet, accepted: Sequence[Candidate], candidate: Candidate) -> float:
    """The evidence for what no other form in the inputs of an accepted effect takes [nats]: the least of them."""
    return min(_beside_each(pool, accepted, candidate))


def plain_evidence(pool: CandidateSet, accepted: Sequence[Candidate], candidate: Candidate) -> float:
    """The evidence beside accepted effects and their related forms [nats]: never less than what is its own.

    Beside all that the related forms span, or where that is more: beside what they are likely to do; but for what lies
    wholly within the span, which is one of these forms.
    """
    spanned = pool.score(candidate, pool.null_model(accepted, related_columns(pool, accepted)))
    if spanned.evidence >= policy.POLICY.min_evidence or not spanned.rank:
        return spanned.evidence
    return max(spanned.evidence, evidence_beside_likely_forms(pool, accepted, candidate))


def evidence_beside_likely_forms(pool: CandidateSet, accepted: Sequence[Candidate], candidate: Candidate) -> float:
    """The evidence beside what the related forms of accepted effects are likely to do [nats]: the least of two.

    Beside each that is as likely as the candidate, for what another form does is no other cause; and beside any mixture
    of them, integrated out: a direction is a priori as wide as it is common among them, and all together as wide as
    makes the data likeliest. So the hundreds of directions that a large family spans take nothing where the form is
    whole.
    """
    null = pool.null_model(accepted)
    own = pool.score(candidate, null)
    forms = other_forms(pool, accepted)
    if not forms:
        return own.evidence
    likely = sorted(pool.score_each(forms, null), key=lambda w: -w.evidence)[:LIKELIEST]
    rivals = (w.candidate for w in likely if w.evidence >= own.evidence - policy.POLICY.equivalent_nats)
    beside = (pool.score(candidate, pool.null_model([*accepted, form])).evidence for form in rivals)
    mixture = evidence_over_misfit(pool, accepted, candidate, related_columns(pool, accepted, common=True))
    return min([mixture, *beside])


def _beside_each(pool: CandidateSet, accepted: Sequence[Candidate], candidate: Candidate) -> Iterator[float]:
    """The evidence beside all accepted ones, then beside what each may miss, which takes far longer [nats]."""
    yield plain_evidence(pool, accepted, candidate)
    spans = (span for one in accepted for span in misfits(pool, [one]))
    yield from (evidence_over_misfit(pool, accepted, candidate, [span]) for span in spans)


def earns_its_extension(pool: CandidateSet, accepted: Sequence[Candidate], found: Scored) -> bool:
    """Whether what a cause adds to the ones that it extends has the evidence that a cause of its own would need.

    A reference that drifts is a constant field where the drift is zero, a loop a curve where it has no width: the
    larger model always fits a little better, and that little may be misfit of the smaller one's form. So does one that
    begins anywhere in each segment: what only differs from segment to segment is no loop. Each form of the smaller one
    is another model: one of all of them at once is nobody's.
    """
    begins, law = beginnings(pool, found.candidate), policy.POLICY
    forms = related(pool, found.candidate, found.candidate.family.extends)
    models = [pool.null_model([*accepted, form], begins) for form in forms]
    if begins and not models:
        models = [pool.null_model(accepted, begins)]
    least = min(law.material_share * found.drop, law.clear_share * pool.min_noise_level**2)
    own = (pool.score(found.candidate, model) for model in models)
    return all(one.evidence >= law.min_evidence and one.drop >= least for one in own)
