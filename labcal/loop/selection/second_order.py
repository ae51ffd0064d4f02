"""Forms that hold a strong effect of the field whole: it acts on the field that contains the effect itself.

The search scores a form on the field without it, to first order. What a core that bends by a tenth does to the field
that `apply` works from needs the next powers as well: they are of the same cause, and nothing new is named.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.refine import refined
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.selection.joint_fit import JointFit, in_sample_rms, information, joint_fit
from labcal.loop.selection.proof import Evidence

MOST_FORMS = 8  # that are fitted whole for one cause, the smallest first


def in_full(problem: LinearProblem, found: Evidence, fitted: JointFit) -> tuple[Evidence, JointFit]:
    """The same with larger forms of its effects of the field, where it leaves more than the search did with them.

    The form with the least of Schwarz' criterion, over all that it leaves, is the one that the file holds.
    """
    for place, chosen in enumerate(found.accepted):
        if not chosen.family.of_field or chosen.members or _leaves_as_little(fitted, found):
            continue
        for form in _larger(found, chosen):
            tried = (*found.accepted[:place], form, *found.accepted[place + 1 :])
            terms = [part.term for one in tried for part in one.parts]
            other = joint_fit(problem, terms, found.pool.valid)
            if information(other) < information(fitted):
                found, fitted = replace(found, accepted=tried), other
            if _leaves_as_little(fitted, found):
                break
    return found, fitted


def _leaves_as_little(fitted: JointFit, found: Evidence) -> bool:
    return in_sample_rms(fitted) <= policy.POLICY.floor_ratio * max(found.contributions[-1].after, found.level.nT)


def _larger(found: Evidence, chosen: Candidate) -> Iterator[Candidate]:
    """The larger forms of a cause, each at its best nonlinear parameters, smallest first.

    Of no other shape: a delay or a temperature that the search did not find is no power of the field.
    """
    others = [c for c in found.accepted if c is not chosen]
    own = {shape.name for shape in chosen.term.shape}
    larger = (c for c in found.pool.candidates if c.cause == chosen.cause and c.size > chosen.size)
    forms = {c.term.parameters: c for c in larger if own.issuperset(shape.name for shape in c.term.shape)}
    for form in sorted(forms.values(), key=lambda c: c.size)[:MOST_FORMS]:
        yield refined(found.pool, form, others)
