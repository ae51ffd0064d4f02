"""What became of the reference since its certificate: its temperature, its age, and the way from it to the device.

None of it is corrected: what is known of it counts whole, with its own uncertainty (GUM, F.2.4.5: b² + u²(b)).
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from datetime import date, datetime

import numpy as np
from numpy.typing import NDArray

from labcal.record import Reference, Run

Array = NDArray[np.float64]
DAYS_A_YEAR = 365.25


def whole(known: float | None, u: float | None) -> float:
    """sqrt(b² + u²) of an effect b that is not corrected and its uncertainty u; 0 where neither is stated."""
    return float(np.hypot(known or 0.0, u or 0.0))


def years_since(run: Run) -> float | None:
    """Years from the reference's own calibration to the run; None where no date of it is stated, or a later one."""
    stated = certified_on(run.reference)
    if stated is None:
        return None
    days = (datetime.fromisoformat(run.started_utc).date() - stated).days
    return days / DAYS_A_YEAR if days >= 0 else None


def certified_on(reference: Reference) -> date | None:
    """The date of the reference's certificate, or the one that its calibration names in words."""
    stated = str((reference.certificate or {}).get("date") or reference.calibration or "")
    found = re.search(r"\d{4}-\d{2}-\d{2}", stated)
    try:
        return date.fromisoformat(found.group()) if found else None
    except ValueError:
        return None


def warmer_K(run: Run) -> Array | None:
    """How much warmer than on its certificate the reference was (n,) [K]; None where either is not stated.

    By the room's temperature channel, else by the run's environment.
    """
    certified = (run.reference.certificate or {}).get("temperature_C")
    if certified is None:
        return None
    room = [c for c in run.channels if (c.role, c.quantity, c.unit) == ("room", "temperature", "degC")]
    if room and np.isfinite(room[0].values).any():
        values = room[0].values
        return np.asarray(np.where(np.isfinite(values), values, np.nanmean(values)) - float(certified))
    now = (run.environment or {}).get("temperature_C")
    return None if now is None else np.full(len(run), now - float(certified))


def distance_m(run: Run) -> float:
    """From the reference to the device, where fields are not carried from one to the other; 0 where none is stated."""
    apart = run.reference.position_m
    return 0.0 if apart is None or run.reference.place == "remote" else float(np.linalg.norm(apart))


def factors(run: Run) -> Iterator[tuple[str, float, str, Array]]:
    """Source, standard uncertainty, unit, and for one of it the factors less one (n, 3) of the reference's axes."""
    reference, n = run.reference, len(run)
    tc, warmer = whole(reference.tc_ppm_per_K, reference.u_tc_ppm_per_K), warmer_K(run)
    if tc and warmer is not None:
        yield "reference's temperature, scale", tc, "ppm/K", np.repeat(1e-6 * tc * warmer[:, None], 3, axis=1)
    if ppm := distance_m(run) * (run.environment or {}).get("gradient_ppm_per_m", 0.0):
        for name, axis in zip("xyz", np.eye(3), strict=True):
            yield f"coils' gradient over the distance {name}", ppm, "ppm", np.tile(1e-6 * ppm * axis, (n, 1))


def zeros(run: Run) -> Iterator[tuple[str, float, str, Array]]:
    """The same as fields (n,) [nT] that each axis of the reference reads too much."""
    reference, n = run.reference, len(run)
    tc, warmer = whole(reference.tc_nT_per_K, reference.u_tc_nT_per_K), warmer_K(run)
    if tc and warmer is not None:
        yield "reference's temperature, zero", tc, "nT/K", tc * warmer
    drift, years = whole(reference.drift_nT_per_year, reference.u_drift_nT_per_year), years_since(run)
    if drift and years:
        yield "reference's drift since its certificate", drift, "nT/year", np.full(n, drift * years)
    if zero := distance_m(run) * (run.environment or {}).get("gradient_nT_per_m", 0.0):
        yield "gradient over the distance", zero, "nT", np.full(n, zero)


def with_factors(run: Run, times: float = 1.0, *, by: Array) -> Run:
    """The run with its reference's axes larger by the factors (n, 3); a magnitude by their mean."""
    if run.reference_vector is not None:
        run = replace(run, reference_vector=run.reference_vector * (1 + times * by))
    if run.reference_magnitude is not None:
        run = replace(run, reference_magnitude=run.reference_magnitude * (1 + times * by.mean(axis=1)))
    return run


def with_zero(run: Run, times: float = 1.0, *, by: Array, axis: int) -> Run:
    """The run with one axis of its reference larger by a field (n,) [nT]; a magnitude has no axes."""
    if run.reference_vector is not None:
        return replace(run, reference_vector=run.reference_vector + times * by[:, None] * np.eye(3)[axis])
    assert run.reference_magnitude is not None
    return replace(run, reference_magnitude=run.reference_magnitude + times * by)
