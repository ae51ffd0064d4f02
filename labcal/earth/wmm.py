"""The World Magnetic Model at a place and date, with its error model (pygeomag; NCEI and BGS, five years an edition).

The error model is what a single reading outdoors, far from iron, differs from the model by (one standard deviation):
the core's field that was not foreseen, the crust's and the ionosphere's. A building comes on top.
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import date
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.earth.igrf import Frame, in_frame
from labcal.errors import InputError

Array = NDArray[np.float64]

FIRST_YEAR, LAST_YEAR = 2015, 2030  # of the editions that have an error model
EDITION_YEARS = 5
HIGHEST_M = 850_000.0  # that the model is made for; and how far below the sea
LOWEST_M = -1_000.0


@dataclass(frozen=True, slots=True)
class Expected:
    """A model's field and its standard uncertainties (k = 1), all in nT; components (3,) as `frame` has them."""

    model: str
    field_nT: Array
    u_nT: Array
    u_magnitude_nT: float

    @property
    def magnitude_nT(self) -> float:
        """The total intensity."""
        return float(np.linalg.norm(self.field_nT))


def wmm(latitude_deg: float, longitude_deg: float, height_m: float, when: date, frame: Frame = "ned") -> Expected:
    """What the edition of those years expects there. Raises InputError outside its years and heights."""
    if not FIRST_YEAR <= when.year < LAST_YEAR:
        raise InputError(f"WMM is here from {FIRST_YEAR} to {LAST_YEAR}; {when.isoformat()} is outside")
    if not LOWEST_M <= height_m <= HIGHEST_M:
        raise InputError(f"WMM holds from {LOWEST_M:g} to {HIGHEST_M:g} m; {height_m:g} m is outside")
    edition = when.year - when.year % EDITION_YEARS
    found = _model(edition).calculate(latitude_deg, longitude_deg, height_m / 1000.0, _decimal_year(when))
    error = found.calculate_uncertainty()
    return Expected(
        model=f"WMM{edition}",
        field_nT=in_frame(found.x, found.y, found.z, frame),
        u_nT=np.abs(in_frame(error.x, error.y, error.z, frame)),
        u_magnitude_nT=float(error.f),
    )


def _model(edition: int) -> Any:
    from pygeomag import GeoMag

    return GeoMag(base_year=edition)


def _decimal_year(when: date) -> float:
    begins = date(when.year, 1, 1)
    return when.year + (when - begins).days / (date(when.year + 1, 1, 1) - begins).days
