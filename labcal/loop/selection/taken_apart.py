"""What is found as one cause and cannot be one alone: a form that can takes its place, or two causes do."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice, product

from labcal.loop.candidates.library import Candidate
from labcal.loop.selection.equivalents import Equivalent
from labcal.loop.selection.joint_fit import JointFit, information, joint_fit
from labcal.loop.selection.proof import Evidence
from labcal.loop.selection.select import contribution


def taken_apart(found: Evidence, fitted: JointFit) -> tuple[Evidence, JointFit]:
    """The same with such an effect as a smaller form of it, alone or beside the other cause (`Family.holds_another`).

    Of these those of the fewest parameters with which all is fitted as well, by Schwarz' criterion. The first form is
    all that the cause alone can be. What a fit has given up is not put there again.
    """
    given_up = {family for family, _ in (*found.not_carried, *found.insignificant, *found.beyond_half)}
    start, terms = fitted.problem.T.shape[2], iter(zip(fitted.terms, fitted.beta, strict=True))
    for place, chosen in enumerate(found.accepted):
        for term, beta in islice(terms, len(chosen.parts)):
            own = slice(start, start + len(beta))
            start = own.stop
            forms, family = chosen.family.holds_another(term, beta, fitted.covariance[own, own])
            if chosen.members or any(one.family.id == family for one in found.accepted):
                continue
            left = [replace(chosen, term=form) for form in forms]
            others = [] if family in given_up else _forms(found, family)
            tried = [*((one,) for one in left[:1]), *product(others, left)]
            for instead in sorted(tried, key=lambda some: sum(c.size for c in some)):
                accepted = (*found.accepted[:place], *instead, *found.accepted[place + 1 :])
                both = joint_fit(found.pool.whole, [part.term for one in accepted for part in one.parts], fitted.used)
                if information(both) <= information(fitted):
                    return _with(found, accepted), both
    return found, fitted


def _forms(found: Evidence, family: str) -> list[Candidate]:
    """The forms of a family without channels or searched parameters."""
    return [c for c in found.pool.candidates if c.cause == (family, ()) and not c.term.shape]


def _with(found: Evidence, accepted: tuple[Candidate, ...]) -> Evidence:
    """The evidence of these effects, each with its own contribution; whose place is new has no rivals."""
    steps = tuple(contribution(found.pool, found.blocks, accepted, place) for place in range(len(accepted)))
    rivals = dict(zip(found.accepted, found.equivalents, strict=True))
    own = (
        rivals.get(one) or (_alone(found, accepted, one, step.after),)
        for one, step in zip(accepted, steps, strict=True)
    )
    return replace(found, accepted=accepted, contributions=steps, equivalents=tuple(own))


def _alone(found: Evidence, accepted: tuple[Candidate, ...], one: Candidate, after_nT: float) -> Equivalent:
    beside = [other for other in accepted if other is not one]
    return Equivalent(found.pool.score(one, found.pool.null_model(beside)), after_nT)
