"""The null distribution of the largest evidence among all candidates, over surrogates of the residual.

What the accepted effects leave is whitened by the noise that was fitted to it; its cosine coefficients then get random
signs. That keeps the spectrum and removes any relation to time, field and channels (phase randomisation, Theiler et
al., Physica D 58, 77, 1992, in the cosine transform). Every candidate is scored on each surrogate, so that the
multiplicity of the search is corrected for as it was made: delays, time constants and correlated candidates included.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.noise.whitening import WhitenedNull
from labcal.loop.parallel import parallel_map

Array = NDArray[np.float64]
SURROGATES = 100
TAIL = 0.2  # of the surrogates: their excess over the rest is taken as exponential


def null_distribution(pool: CandidateSet, accepted: Sequence[Candidate], seed: int = 0) -> Array:
    """The largest evidence of any candidate (surrogates,) [nats], sorted, on residuals that hold noise alone."""
    noise = WhitenedNull.of(pool.null_model(accepted))
    surrogates = noise.surrogates(
        np.random.default_rng(seed).choice([-1.0, 1.0], size=(len(noise.residual), SURROGATES))
    )
    largest = np.full(SURROGATES, -np.inf)
    found = parallel_map(lambda group: noise.gains(pool.transformed_group(group), surrogates), pool.store.groups)
    for group, gains in zip(pool.store.groups, found, strict=True):
        for candidate, gain, new in zip(group.candidates, *gains, strict=True):
            if new:
                largest = np.maximum(largest, gain - pool.penalty(candidate, int(new)))
    return np.sort(largest)


def p_value(scored: Scored, null_distribution: Array) -> float:
    """How often chance alone gives a candidate this evidence: by counting, beyond that by an exponential tail."""
    edge = null_distribution[int((1 - TAIL) * len(null_distribution))]
    if scored.rank == 0:
        return 1.0
    if scored.evidence <= edge:
        return float((1 + np.sum(null_distribution >= scored.evidence)) / (1 + len(null_distribution)))
    excess = max(float(np.mean(null_distribution[null_distribution >= edge] - edge)), 1.0)
    return float(TAIL * np.exp((edge - scored.evidence) / excess))
