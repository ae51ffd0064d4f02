"""A three-axis magnetometer: scale, non-orthogonality, misalignment, bias, noise, quantisation, saturation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.geometry import rotation_vector

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Sensor:
    """reading · nT_per_unit = response @ field + bias + noise, quantised, clipped at the range."""

    response: Array  # (3, 3)
    bias_nT: Array  # (3,)
    noise_nT: float  # standard deviation of one axis of one sample
    nT_per_unit: float
    step_units: float  # of the converter, in reading units
    range_nT: float
    bandwidth_hz: float

    def read(self, field_nT: Array, rng: np.random.Generator) -> Array:
        """Readings (n, 3) in the sensor's unit of the field (n, 3) [nT] in its body axes."""
        analogue = field_nT @ self.response.T + self.bias_nT + self.noise_nT * rng.standard_normal(field_nT.shape)
        steps = np.round(np.clip(analogue, -self.range_nT, self.range_nT) / self.nT_per_unit / self.step_units)
        return np.asarray(steps * self.step_units)


def response(scale: Array, nonorthogonality_deg: Array, misalignment_deg: Array) -> Array:
    """Response (3, 3): row i is the sensitivity of axis i, its length the scale factor.

    `nonorthogonality_deg` (3,): y towards x, z towards x, z towards y; `misalignment_deg` (3,) a rotation vector.
    """
    yx, zx, zy = np.sin(np.radians(nonorthogonality_deg))
    axes = np.array([[1, 0, 0], [yx, np.sqrt(1 - yx**2), 0], [zx, zy, np.sqrt(1 - zx**2 - zy**2)]])
    return np.asarray(np.diag(scale) @ axes @ rotation_vector(np.radians(misalignment_deg)))
