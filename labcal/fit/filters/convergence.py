"""How a live filter's estimate grew with the readings: the picture of Crassidis, Lai & Harman 2003, figures 1 and 2."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.fit.filters.centered_sequential import CenteredSequential
from labcal.fit.filters.ekf import EKF
from labcal.fit.filters.sequential import LiveFilter
from labcal.fit.filters.ukf import UKF, AugmentedUKF
from labcal.fit.scalar.scalar_run import scalars, usable
from labcal.record import Run

Array = NDArray[np.float64]
FILTERS: dict[str, type[LiveFilter] | type[CenteredSequential]] = {
    "centered-sequential": CenteredSequential,
    "ekf": EKF,
    "ukf": UKF,
    "ukf-augmented": AugmentedUKF,
}
POINTS = 300


@dataclass(frozen=True, slots=True, eq=False)
class History:
    """The bias of the reading and its standard uncertainty (m, 3) [nT] after the reading at `t_s` (m,)."""

    t_s: Array
    bias_nT: Array
    u_nT: Array


def filter_history(run: Run, method: str) -> History:
    """Feed `run` to a filter and write its estimate down along the way. Raises InputError where there is none."""
    if method not in FILTERS:
        raise InputError(f"{method} looks at all readings at once; {', '.join(FILTERS)} look at one after another")
    try:
        seen, t_s = scalars(run), run.t_s[usable(run)]
    except ValueError as error:
        raise InputError(str(error)) from None
    live, every = FILTERS[method](seen.noise, seen.reference_noise), max(1, len(t_s) // POINTS)
    rows: list[tuple[float, Array, Array]] = []
    for n, (reading, magnitude) in enumerate(zip(seen.reading, seen.magnitude.tolist(), strict=True), start=1):
        live.update(reading, magnitude)
        if n % every == 0 and live.started:
            found = live.estimate()
            rows.append((t_s[n - 1], found.bias, np.sqrt(np.diag(found.covariance)[:3])))
    if not rows:
        raise InputError(f"the run is too short for {method} to begin")
    return History(*(np.array(part) for part in zip(*rows, strict=True)))
