"""Sensor offset that follows a housekeeping channel of no special kind (voltage, power, pressure …)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Self

import numpy as np

from labcal.model.calibration import EffectRecord
from labcal.model.effects.protocol import Array, Family, Scene, Shape
from labcal.record import Run
from labcal.record.run import Channel

OTHER = ("voltage", "power", "rate", "pressure", "humidity", "count", "other")
AXES = ("x", "y", "z")


@dataclass(frozen=True, slots=True)
class OffsetChannel:
    """e = c (q − q_ref), one c per body axis [nT of B per unit of the channel]."""

    channel: str
    unit: str
    reference: float
    shape: tuple[Shape, ...] = field(default=())

    @property
    def channels(self) -> tuple[str, ...]:
        """The one channel."""
        return (self.channel,)

    @property
    def reference_value(self) -> dict[str, float]:
        """Where the channel counts as zero."""
        return {self.channel: self.reference}

    @property
    def parameters(self) -> tuple[tuple[str, str], ...]:
        """One slope per axis."""
        return tuple((f"c_{axis}", f"nT/{self.unit}") for axis in AXES)

    def reshaped(self, **values: float) -> Self:
        """Nothing to reshape."""
        return replace(self)

    def columns(self, scene: Scene) -> Array:
        """(n, 3, 3)."""
        return np.asarray((scene.channels[self.channel] - self.reference)[:, None, None] * np.eye(3))


def varies(channel: Channel) -> bool:
    """Whether a channel of the sensor's side moves at all and is known for at least half of the rows."""
    known = channel.values[np.isfinite(channel.values)]
    return (
        channel.role == "dut" and 2 * len(known) >= len(channel.values) and len(known) > 0 and float(np.ptp(known)) > 0
    )


def candidates(run: Run) -> list[OffsetChannel]:
    """One form for each channel that moves."""
    return [
        OffsetChannel(c.name, c.unit, float(np.nanmedian(c.values)))
        for c in run.channels
        if c.quantity in OTHER and varies(c)
    ]


def restore(record: EffectRecord) -> OffsetChannel:
    """From a calibration file."""
    (name,) = record.channels
    return OffsetChannel(name, record.parameters[0].unit.removeprefix("nT/"), record.reference_value[name])


FAMILY = Family(
    "offset-channel", "sensor", candidates, restore, "hold the attitude and step the quantity that the channel measures"
)
