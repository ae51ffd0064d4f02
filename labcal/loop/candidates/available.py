"""All candidates beside what is accepted: the library, and what the present residual suggests."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from functools import partial

from labcal.loop.candidates.angle_zeros import angle_zeros
from labcal.loop.candidates.changepoints import changepoints
from labcal.loop.candidates.delay_scan import delay_scan
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.refine import has_own_secant, refined
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.candidates.spectral_lines import spectral_lines
from labcal.loop.parallel import parallel_map
from labcal.model.effects import families
from labcal.model.effects.shape import FoundBy

SEARCHES: dict[FoundBy, Callable[[CandidateSet, Sequence[Candidate]], list[Candidate]]] = {
    "spectral lines": lambda pool, accepted: spectral_lines(pool.problem, pool.residual(accepted) * pool.rows[:, None]),
    "changepoints": changepoints,
    "delay scan": delay_scan,
    "angle zeros": angle_zeros,
}


def all_candidates(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Candidate]:
    """The library, a lag on its own secant; periods, steps and delays where the present residual shows them."""

    def made() -> list[Candidate]:
        suggested = parallel_map(partial(_suggested, pool, accepted), SEARCHES)
        return [*_at_own_secants(pool, pool.candidates, accepted), *itertools.chain(*suggested)]

    return pool.cached("all candidates", accepted, made)


def related_candidates(pool: CandidateSet, accepted: Sequence[Candidate], chosen: Candidate) -> list[Candidate]:
    """Those of them that are of a related family in the channels of `chosen`: no others are searched for."""
    wanted = [family for family in families() if family.id in chosen.family.related]
    searches = [by for by in SEARCHES if any(family.found_by(by) for family in wanted)]
    every = itertools.chain(pool.candidates, *(_suggested(pool, accepted, by) for by in searches))
    ids = {family.id for family in wanted}
    mine = [c for c in every if c.family.id in ids and c.term.channels == chosen.term.channels]
    return _at_own_secants(pool, mine, accepted)


def _suggested(pool: CandidateSet, accepted: Sequence[Candidate], by: FoundBy) -> list[Candidate]:
    return pool.cached(("suggested", by), accepted, lambda: SEARCHES[by](pool, accepted))


def _at_own_secants(
    pool: CandidateSet, candidates: Sequence[Candidate], accepted: Sequence[Candidate]
) -> list[Candidate]:
    return [refined(pool, c, accepted) if has_own_secant(c) else c for c in candidates]
