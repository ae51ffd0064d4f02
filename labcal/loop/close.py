"""Close the loop on a run: the residual, its cause, the proof on data that nothing has seen, and the verdict."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from labcal.loop.assemble import _result
from labcal.loop.candidates.library import Cause
from labcal.loop.candidates.scorer import Search
from labcal.loop.data.base_model import fit_base, least_squares, noise_of, usable
from labcal.loop.data.checks import doubt
from labcal.loop.data.gaps import untold
from labcal.loop.data.linear_problem import Problem, linearise
from labcal.loop.data.noise_floor import Floor, floor
from labcal.loop.data.outliers import at_rail
from labcal.loop.narrative import in_doubt
from labcal.loop.result import ClosedLoop, Finding
from labcal.loop.selection.admission import NAMED
from labcal.loop.selection.crossval import always, held_out, plan
from labcal.loop.selection.joint_fit import refit
from labcal.loop.selection.proof import Evidence, proved, search_of, settled, without_outliers
from labcal.loop.selection.select import Choice, decided
from labcal.record import Run

WHITE_AT_LEAST = 0.85  # of a declared noise; 0.5 of a measured one
UNTOLD = 0.01  # of the rows: fewer in gaps that nothing tells make no name
Progress = Callable[[str], None]


def close_loop(run: Run, progress: Progress = lambda text: None) -> ClosedLoop:
    """Find the residual of `run`, trace it, and say what it is. Raises InputError where the run says too little.

    Rows that nothing tells of a channel that has weight are left out, and all is decided again on the others.
    """
    progress("fitting the base model")
    problem, level, stuck = prepared(run)
    if (finding := doubt(problem, level)) is not None:
        return doubted(run, problem, level, stuck, finding)
    progress("weighing every effect")
    bare = searched(run, problem)
    search = settled(bare)
    choice = decided(search, level)
    gaps = untold(run, _weighty(choice))
    if np.mean(gaps) > UNTOLD:
        return close_loop(run.select(~gaps), progress)
    progress("holding out blocks of time")
    found = proved(bare, search, choice, level)
    before, after = (refit(problem, [c.form for c in chosen], found.search.good) for chosen in ((), found.accepted))
    aside = {"outliers": int((~found.search.good).sum()), "saturation": stuck}
    return _result(run, found, before, after, aside)


def _weighty(found: Choice) -> set[str]:
    """The channels of every cause that had the weight of a name at some step."""
    heavy = [w.candidate.form for ranking in found.rankings for w in ranking if w.weight >= NAMED]
    return {name for form in heavy for name in form.channels}


def searched(run: Run, problem: Problem, only: Cause | None = None) -> Search:
    """Every candidate, or the looks of one cause `only`, on the rows that do not lie."""
    search = search_of(problem, _lowest(run))
    if only is not None:
        search = search.among([c for c in search.candidates if c.cause == only])
    return without_outliers(search)


def doubted(run: Run, problem: Problem, level: Floor, stuck: int, finding: Finding) -> ClosedLoop:
    """The result where the data are wrong in themselves: no effect is searched in them."""
    rows = np.ones(len(problem), dtype=bool)
    search = Search(problem, [], rows, _lowest(run), rows)
    blocks = plan(problem, 0.0)
    honest = held_out(search, blocks, always(()))
    found = Evidence(search, search, (), (), (), honest, (), level, blocks, np.zeros(1), {}, 0.0)
    base = refit(problem, [])
    return replace(_result(run, found, base, base, {"outliers": 0, "saturation": stuck}), **in_doubt(finding))


def prepared(run: Run) -> tuple[Problem, Floor, int]:
    """The base fitted, readings at a rail left out and counted, the noise known."""
    cut, _ = usable(run)
    stuck = at_rail(cut)
    cut, seen = usable(cut.select(~stuck))
    base, near = fit_base(cut, seen)
    start = near.solution
    problem = linearise(cut, seen, noise_of(cut, seen), base, near.form, start.theta, start.phase)
    problem, level = floor(problem)
    found = least_squares(seen, problem.noise, near)
    return linearise(cut, seen, problem.noise, base, near.form, found.theta, found.phase), level, int(stuck.sum())


def _lowest(run: Run) -> float:
    return WHITE_AT_LEAST if run.dut.noise_nT else 0.5
