"""A calibration: the affine map, the effects, and where they hold (contract: calibration file)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.model.affine import MAP_PARAMETERS, AffineMap
from labcal.model.records import EffectRecord, Validity
from labcal.record import Dut, Run

if TYPE_CHECKING:
    from labcal.model.readings import Applied

Array = NDArray[np.float64]
Format = Literal["labcal-calibration/1", "labcal-calibration/2"]
UNEXPLAINED = "Unexplained by the closed loop"  # as `not_covered` begins where that was the loop's verdict


@dataclass(frozen=True, slots=True, eq=False)
class Calibration:
    """What ships: map, the sensor's effects, the joint covariance of both, and the findings.

    `covariance` is of the parameters `covariance_of` (contract): K row by row, k, then "0:c_x" for c_x of the first
    effect. Parameters that are not there (version 1 has none but the map's) count as independent, with their own u.
    """

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
    format: Format = "labcal-calibration/2"
    covariance_of: tuple[str, ...] = MAP_PARAMETERS
    k_at: Mapping[str, float] = field(default_factory=dict)  # the channels' values that k belongs to
    budget: tuple[Mapping[str, Any], ...] = ()
    not_covered: tuple[str, ...] = ()
    specification: tuple[Mapping[str, Any], ...] = ()
    made_by: Mapping[str, Any] | None = None
    chain: Mapping[str, Any] | None = None
    number: str | None = None
    issued_utc: str | None = None

    def joint_covariance(self) -> Array:
        """Of K row by row, k, then every parameter of every effect in their order; a map without one has zeros."""
        effects = [(f"{i}:{p.name}", p.u) for i, effect in enumerate(self.effects) for p in effect.parameters]
        names = [*MAP_PARAMETERS, *(name for name, _ in effects)]
        joint = np.diag([0.0] * len(MAP_PARAMETERS) + [u**2 for _, u in effects])
        if self.covariance is not None:
            place = [names.index(name) for name in self.covariance_of]
            joint[np.ix_(place, place)] = self.covariance
        return joint

    def not_measured(self) -> tuple[str, ...]:
        """Those of K and k that were held as they stand: without any variance. Empty where none states a covariance."""
        if self.covariance is None:
            return ()
        variance = dict(zip(self.covariance_of, np.diag(self.covariance), strict=True))
        return tuple(name for name in MAP_PARAMETERS if not variance.get(name, 1.0) > 0)

    def unexplained(self) -> str:
        """That the loop which made it found no cause for what is left, a sentence; "" else."""
        return next((said for said in self.not_covered if said.startswith(UNEXPLAINED)), "")

    def k_means(self) -> str:
        """What k belongs to, as "at i_eps = 0.0532 A"; empty where it depends on no channel."""
        return k_means(self.effects, self.k_at)

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
            time domain.

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


def k_means(effects: Sequence[EffectRecord], k_at: Mapping[str, float] | None = None) -> str:
    """What k belongs to beside these effects, as "at i_eps = 0.0532 A"; empty where it depends on no channel."""
    effects = [effect for effect in effects if effect.basis is None]  # that is zero on the mean, nowhere by itself
    stated = {name: value for effect in effects for name, value in effect.reference_value.items()}
    units = units_of_channels(effects)
    said = [
        f"{name} = {value:.4g} {units.get(name, '')}".rstrip() for name, value in {**stated, **(k_at or {})}.items()
    ]
    return f"at {', '.join(said)}" if said else ""


def units_of_channels(effects: Sequence[EffectRecord]) -> dict[str, str]:
    """The unit of each channel that drives an effect, as it is printed; empty where it is open."""
    return {name: _unit_of_drive(effect) for effect in effects for name in effect.channels[:1]}


def _unit_of_drive(effect: EffectRecord) -> str:
    """The unit of the channel that drives an effect of so much per unit: of nT/A it is A; empty where that is open."""
    units = {p.unit.removeprefix("nT/") for p in effect.parameters if p.unit.startswith("nT/")}
    unit = units.pop() if len(units) == 1 else ""
    return unit.replace("degC", "°C") if unit.isalpha() else ""
