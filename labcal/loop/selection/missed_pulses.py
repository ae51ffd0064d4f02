"""Loads that came and went between two samples of their telemetry: rows that stand out as the load would.

A wild reading lies anywhere. One whose distance from its neighbours is along an accepted load's own field, and no
farther than the load has ever been, is that load, which the channel missed: no fault of the data.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet
from labcal.model.effects import Family, Scene, Term
from labcal.model.effects.regressors import WEATHER

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


def missed_pulses(pool: CandidateSet, accepted: Sequence[Candidate]) -> Mask:
    """Rows (N,) of the whole problem that are set aside, and are as a load at another of its levels would have them.

    Of vectors alone: a magnitude has one direction, which is everybody's.
    """
    out = np.zeros(len(pool.valid), dtype=bool)
    if pool.valid.all() or pool.whole.y.shape[1] < 2:
        return out
    left = pool.residual_everywhere(accepted)[0]
    for term, beta in _prompt_loads(pool, accepted):
        now, *ends = (pool.whole.whitened(term.columns(scene)) @ beta for scene in _at_its_ends(pool, term))
        low, high = max(((a, b) for a in ends for b in ends), key=lambda pair: float(np.sum((pair[1] - pair[0]) ** 2)))
        out |= ~pool.valid & _lies_between(left + now, low, high)
    return out


def _prompt_loads(pool: CandidateSet, accepted: Sequence[Candidate]) -> Iterator[tuple[Term, Array]]:
    """Each accepted form that follows one switched channel at once, with its parameters."""
    x, start = pool.coefficients(accepted), pool.whole.T.shape[2]
    for part in (part for chosen in accepted for part in chosen.parts):
        size = len(part.term.parameters)
        if _is_prompt_load(pool, part.family, part.term):
            yield part.term, x[start : start + size]
        start += size


def _is_prompt_load(pool: CandidateSet, family: Family, term: Term) -> bool:
    switched = len(term.channels) == 1 and pool.whole.run.channel(term.channels[0]).quantity not in WEATHER
    return switched and family.reach_s(term) is None


def _at_its_ends(pool: CandidateSet, term: Term) -> Iterator[Scene]:
    """The scene as it is; then with the channel at its least, at its largest, and as near to nothing as it comes."""
    scene, name = pool.whole.scene, term.channels[0]
    yield scene
    values = scene.channels[name]
    for end in (values.min(), values.max(), values[np.argmin(np.abs(values))]):
        yield replace(scene, channels={**scene.channels, name: np.full_like(values, end)})


def _lies_between(rows: Array, low: Array, high: Array) -> Mask:
    """Rows (n, q) on the way from `low` to `high`, each within what makes an outlier."""
    near, way = policy.POLICY.outlier_sigmas, high - low
    length = np.maximum(np.linalg.norm(way, axis=1), 1e-300)
    along = np.sum((rows - low) * way, axis=1) / length
    beside = np.linalg.norm(rows - low - (along / length)[:, None] * way, axis=1)
    return np.asarray((beside <= near) & (along >= -near) & (along <= length + near))
