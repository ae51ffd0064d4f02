"""A calibration: the affine map, the effects, and where they hold (contract: calibration file)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.model.affine import AffineMap
from labcal.record import Dut

Array = NDArray[np.float64]
Owner = Literal["sensor", "rig", "data"]


@dataclass(frozen=True, slots=True)
class Parameter:
    """A number with its standard uncertainty and unit."""

    name: str
    value: float
    u: float
    unit: str


@dataclass(frozen=True, slots=True)
class Rival:
    """An effect that explains the same run about as well."""

    effect: str
    channels: tuple[str, ...]
    holdout_rms_after_nT: float


@dataclass(frozen=True, slots=True)
class EffectRecord:
    """One effect as decided: what it is, what it costs, what it brought (contract: EFFECT)."""

    effect: str
    channels: tuple[str, ...]
    reference_value: Mapping[str, float]
    belongs_to: Owner
    parameters: tuple[Parameter, ...]
    provisional: bool = False
    holdout_rms_before_nT: float | None = None
    holdout_rms_after_nT: float | None = None
    improvement_ci95_nT: tuple[float, float] | None = None
    p_value: float | None = None
    rivals: tuple[Rival, ...] = ()
    why: str = ""


@dataclass(frozen=True, slots=True)
class Validity:
    """The range that the run covered; outside it a corrected row is flagged and its uncertainty grows."""

    field_nT: tuple[float, float]
    temperature_C: tuple[float, float] | None = None
    modes: tuple[str, ...] = ()
    until: str | None = None  # ISO date


@dataclass(frozen=True, slots=True, eq=False)
class Calibration:
    """What ships: map, covariance (12, 12) of (K row by row, k), the sensor's effects, and the findings."""

    run_id: str
    simulated: bool
    dut: Dut
    affine: AffineMap
    covariance: Array | None
    frame_known: bool
    validity: Validity
    span_s: tuple[float, float]
    run_sha256: str
    effects: tuple[EffectRecord, ...] = ()  # the sensor's
    findings: tuple[EffectRecord, ...] = ()  # the rig's and the data's
    metrics: Mapping[str, Mapping[str, float]] = field(default_factory=dict)  # {"before": …, "after": …}
    instruments: tuple[Mapping[str, str], ...] = ()
    cage_sha256: str | None = None
    supersedes: str | None = None
    software: str = ""
    operator: str = ""
    approvers: tuple[str, ...] = ()
