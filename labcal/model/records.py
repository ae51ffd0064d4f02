"""What a calibration says of an effect and of where it holds (contract: EFFECT, validity)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from labcal.model.smooth import Basis, Domain

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
    group: str = ""  # the set of channels that it was accepted with
    inputs: tuple[str, ...] = ()  # of an empirical term
    basis: Basis | None = None  # of an empirical term
    domain: tuple[Domain, ...] = ()  # where it has been seen


@dataclass(frozen=True, slots=True)
class Validity:
    """The range that the run covered; outside it a corrected row is flagged and its uncertainty grows."""

    field_nT: tuple[float, float]
    temperature_C: tuple[float, float] | None = None
    modes: tuple[str, ...] = ()
    until: str | None = None  # ISO date
