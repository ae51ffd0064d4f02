"""All that makes the parameters of a calibration uncertain, source by source, each independent of the others."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.uncertainty.contribution import Contribution, covariance_of
from labcal.uncertainty.fit_noise import FitNoise

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Sources:
    """The run's noise, and what the run declares of its reference and mounting, over the same p parameters."""

    noise: FitNoise
    declared: tuple[Contribution, ...]
    beside_declared: float = 1.0  # part of the residual's square that no declared error can have left

    @property
    def covariance(self) -> Array:
        """All together (p, p)."""
        return np.asarray(self.noise.covariance + covariance_of(self.declared, self.noise.each.shape[1]))

    def fewest_dof(self) -> float:
        """The fewest effective degrees of freedom of any parameter (Welch and Satterthwaite; GUM, G.4.1)."""
        whole, of_noise = np.diag(self.covariance), np.diag(self.noise.covariance)
        axes = np.eye(len(whole))
        found = [
            self.noise.dof_of(axes[i]) * (whole[i] / of_noise[i]) ** 2 for i in range(len(whole)) if of_noise[i] > 0
        ]
        return float(min(found, default=np.inf))
