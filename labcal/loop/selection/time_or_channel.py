"""What goes by the run's time alone, against a smooth function of a channel: what readings can correct goes first.

A bent function of a channel that wanders slowly is, in one run, nearly a drift with a line or two beside it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate, Span
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.noise.bands import cosine_transform
from labcal.loop.selection.misfit import bends, evidence_over_misfit, likeliest
from labcal.model.effects.regressors import moving, on_each_axis

Array = NDArray[np.float64]
HYPERPARAMETERS = 1  # of a smooth function: its size


def is_of_time(pool: CandidateSet, accepted: Sequence[Candidate], chosen: Candidate) -> bool:
    """Whether a cause that is bound to the run's time is no smooth function of a channel; true of all others.

    It is one where such a function leads in its place, and leaves it without the evidence of a name.
    """
    if not chosen.family.bound_to_run:
        return True
    law, null = policy.POLICY, pool.null_model(accepted)
    enough = null.null.log + pool.score(chosen, null).evidence + law.equivalent_nats
    spans = _of_each_channel(pool)
    penalty = 0.5 * HYPERPARAMETERS * np.log(pool.n_data) + np.log(max(len(spans), 1))
    leading = (span for span in spans if likeliest(null, [span]) - penalty >= enough)
    return all(evidence_over_misfit(pool, accepted, chosen, [span]) >= law.min_evidence for span in leading)


def _of_each_channel(pool: CandidateSet) -> list[Span]:
    """A smooth function of each of the device's channels that move."""

    def made() -> list[Span]:
        whole = pool.whole
        names = [c.name for c in moving(whole.run, {c.quantity for c in whole.run.channels})]
        return [_span(pool, whole.scene.channels[name]) for name in names]

    return pool.cached("smooth in each channel", (), made)


def _span(pool: CandidateSet, values: Array) -> Span:
    columns = np.concatenate([on_each_axis(bend) for bend in bends(values).T], axis=2)
    return Span(cosine_transform(pool.problem.whitened(columns)[pool.transformed_rows]))
