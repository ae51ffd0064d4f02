"""What every estimator returns (contract: FIT)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.model import AffineMap, EffectRecord
from labcal.model.affine import MAP_PARAMETERS
from labcal.uncertainty import Sources

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """One method's answer, or why it gives none (`ok` False, `why_not` a sentence, `affine` None).

    `covariance` (12, 12) orders K row by row, then k; where the frame is not known K is symmetric and the
    covariance has rank 9. `bias_nT` and `D` are b and D of Crassidis, Lai & Harman 2003, (1), where the method has
    them (then b is k); else `bias_nT` is the reading at zero field, K⁻¹ k.
    """

    method: str
    ok: bool
    why_not: str | None = None
    affine: AffineMap | None = None
    covariance: Array | None = None
    frame_known: bool = False
    bias_nT: Array | None = None
    D: Array | None = None
    rms_scalar_nT: float | None = None
    holdout_rms_scalar_nT: float | None = None
    axis_error_deg: tuple[float, ...] | None = None
    seconds: float = 0.0
    effects: tuple[EffectRecord, ...] = ()
    phase_rad: Array | None = None  # the starting phases found, one per group of `record.carry(run)`
    covariance_of: tuple[str, ...] = MAP_PARAMETERS  # beyond the map: "0:c_x", by the sensor's effects in their order
    sources: Sources | None = None  # what `covariance` is made of, where the method tells it apart
    left_open: str | None = None  # where magnitudes alone determine it: what the vectors do not, a sentence
    noise_nT: float | None = None  # standard deviation of one axis of one reading, estimated
    remarks: tuple[str, ...] = ()  # what its uncertainty does not tell, for whoever signs it, a sentence each
    metrics: Mapping[str, Mapping[str, float]] | None = (
        None  # before and after, of the closed loop: a draft states them
    )
