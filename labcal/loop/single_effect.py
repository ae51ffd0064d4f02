"""One cause, whether it was named or not: what is left of the residual without it and with it."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.errors import InputError
from labcal.loop.assemble import pictured
from labcal.loop.candidates.available import looks
from labcal.loop.candidates.refine import refined
from labcal.loop.close import prepared, searched
from labcal.loop.result import Pictures
from labcal.loop.selection.joint_fit import refit
from labcal.model import Parameter
from labcal.record import Run


@dataclass(frozen=True, slots=True, eq=False)
class OneCause:
    """The residual before and after one cause alone was added to the base, in sample, and its parameters."""

    pictures: Pictures
    parameters: tuple[Parameter, ...]


def one_cause(run: Run, effect: str, channels: tuple[str, ...]) -> OneCause:
    """Add the cause `effect` on `channels`, and nothing else. Raises InputError where this run cannot show it."""
    problem, _, _ = prepared(run)
    search = searched(run, problem, (effect, channels))
    mine = [c for c in looks(search, ()) if c.cause == (effect, channels)]
    if not mine:
        raise InputError(f"this run has nothing to show of {effect} {', '.join(channels)}".rstrip())
    chosen = refined(search, search.rank(mine)[0].candidate, ())
    before, after = (refit(problem, forms, search.good) for forms in ((), (chosen.form,)))
    return OneCause(pictured(before.problem, after.problem), after.parameters()[0])
