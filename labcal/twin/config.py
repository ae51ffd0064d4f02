"""The table [twin] of a bench.toml: the simulated lab as it truly is, which is not what the bench believes."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

Positive = Annotated[float, Field(gt=0, allow_inf_nan=False)]
NotNegative = Annotated[float, Field(ge=0, allow_inf_nan=False)]
Vector = tuple[float, float, float]
Matrix = tuple[Vector, Vector, Vector]


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class CoilsTruth(_Table):
    """Square coil pairs; `tilt_deg` (3, 3): each axis' rotation vector away from its ideal direction; `exact`: their
    field from the wires at every place, else to first order from the centre; `imbalance`: the half towards + makes so
    much more than the other.
    """

    side_m: Positive = 1.5
    turns: int = Field(default=46, ge=1)
    tilt_deg: Matrix = ((0.0, 0.21, -0.34), (0.17, 0.0, 0.26), (-0.12, 0.19, 0.0))
    resistance_ohm: Positive = 6.0
    tau_s: Positive = 0.02
    residual_A: NotNegative = 0.0004
    exact: bool = False
    imbalance: Vector = (0.0, 0.0, 0.0)


class AmbientTruth(_Table):
    """The place: `drift_nT` is one standard deviation over an hour, `mains_nT` the amplitude at 50 Hz."""

    earth_nT: Vector = (20_400.0, 1_150.0, -43_700.0)
    drift_nT: NotNegative = 15.0
    mains_nT: NotNegative = 20.0


class PlatformTruth(_Table):
    """The turntable."""

    accel_deg_per_s2: Positive = 5.0
    wobble_deg: NotNegative = 0.003
    misreading_deg: NotNegative = 0.0  # of a dial turned by hand: half the width of a rectangle
    axis_cage: Vector = (0.0, 0.0, 1.0)


class SensorTruth(_Table):
    """A magnetometer."""

    scale: Vector = (1.0, 1.0, 1.0)
    nonorthogonality_deg: Vector = (0.0, 0.0, 0.0)
    misalignment_deg: Vector = (0.0, 0.0, 0.0)
    bias_nT: Vector = (0.0, 0.0, 0.0)
    noise_nT: NotNegative = 3.0
    nT_per_unit: Positive = 1.0
    step_units: Positive = 1.0
    range_nT: Positive = 200_000.0
    bandwidth_hz: Positive = 5.0


class HousekeepingTruth(_Table):
    """The spacecraft's loads by channel: the current of each when on."""

    loads_A: dict[Annotated[str, Field(pattern=r"^i_\w+$")], Positive] = {
        "i_eps": 0.42,
        "i_payload": 0.65,
        "i_radio": 0.30,
    }
    period_s: Positive = 60.0


class TwinTruth(_Table):
    """The whole lab. `effects` by name with their parameters; `surprise` lets the seed pick one and tells nobody."""

    coils: CoilsTruth = CoilsTruth()
    ambient: AmbientTruth = AmbientTruth()
    platform: PlatformTruth = PlatformTruth()
    reference: SensorTruth = SensorTruth(
        scale=(1.00004, 0.99997, 1.00002), noise_nT=2.5, nT_per_unit=1e5 / 15000, range_nT=200_000.0
    )
    reference_place_m: Vector = (0.0, 0.0, 0.15)
    dut_place_m: Vector = (0.0, 0.0, 0.0)
    dut: SensorTruth = SensorTruth(
        scale=(1.013, 0.985, 1.022),
        nonorthogonality_deg=(0.7, -0.5, 0.9),
        misalignment_deg=(0.6, -0.4, 0.8),
        bias_nT=(1850.0, -2400.0, 950.0),
        noise_nT=15.0,
        nT_per_unit=4.0,
        range_nT=100_000.0,
    )
    mounting_error_deg: NotNegative = 0.0
    placing_error_m: NotNegative = 0.0  # of each coordinate of a reference that is moved: one standard deviation
    housekeeping: HousekeepingTruth = HousekeepingTruth()
    effects: dict[str, dict[str, Any]] = {}
    surprise: bool = False
