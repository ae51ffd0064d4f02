"""The International Geomagnetic Reference Field at a place and date (ppigrf)."""

from __future__ import annotations

from datetime import date, datetime
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError

Array = NDArray[np.float64]
Frame = Literal["ned", "enu"]

FIRST_YEAR, LAST_YEAR = 1900, 2030  # of the coefficients


def igrf_nT(latitude_deg: float, longitude_deg: float, height_m: float, when: date, frame: Frame) -> Array:
    """The main field (3,) [nT], north-east-down or east-north-up (geodetic). Raises InputError outside IGRF's years."""
    import ppigrf

    if not FIRST_YEAR <= when.year < LAST_YEAR:
        raise InputError(f"IGRF holds from {FIRST_YEAR} to {LAST_YEAR}; {when.isoformat()} is outside")
    day = datetime(when.year, when.month, when.day)
    east, north, up = (
        float(np.ravel(part)[0]) for part in ppigrf.igrf(longitude_deg, latitude_deg, height_m / 1000.0, day)
    )
    return in_frame(north, east, -up, frame)


def in_frame(north: float, east: float, down: float, frame: Frame) -> Array:
    """The components (3,) in the order, and with the sign of the vertical, that `frame` has."""
    return np.array([north, east, down] if frame == "ned" else [east, north, -down])
