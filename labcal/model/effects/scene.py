"""What an effect acts in: field, channels and modes row by row, and what only the rig knows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects.past import Past

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Rig:
    """What only a run with a vector reference knows (n rows): needed by effects of the rig, absent in `apply`."""

    prediction_nT: Array  # (n, 3) p, the reference carried into B
    reference_nT: Array  # (n, 3) the reference in C
    to_body: Array  # (n, 3, 3) p = to_body @ reference; NaN where the reference is given in B
    axis_body: Array  # (n, 3) NaN where there is no platform axis
    axis_cage: Array  # (n, 3)
    angle_rad: Array  # (n,) platform angle, unwrapped within a segment; NaN where there is none
    mounting: NDArray[np.intp]  # (n,) rows of one mounting share an unknown phase and tilt


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """All that an effect may look at, row by row (n rows, in time order)."""

    t_s: Array  # (n,) the run's clock
    segment: NDArray[np.intp]  # (n,) a change is a boundary for delays, derivatives and hysteresis
    field_nT: Array  # (n, 3) a = K m − k, in B
    channels: Mapping[str, Array] = field(default_factory=dict)  # each (n,), in its unit
    mode: NDArray[np.str_] | None = None  # (n,)
    axes: Array = field(default_factory=lambda: np.eye(3))  # (3, 3) K per nominal unit: column i moves with reading i
    rig: Rig | None = None
    denoised_field_nT: Array | None = None  # (n, 3) a at the estimated true reading, where a fit knows it
    past: Past | None = None  # where the rows are a piece of a recording (`Family.in_pieces`)
    of_the_fit: bool = False  # whether they are the fit's own, whose segments its parameters may speak of

    def __len__(self) -> int:
        return len(self.t_s)

    @property
    def along_axes_nT(self) -> Array:
        """The driving field along the sensor's own axes (n, 3) [nT], so that field = axes @ along_axes."""
        return self.on_axes(self.driving_field_nT)

    @property
    def driving_field_nT(self) -> Array:
        """The field (n, 3) [nT] that drives an effect: without the readings' noise as far as a fit knows it.

        A curve that nearly undoes the map would take that noise off itself, and so would a gain that hardly changes.
        """
        return self.field_nT if self.denoised_field_nT is None else self.denoised_field_nT

    def on_axes(self, field_nT: Array) -> Array:
        """A field (n, 3) along the sensor's own axes."""
        return np.asarray(np.linalg.solve(self.axes, field_nT.T).T)

    def moved(self, by_nT: Array | float) -> Scene:
        """The same in a field that is `by_nT` (n, 3) or (3,) larger."""
        denoised = None if self.denoised_field_nT is None else self.denoised_field_nT + by_nT
        return replace(self, field_nT=self.field_nT + by_nT, denoised_field_nT=denoised)

    def select(self, rows: NDArray[Any]) -> Scene:
        """The same scene with only these rows (mask or numbers, in time order)."""
        rig = self.rig and Rig(*(getattr(self.rig, name)[rows] for name in Rig.__slots__))
        return replace(
            self,
            t_s=self.t_s[rows],
            segment=self.segment[rows],
            field_nT=self.field_nT[rows],
            channels={name: values[rows] for name, values in self.channels.items()},
            mode=None if self.mode is None else self.mode[rows],
            rig=rig,
            denoised_field_nT=None if self.denoised_field_nT is None else self.denoised_field_nT[rows],
        )
