"""What each error that a run declares of its reference and its mounting changes of a residual."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import SCALAR, Observations, observe
from labcal.fit.vector.system import Noise, evaluate
from labcal.record import Run
from labcal.uncertainty import DeclaredError, declared_errors

Array = NDArray[np.float64]
Residual = Callable[[Run], Array]


def residual_of(
    seen: Observations, noise: Noise, theta: Array, phase: Array, effects_nT: Array | float = 0.0
) -> Residual:
    """The residual (n, 3) [nT] of a run as a function of it, all parameters held."""
    as_scalar = bool((seen.kind == SCALAR).all())
    return lambda run: evaluate(observe(run, as_scalar=as_scalar), noise, theta, phase, effects_nT).residual


def moves(run: Run, residual: Residual) -> tuple[tuple[DeclaredError, ...], Array]:
    """The errors that the run declares, and what one standard deviation of each changes (n, 3, e) [nT].

    A mounting is one seat of the device: its axes may be wrong by as much as is declared in all mountings alike, and
    by as much again in each of them.
    """
    errors, changes = list[DeclaredError](), [np.zeros((len(run), 3, 0))]
    for error in declared_errors(as_stated(run)):
        change = error.moves(run, residual)
        each = [np.where(rows[:, None], change, 0.0) for rows in _mountings(run)] if error.each_mounting else []
        errors += [error] * (1 + len(each))
        changes.append(np.stack([change, *each], axis=2))
    return tuple(errors), np.concatenate(changes, axis=2)


def as_stated(run: Run) -> Run:
    """The run with the zero of its reference as it was stated, without its closures.

    What they show moved within the run: no constant of the reference, and perhaps an effect.
    """
    stated = run.reference.u_offset_nT
    if stated is None or not run.closures:
        return run
    whole = max(closure.u_offset_nT for closure in run.closures)
    u = float(np.sqrt(max(stated**2 - whole**2, 0.0)))
    return replace(run, reference=replace(run.reference, u_offset_nT=u))


def _mountings(run: Run) -> Sequence[NDArray[np.bool_]]:
    """The rows (n,) of each mounting, where there are several."""
    names = np.array([segment.mounting or f"#{index}" for index, segment in enumerate(run.segments)])
    of_rows = names[run.segment_index]
    seen = [of_rows == name for name in dict.fromkeys(names.tolist())]
    seen = [rows for rows in seen if rows.any()]
    return seen if len(seen) > 1 else []
