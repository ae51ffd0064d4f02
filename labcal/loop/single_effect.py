"""One cause, whether it was named or not: what is left of the residual without it and with it."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.errors import InputError
from labcal.loop.assemble import residual_pictures
from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.refine import refined
from labcal.loop.close import candidates_of, prepare
from labcal.loop.result import Pictures
from labcal.loop.selection.joint_fit import joint_fit
from labcal.model import EffectRecord, Parameter
from labcal.model.effects import family
from labcal.record import Run


@dataclass(frozen=True, slots=True, eq=False)
class OneCause:
    """The residual before and after one cause alone was added to the base, in sample, and its parameters."""

    pictures: Pictures
    parameters: tuple[Parameter, ...]
    record: EffectRecord  # as a calibration states it, without what it brought


def one_cause(run: Run, effect: str, channels: tuple[str, ...]) -> OneCause:
    """Add the cause `effect` on `channels`, and nothing else. Raises InputError where this run cannot show it."""
    problem, _, _ = prepare(run)
    pool = candidates_of(run, problem, (effect, channels))
    mine = [c for c in all_candidates(pool, ()) if c.cause == (effect, channels)]
    if not mine:
        raise InputError(f"this run has nothing to show of {effect} {', '.join(channels)}".rstrip())
    chosen = refined(pool, pool.rank(mine)[0].candidate, ())
    before, after = (joint_fit(problem, terms, pool.valid) for terms in ((), (chosen.term,)))
    parameters, term = after.parameters()[0], chosen.term
    record = EffectRecord(
        effect, term.channels, dict(term.reference_value), family(effect).belongs_to, parameters, why="named"
    )
    return OneCause(residual_pictures(before.problem, after.problem), parameters, record)
