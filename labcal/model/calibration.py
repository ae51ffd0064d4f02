"""A calibration: the affine map, the effects, and where they hold (contract: calibration file)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.model.affine import AffineMap
from labcal.record import Dut, Run

if TYPE_CHECKING:
    from labcal.model.readings import Applied

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

    def apply(
        self,
        reading: ArrayLike | Run,
        *,
        t_s: ArrayLike | None = None,
        segment: ArrayLike | None = None,
        mode: ArrayLike | None = None,
        channels: Mapping[str, ArrayLike] | None = None,
    ) -> Applied:
        """Calibrate readings: b = K m - k less the sensor's effects, with an uncertainty in every row.

        Parameters
        ----------
        reading : array_like, shape (n, 3) or (3,), or Run
            Readings m in `dut.unit`, body axes; NaN is missing. A run brings all that is below.
        t_s : array_like, shape (n,), optional
            Time in s, on the run's clock where effects are bound to it.
        segment, mode : array_like of str, shape (n,), optional
            Segments, which are boundaries for effects that remember, and power modes.
        channels : mapping of str to array_like, shape (n,), optional
            Housekeeping that the effects follow, in the units of the run.

        Returns
        -------
        Applied
            `field_nT` (n, 3) in body axes, `u_nT` (n,), the standard uncertainty of one component with the noise
            included, and `flags` (n,), empty or words apart by spaces: saturated outlier field temperature rate mode
            time.

        Raises
        ------
        InputError
            A column that the effects need is missing, or one has another shape than the readings.

        Examples
        --------
        >>> import labcal
        >>> calibration = labcal.load_calibration("examples/short-preflight/calibration.json")
        >>> steady = [[5_000.0, 0.0, 7_500.0]] * 5  # counts of 4 nT
        >>> corrected = calibration.apply(steady, t_s=range(5), segment=["a"] * 5, channels={"i_radio": [0.1] * 5})
        >>> corrected.field_nT.shape, corrected.u_nT.shape
        ((5, 3), (5,))
        >>> run = labcal.load_run("examples/short-preflight/run.zip")
        >>> calibration.apply(run).field_nT.shape
        (1321, 3)
        """
        from labcal.model.apply import apply  # which is built on this file
        from labcal.model.readings import readings_of

        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is no number, and says so in its row
            return apply(self, readings_of(reading, t_s, segment, mode, channels))
