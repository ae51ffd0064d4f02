"""The fit that goes into the file: map, phases and effects together, no worse than the steps that chose the effects.

An effect that is no more than its uncertainty there, declared errors included, is none: it is given up as well. What
it seemed to be may be another's: all is selected again without it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from labcal.fit.vector.ml import estimate
from labcal.fit.vector.observations import SCALAR
from labcal.loop import policy
from labcal.loop.candidates.library import Cause
from labcal.loop.data.credible import driven_by_field, is_beyond_half
from labcal.loop.data.linear_problem import LinearProblem, linearise
from labcal.loop.selection.joint_fit import JointFit, in_sample_rms, joint_fit
from labcal.loop.selection.proof import Evidence, prove, relinearised
from labcal.loop.selection.second_order import in_full
from labcal.loop.selection.select import Selection, contribution, select
from labcal.loop.selection.taken_apart import taken_apart

MAX_SEARCHES = 3  # again, each without what the fit before gave up
Chances = Callable[[JointFit], Sequence[float]]


def final_fit(
    problem: LinearProblem, found: Evidence, selection: Selection, p_values: Chances
) -> tuple[Evidence, JointFit]:
    """The fit with the accepted effects; those that it cannot carry are given up, and all is selected anew without.

    So are those that are more than half of the field, and those that may be zero: `p_values` says how often each term
    would seem as large (Wald). After MAX_SEARCHES the others alone are proven anew.
    """
    not_carried, insignificant, beyond_half = dict[Cause, float](), dict[Cause, float](), set[Cause]()
    while found.accepted:
        found, fitted = taken_apart(*in_full(problem, found, nearest_fit(problem, found)))
        left = in_sample_rms(fitted)
        if not carries_them(left, found):
            place = _least_missed(problem, found)
            not_carried[found.accepted[place].cause] = left
        elif (large := _beyond_half(found, fitted)) is not None:
            place = large
            beyond_half.add(found.accepted[place].cause)
        else:
            place, chance = _least_certain(found, p_values(fitted))
            if chance <= policy.POLICY.significance:
                return _no_better_than_fitted(found, left), fitted
            insignificant[found.accepted[place].cause] = chance
        found, selection = _without(found, selection, place)
        found = replace(found, not_carried=dict(not_carried), insignificant=dict(insignificant))
        found = replace(found, beyond_half=frozenset(beyond_half))
    return found, base_fit(problem, found)


def _beyond_half(found: Evidence, fitted: JointFit) -> int | None:
    """The place of the last accepted effect driven by the field that is more than half of it."""
    scene, apart_nT = fitted.problem.scene, found.contributions[0].before
    if scene.rig is None or fitted.problem.kind != "vector":
        return None
    places, large = [place for place, chosen in enumerate(found.accepted) for _ in chosen.parts], list[int]()
    for place, term, beta in zip(places, fitted.terms, fitted.beta, strict=True):
        if driven_by_field(term):
            in_cage = np.einsum("nji,nj->ni", scene.rig.to_body, term.columns(scene) @ beta)
            large += [place] * is_beyond_half(in_cage[fitted.used], scene.rig.reference_nT[fitted.used], apart_nT)
    return max(large, default=None)


def _least_missed(problem: LinearProblem, found: Evidence) -> int:
    """The place of the accepted effect without which a fit of the others leaves least."""
    each = range(len(found.accepted))
    others = [replace(found, accepted=tuple(c for i, c in enumerate(found.accepted) if i != place)) for place in each]
    return min(each, key=lambda place: in_sample_rms(nearest_fit(problem, others[place])))


def _least_certain(found: Evidence, chances: Sequence[float]) -> tuple[int, float]:
    """The place of the accepted effect that is likeliest zero, all members of a set together, and its chance."""
    ends = np.cumsum([len(chosen.parts) for chosen in found.accepted])
    each = [float(part.min()) for part in np.split(np.array(chances), ends[:-1])]
    place = int(np.argmax(each))
    return place, each[place]


def carries_them(left_nT: float, found: Evidence) -> bool:
    """Whether a final fit takes off most of the squares that its effects took off held-out blocks to first order.

    What a strong effect misses of second order is no reason to leave it out; one that exists to first order only is.
    """
    before, after = found.contributions[0].before, found.contributions[-1].after
    return before**2 - left_nT**2 >= policy.POLICY.min_explained * (before**2 - after**2)


def _no_better_than_fitted(found: Evidence, left_nT: float) -> Evidence:
    """The same with the last effect's own error no smaller than what the final fit leaves."""
    last = found.contributions[-1]
    if last.after >= left_nT:
        return found
    stated = replace(last, after_nT=last.after_nT * (left_nT / max(last.after, 1e-300)))
    return replace(found, contributions=(*found.contributions[:-1], stated))


def nearest_fit(problem: LinearProblem, found: Evidence) -> JointFit:
    """The joint fit from the base, or, where that does not arrive, the better of that and one from the search's map."""
    terms = [part.term for chosen in found.accepted for part in chosen.parts]
    fitted = joint_fit(problem, terms, found.pool.valid)
    if carries_them(in_sample_rms(fitted), found):
        return fitted
    return min(fitted, joint_fit(found.pool.whole, terms, found.pool.valid), key=in_sample_rms)


def _without(found: Evidence, selection: Selection, place: int) -> tuple[Evidence, Selection]:
    """What is selected and proven without the effect at `place`; after MAX_SEARCHES the others alone."""
    given_up = found.accepted[place].cause
    if len(selection.barred) < MAX_SEARCHES:
        barred = selection.barred | {given_up}
        pool = relinearised(found.base_set, barred)
        same_rows = len(pool.problem) == len(found.pool.problem)
        selection = select(pool, found.level, found.blocks if same_rows else None, barred=barred)
    else:
        pool, kept = found.pool, [c for i, c in enumerate(found.accepted) if i != place]
        steps = [contribution(pool, found.blocks, kept, i) for i in range(len(kept))]
        selection = replace(selection, accepted=tuple(kept), contributions=tuple(steps))
    again = prove(found.base_set, pool, selection, found.level)
    refused = {**found.refused, **again.refused, given_up: found.contributions[place]}
    return replace(again, refused=refused), selection


def base_fit(problem: LinearProblem, found: Evidence) -> JointFit:
    """The base alone: by least squares where it reaches the noise, else as robust as the base of every fit.

    What nobody understands pulls least squares farther than a fit that trusts far rows less.
    """
    rows = found.pool.valid
    if found.cv_error.after <= policy.POLICY.floor_ratio * found.level.nT:
        return joint_fit(problem, [], rows)
    as_scalar = bool((problem.observations.kind == SCALAR).all())
    robust = estimate(problem.run, parameterisation=problem.parameterisation.name, as_scalar=as_scalar).solution
    p = problem
    there = linearise(p.run, p.observations, p.noise, p.base, p.parameterisation, robust.theta, robust.phase)
    return JointFit.at(there, rows)
