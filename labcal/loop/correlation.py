"""How long a residual remembers itself."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from labcal.loop.search import Candidate, Search
from labcal.loop.whiteness import CHANCE, LAGS, MATERIAL


def correlation_s(search: Search, accepted: Sequence[Candidate]) -> float:
    """Time over which the residual forgets itself: the first lag at which its correlation is below 1/e."""
    left = search.residual(accepted)
    left = left - left.mean(axis=0)
    n = len(left)
    power = np.sum(np.abs(np.fft.rfft(left, n=2 * n, axis=0)) ** 2, axis=1)
    correlation = np.fft.irfft(power)[: n // 4]
    below = np.flatnonzero(correlation < correlation[0] / np.e)
    return float(below[0] if len(below) else n // 4) * float(np.median(np.diff(search.problem.scene.t_s)))


def follows_itself(search: Search, accepted: Sequence[Candidate]) -> bool:
    """Whether the residual correlates materially with its past rows in a segment (Ljung & Box, Biometrika 65, 1978)."""
    from scipy.special import chdtrc

    left = search.everywhere(accepted)[0] * search.good[:, None]
    segment, size = search.whole.scene.segment, left.size
    total, statistic, most = float(np.sum(left**2)), 0.0, 0.0
    for lag in range(1, LAGS + 1):
        within = segment[lag:] == segment[:-lag]
        correlation = float(np.sum(left[lag:][within] * left[:-lag][within])) / total
        statistic += size * (size + 2) * correlation**2 / (size - lag)
        most = max(most, correlation**2)
    return bool(chdtrc(LAGS, statistic) < CHANCE) and most >= MATERIAL
