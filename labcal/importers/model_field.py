"""The Earth's field at a place and date by IGRF (ppigrf), as a reference that was computed."""

from __future__ import annotations

from datetime import UTC, date, datetime
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError

Array = NDArray[np.float64]

FIRST_YEAR, LAST_YEAR = 1900, 2030  # of the coefficients


def igrf_nT(
    latitude_deg: float, longitude_deg: float, height_m: float, when: date, frame: Literal["ned", "enu"]
) -> Array:
    """The main field (3,) [nT], north-east-down or east-north-up (geodetic). Raises InputError outside IGRF's years."""
    import ppigrf

    if not FIRST_YEAR <= when.year < LAST_YEAR:
        raise InputError(f"IGRF holds from {FIRST_YEAR} to {LAST_YEAR}; the recording is of {when.year}")
    day = datetime(when.year, when.month, when.day)
    east, north, up = (
        float(np.ravel(part)[0]) for part in ppigrf.igrf(longitude_deg, latitude_deg, height_m / 1000.0, day)
    )
    return np.array([north, east, -up] if frame == "ned" else [east, north, up])


def day_of(stated: str | date | None, started_utc: str) -> date:
    """The date that is stated, else that of the recording's start."""
    if isinstance(stated, date):
        return stated
    moment = datetime.fromisoformat(stated or started_utc)
    return moment.astimezone(UTC).date() if moment.tzinfo else moment.date()
