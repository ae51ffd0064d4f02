"""All candidates beside what is accepted: the library, and what the present residual suggests."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from functools import partial

from labcal.loop.candidates.changepoints import changepoints
from labcal.loop.candidates.delay_scan import delay_scan
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.refine import has_own_secant, refined
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.candidates.spectral_lines import spectral_lines
from labcal.loop.parallel import parallel_map


def all_candidates(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Candidate]:
    """The library, a lag on its own secant; periods, steps and delays where the present residual shows them."""
    return pool.cached("all candidates", accepted, lambda: _all_candidates(pool, accepted))


def _all_candidates(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Candidate]:
    left = pool.residual(accepted) * pool.rows[:, None]
    library = [refined(pool, c, accepted) if has_own_secant(c) else c for c in pool.candidates]
    searches = [partial(scan, pool, accepted) for scan in (changepoints, delay_scan)]
    suggested = parallel_map(lambda search: search(), [partial(spectral_lines, pool.problem, left), *searches])
    return [*library, *itertools.chain(*suggested)]
