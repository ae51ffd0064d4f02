"""All candidates beside what is accepted: the library, and those that the present residual suggests."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from functools import partial

from labcal.loop.candidates.changepoints import steps
from labcal.loop.candidates.delay_scan import delays
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.refine import SECANT, _names, refined
from labcal.loop.candidates.scorer import Search
from labcal.loop.candidates.spectral_lines import periodic
from labcal.loop.parallel import each


def looks(search: Search, accepted: Sequence[Candidate]) -> list[Candidate]:
    """All candidates, a lag on its own secant; periods, steps and delays where the present residual shows them."""
    return search.once("looks", [c.form for c in accepted], lambda: _looks(search, accepted))


def _looks(search: Search, accepted: Sequence[Candidate]) -> list[Candidate]:
    left = search.residual(accepted) * search.rows[:, None]
    known = [refined(search, c, accepted) if SECANT in _names(c.form) else c for c in search.candidates]
    sought = [partial(periodic, search.problem, left), *(partial(look, search, accepted) for look in (steps, delays))]
    return [*known, *itertools.chain(*each(lambda seek: seek(), sought))]
