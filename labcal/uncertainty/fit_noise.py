"""What a run's noise leaves uncertain in fitted parameters, and how well that uncertainty itself is known."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
NEGLIGIBLE = 1e-9  # part of every variance


@dataclass(frozen=True, slots=True, eq=False)
class FitNoise:
    """The covariance of fitted parameters under each model of the noise, and the odds of the models.

    One model is a covariance whose level the residual showed, with so many degrees of freedom.
    """

    weight: Array  # (models,) adds up to one
    each: Array  # (models, p, p)
    dof: float  # of the level under any one model

    @classmethod
    def of(cls, weight: Array, each: Array, dof: float) -> FitNoise:
        """The models that count in any variance."""
        part = weight[:, None] * np.einsum("mii->mi", each)
        kept = (part > NEGLIGIBLE * part.sum(axis=0)).any(axis=1)
        return cls(weight[kept] / weight[kept].sum(), each[kept], max(dof, 1.0))

    @classmethod
    def single(cls, covariance: Array, dof: float) -> FitNoise:
        """One model."""
        return cls(np.ones(1), covariance[None], max(dof, 1.0))

    @property
    def covariance(self) -> Array:
        """The mean over the models (p, p)."""
        return np.asarray(np.tensordot(self.weight, self.each, axes=1))

    def onto(self, B: Array) -> FitNoise:
        """Of the parameters B x (q, p)."""
        return FitNoise(self.weight, B @ self.each @ B.T, self.dof)

    def dof_of(self, sensitivity: Array) -> float:
        """Degrees of freedom of the variance v of what depends on the parameters by `sensitivity` (p,).

        2 v² / Var(v) (GUM, G.3: ν = ½ (Δu/u)⁻², with v = u²). Var(v) has two parts: the level's under each model, and
        how far the models, by their odds, differ in v.
        """
        v = self.each @ sensitivity @ sensitivity
        mean = float(self.weight @ v)
        spread = float(self.weight @ (2 * v**2 / self.dof + (v - mean) ** 2))
        return 2 * mean**2 / spread if spread > 0 else self.dof
