"""How heavy the heaviest of all candidates would come out by chance: a maximum over surrogates of the residual.

What the accepted effects leave is whitened by the noise that was fitted to it; its cosine coefficients then get random
signs. That keeps the spectrum and takes away any tie to time, field and channels (phase randomisation, Theiler et al.,
Physica D 58, 77, 1992, in the cosine transform). Every look of every cause is scored on each surrogate, so that the
search that was made is corrected for as it was made: delays, time constants and likenesses among candidates included.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import Search, Weighed
from labcal.loop.noise.whitening import Whitened
from labcal.loop.parallel import each

Array = NDArray[np.float64]
SURROGATES = 100
TAIL = 0.2  # of the surrogates: their excess over the rest is taken as exponential


def by_chance(search: Search, accepted: Sequence[Candidate], seed: int = 0) -> Array:
    """The largest weight of any candidate (surrogates,) [nats] on residuals with nothing in them but their noise."""
    noise = Whitened.of(search.stage(accepted))
    drawn = noise.drawn(np.random.default_rng(seed).choice([-1.0, 1.0], size=(len(noise.left), SURROGATES)))
    heaviest = np.full(SURROGATES, -np.inf)
    found = each(lambda group: noise.gains(search.moved_each(group), drawn), search.standing)
    for group, gains in zip(search.standing, found, strict=True):
        for candidate, gain, new in zip(group.candidates, *gains, strict=True):
            if new:
                heaviest = np.maximum(heaviest, gain - search.price(candidate, int(new)))
    return np.sort(heaviest)


def p_value(weighed: Weighed, heaviest: Array) -> float:
    """How often chance alone would give a candidate of this weight: by counting, beyond that by an exponential tail."""
    edge = heaviest[int((1 - TAIL) * len(heaviest))]
    if weighed.rank == 0:
        return 1.0
    if weighed.weight <= edge:
        return float((1 + np.sum(heaviest >= weighed.weight)) / (1 + len(heaviest)))
    excess = max(float(np.mean(heaviest[heaviest >= edge] - edge)), 1.0)
    return float(TAIL * np.exp((edge - weighed.weight) / excess))
