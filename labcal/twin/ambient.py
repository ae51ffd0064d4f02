"""The field of the place without the coils: Earth, slow drift, mains."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
WAVES = 5


@dataclass(frozen=True, slots=True)
class Ambient:
    """Earth's field plus slow waves of random period and direction, and the mains."""

    earth_nT: Array  # (3,) in C
    waves_nT: Array  # (WAVES, 3)
    periods_s: Array  # (WAVES,)
    phases: Array  # (WAVES,)
    mains_nT: Array  # (3,) amplitude
    mains_hz: float

    def slow(self, t_s: Array) -> Array:
        """Earth and drift (n, 3) [nT, C]."""
        turns = 2 * np.pi * t_s[:, None] / self.periods_s + self.phases
        return np.asarray(self.earth_nT + (np.sin(turns) - np.sin(self.phases)) @ self.waves_nT)

    def mains(self, t_s: Array, bandwidth_hz: float) -> Array:
        """What a first-order sensor of this bandwidth passes of the mains (n, 3) [nT, C]."""
        passed = 1 / np.hypot(1, self.mains_hz / bandwidth_hz)
        return np.asarray(passed * np.sin(2 * np.pi * self.mains_hz * t_s)[:, None] * self.mains_nT)


def ambient(
    rng: np.random.Generator, earth_nT: Array, drift_nT: float, mains_nT: float, mains_hz: float = 50.013
) -> Ambient:
    """An ambient with drift of about `drift_nT` (one standard deviation, each axis) over an hour."""
    waves = rng.normal(size=(WAVES, 3)) * drift_nT * np.sqrt(2 / WAVES)
    direction = rng.normal(size=3)
    return Ambient(
        np.asarray(earth_nT, dtype=float),
        waves,
        np.exp(rng.uniform(np.log(300), np.log(7200), WAVES)),
        rng.uniform(0, 2 * np.pi, WAVES),
        mains_nT * direction / np.linalg.norm(direction),
        mains_hz,
    )
