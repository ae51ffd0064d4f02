"""What is left of a device whose noise nobody has stated, where it is that noise: with its own short memory.

Successive differences show the white part of a noise alone. What remembers itself for a few rows, is normally
distributed, and goes with nothing that is recorded, is noise as well: no calibration could take it off.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.findings.residual_tests import residual_tests
from labcal.loop.noise.autocorrelation import correlation_time_s, serially_correlated
from labcal.loop.selection.crossval import BLOCKS, CORRELATION_TIMES, rms
from labcal.loop.selection.joint_fit import JointFit
from labcal.loop.selection.proof import Evidence

Array = NDArray[np.float64]
KURTOSIS = 3.0  # of a normal distribution,
VARIANCE_OF_SKEWNESS, VARIANCE_OF_KURTOSIS = 6.0, 24.0  # and of n draws from it, times n


def coloured_floor(found: Evidence, after: JointFit) -> NoiseFloor | None:
    """The floor with the memory of the noise in it; None where it is known, has none, or more than noise is left."""
    level, problem, rows = found.level, after.problem, found.pool.valid
    t, y, segment = problem.scene.t_s[rows], problem.y[rows], problem.scene.segment[rows]
    if level.source != "differences" or not serially_correlated(y, segment):
        return None
    row_s = float(np.median(np.diff(t)))
    memory_s = correlation_time_s(t, y)
    if CORRELATION_TIMES * BLOCKS * memory_s > row_s * len(t) or not is_normal(y, max(1, round(2 * memory_s / row_s))):
        return None
    if not all(test.passes for test in residual_tests(problem, rows) if test.test != "whiteness"):
        return None
    independent = y.size * min(1.0, row_s / (2 * memory_s)) if memory_s > 0 else y.size
    share = min((problem.T.shape[2] + sum(map(len, after.beta))) / independent, 0.5)
    left = rms(problem.length_nT(problem.residual_nT)[rows])
    return replace(level, nT=left * float(np.sqrt((1 + share) / (1 - share))), memory_s=memory_s)


def is_normal(y: Array, step: int) -> bool:
    """Whether every `step`-th row of y (n, q) may be normally distributed (Jarque & Bera, Int. Stat. Rev. 55, 1987)."""
    from scipy.special import chdtrc

    z = y[::step] - y[::step].mean(axis=0)
    z = z / np.maximum(z.std(axis=0), 1e-300)
    skewness, excess = np.mean(z**3, axis=0), np.mean(np.square(z**2), axis=0) - KURTOSIS
    statistic = len(z) * float(np.sum(skewness**2 / VARIANCE_OF_SKEWNESS + excess**2 / VARIANCE_OF_KURTOSIS))
    return bool(chdtrc(2 * y.shape[1], statistic) >= policy.POLICY.significance)
