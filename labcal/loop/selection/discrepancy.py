"""A name whose form is not whole: it stands where it leads even beside a smooth function of all that is recorded.

What a form misses is smooth in something: the field, the angle, the rate, a channel. Beside such a function (Kennedy &
O'Hagan's discrepancy, J. R. Stat. Soc. B 63, 425, 2001, without a prior of its own) the nearest form has no lead by
coincidence: what it carries that no smooth function does is its own, and the other causes compete for that alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations_with_replacement

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.library import Candidate, Span
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.noise.nuisance import principal_span
from labcal.loop.selection.admission import min_material_drop
from labcal.loop.selection.misfit import MOST_DIRECTIONS, evidence_beside_misfit, misfits, mistimed, scaled
from labcal.model.effects import FREQUENCY, Scene
from labcal.model.effects.regressors import on_each_axis, stretches

Array = NDArray[np.float64]
DEGREES = (2, 3)  # of what is not straight
HARMONICS = (1, 2, 3)  # of the platform's angle
NEAREST = 3  # rivals that are scored beside what both may miss


def stands_beside_discrepancy(pool: CandidateSet, accepted: Sequence[Candidate], chosen: Candidate) -> bool:
    """Whether `chosen` has the evidence of a name, and a lead over every unrelated cause, beside a discrepancy.

    Over the nearest rivals where each of the two may miss a smooth function of its own inputs as well. What follows
    time alone never does, but for a line that is narrow.
    """
    others = [c for c in accepted if c is not chosen]
    if chosen.family.generic or (chosen.family.bound_to_run and not is_narrow_line(pool, others, chosen)):
        return False
    law, beside = policy.POLICY, [discrepancy(pool, chosen)]
    own = pool.score(chosen, pool.null_model(others, beside))
    if own.evidence < law.min_evidence or own.drop < min_material_drop(pool, others):
        return False
    related = {chosen.family.id, *chosen.family.extends, *chosen.family.related}
    rivals = [c for c in all_candidates(pool, others) if _is_unrelated(c, chosen, related)]
    found = pool.rank(rivals, others, beside)
    if any(w.evidence >= own.evidence - law.equivalent_nats for w in found[NEAREST:]):
        return False
    near = [w.candidate for w in found[:NEAREST] if w.evidence >= law.min_evidence]
    return all(_leads_beside_both(pool, others, chosen, rival) for rival in near)


def is_narrow_line(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate) -> bool:
    """Whether it is one frequency: those beside it hold no more than a square wave has beyond its third harmonic.

    As far as a wave spreads whose phase is another one in each segment: what resembles a line for a while is that wide.
    """
    frequency = chosen.term.of(FREQUENCY)
    if frequency is None:
        return False
    scene = pool.whole.scene
    apart_Hz = 1 / float(scene.t_s[-1] - scene.t_s[0])
    count = len(stretches(scene.segment))
    with_it = pool.null_model([*others, chosen])
    own = pool.score(chosen, pool.null_model(others)).drop
    beside = [
        replace(chosen, term=chosen.term.with_values(**{frequency.name: frequency.value + k * apart_Hz}))
        for k in range(-count, count + 1)
        if k and frequency.value + k * apart_Hz > 0
    ]
    held = sum(pool.score(one, with_it).drop for one in beside)
    return held <= policy.POLICY.max_misfit_of_a_line * own


def _leads_beside_both(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate, rival: Candidate) -> bool:
    """Whether `chosen` still leads where neither it nor the rival may explain what the other's form misses.

    Of two in the same channel neither is bent: a gain bent by the field is an offset, and which it is, is asked.
    """
    missed = mistimed if chosen.term.channels and chosen.term.channels == rival.term.channels else misfits
    beside = [discrepancy(pool, chosen), *missed(pool, [chosen, rival])]
    own, other = (_evidence_beside(pool, others, c, beside) for c in (chosen, rival))
    return own >= max(other, 0.0) + policy.POLICY.equivalent_nats


def _evidence_beside(
    pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate, beside: Sequence[Span]
) -> float:
    """The evidence for a cause [nats] with what may be missed integrated over its likeliest prior.

    Of very many directions, which are nearly all that a record can hold, only what is across them counts.
    """
    if sum(span.columns.shape[2] for span in beside) > MOST_DIRECTIONS:
        return pool.score(chosen, pool.null_model(others, beside)).evidence
    return evidence_beside_misfit(pool, others, chosen, beside)


def _is_unrelated(candidate: Candidate, chosen: Candidate, related: set[str]) -> bool:
    return candidate.family.id not in related and chosen.family.id not in candidate.family.extends


def discrepancy(pool: CandidateSet, chosen: Candidate) -> Span:
    """A smooth function of everything that is recorded; of the channels that `chosen` follows what is not straight."""

    def made() -> Span:
        scene = pool.problem.scene if pool.problem.whole is None else pool.problem.whole.scene
        drives = list(_drives(scene, chosen.term.channels))
        columns = np.concatenate([on_each_axis(drive) for drive in drives], axis=2)
        return Span(principal_span(pool.transformed(pool.problem.whitened(columns))))

    return pool.cached(("discrepancy", chosen.term.channels), (), made)


def _drives(scene: Scene, own: Sequence[str]) -> Iterator[Array]:
    """Powers of the field, its rate, harmonics of the angle, powers of every channel, each (n,)."""
    field = scaled(scene.driving_field_nT)
    for degree in DEGREES:
        for axes in combinations_with_replacement(range(3), degree):
            yield np.prod(field[:, axes], axis=1)
    rate = scaled(np.concatenate([np.gradient(field[part], axis=0) for part in stretches(scene.segment)]))
    yield from (*rate.T, *(rate**2).T)
    if scene.rig is not None and np.isfinite(scene.rig.angle_rad).any():
        angle = np.nan_to_num(scene.rig.angle_rad)
        turning = np.isfinite(scene.rig.angle_rad)
        yield from (turning * wave(k * angle) for k in HARMONICS for wave in (np.cos, np.sin))
    for name, values in scene.channels.items():
        x = scaled(values - np.median(values))
        yield from (_bent(x**degree, x) for degree in DEGREES) if name in own else (x**k for k in (1, *DEGREES))


def _bent(values: Array, x: Array) -> Array:
    """What no line in `x` (n,) takes of values (n,): of a load that is switched all powers are the same."""
    line = np.column_stack([np.ones_like(x), x])
    return np.asarray(values - line @ np.linalg.lstsq(line, values, rcond=None)[0])
