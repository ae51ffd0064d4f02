"""What a sensor, as it was calibrated, indicates of known fields before any correction, and how far off that is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.parameters_k import COVERAGE
from labcal.model import Calibration
from labcal.record import Run
from labcal.uncertainty.of_calibration import u_indicated
from labcal.uncertainty.working_points import slopes_at, working_points

Array = NDArray[np.float64]
DIRECTIONS = 6  # the first points of the working range: the largest field both ways along each axis


@dataclass(frozen=True, slots=True, eq=False)
class Indication:
    """Components x, y, z (3,) [nT] of a field and of the reading times its unit's nominal value; U of both differences.

    `k` is the largest of the budgets of the field there.
    """

    at: str
    field_nT: Array
    indicated_nT: Array
    U_nT: Array
    k: float

    @property
    def error_nT(self) -> Array:
        """What is indicated less the field (VIM, 4.20: the error of indication)."""
        return self.indicated_nT - self.field_nT


def indications(c: Calibration, run: Run) -> list[Indication]:
    """At the largest field both ways along each axis; none without a budget, or a channel that an effect has."""
    followed = {name for effect in c.effects for name in effect.channels}
    if not c.budget or not followed <= {channel.name for channel in run.channels}:
        return []
    points = working_points(c, run)[:DIRECTIONS]
    readings, slopes = slopes_at(c, points)
    indicated, u = c.dut.nominal_nT_per_unit * readings, u_indicated(c, slopes)
    k = [max((b["k"] for b in c.budget if b["at"] == point.says), default=COVERAGE) for point in points]
    each = zip(points, indicated, u, k, strict=True)
    return [Indication(point.says, point.field_nT, read, k_of * s, k_of) for point, read, s, k_of in each]
