"""What the sequential estimators share: a start from the first readings, steps, and whether these keep their promise.

The filters linearise |b|² of (3b), which all samples share: what one linearisation gets wrong is wrong in every later
sample too and never averages out. A filter started at the prior (48) therefore settles beside the truth and trusts
itself, even when that prior is carried to (c, E) (docs/papers.md). So the first readings are kept until TWOSTEP on
them knows b well enough for |b|² to be linear within their noise; its covariance, carried to (c, E) by (12), starts
the filter.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.special import fdtri

from labcal.fit.result import Fit
from labcal.fit.scalar import scalar_check, twostep
from labcal.fit.scalar.scalar_check import Estimate
from labcal.fit.scalar.scalar_run import Estimator, Scalars, as_fit, noise_scale, scalars, settle
from labcal.record import Run

Array = NDArray[np.float64]
FIRST_CHECK, GROWTH = 50, 1.25  # readings before TWOSTEP is tried, and between tries
NEGLIGIBLE = 0.3  # of the noise of the mean: the curvature of |b|² that a start may leave
CHANCE = 1e-6  # of a false alarm
SURPRISE = 1.5  # innovations squared over expected: beyond this, and beyond chance, the filter has diverged


class FilterUpdate(Protocol):
    """One reading taken into (c, E); all in one unit in which magnitudes are of order one."""

    def __call__(
        self, x: Array, P: Array, reading: Array, magnitude: float, noise: Array, reference_noise: float
    ) -> tuple[Array, Array, float]:
        """State (9,), covariance (9, 9) and the innovation squared over its variance."""


class Start:
    """Keeps the first readings until a batch estimate of them is `enough`; checks ever less often."""

    def __init__(
        self, noise: Array, reference_noise: float, estimate: Estimator, enough: Callable[[Scalars, Estimate], bool]
    ) -> None:
        self._noise, self._reference_noise = noise, reference_noise
        self._estimate, self._enough = estimate, enough
        self._readings: list[Array] = []
        self._magnitudes: list[float] = []
        self._next_check = FIRST_CHECK

    def __len__(self) -> int:
        return len(self._readings)

    def settled(self) -> tuple[Scalars, Estimate]:
        """The readings with their noise, and the estimate. Raises ArithmeticError (LinAlgError) where there is none."""
        if len(self) < FIRST_CHECK:
            raise ArithmeticError(f"{len(self)} readings with a magnitude; a start needs {FIRST_CHECK}")
        kept = Scalars(np.array(self._readings), np.array(self._magnitudes), self._noise, self._reference_noise)
        return settle(kept, self._estimate)

    def add(self, reading: Array, magnitude: float) -> tuple[Scalars, Estimate] | None:
        """Keep a reading (3,); return the start once there is enough of it."""
        self._readings.append(np.asarray(reading, dtype=float))
        self._magnitudes.append(float(magnitude))
        if len(self) < self._next_check:
            return None
        self._next_check = int(self._next_check * GROWTH)
        try:
            seen, found = self.settled()
        except (ArithmeticError, np.linalg.LinAlgError):
            return None
        return (seen, found) if self._enough(seen, found) else None


class LiveFilter:
    """An estimate that follows the readings one by one; `update` takes each, `estimate` answers at any time.

    `noise` (3, 3) is the covariance of a reading, `reference_noise` the standard deviation of a magnitude; the start's
    residuals correct their scale.
    """

    step: ClassVar[FilterUpdate]

    def __init__(self, noise: Array, reference_noise: float = 0.0) -> None:
        self._start = Start(noise, reference_noise, twostep.estimate, nearly_linear)
        self._x, self._P = np.zeros(9), np.zeros((9, 9))
        self._noise, self._reference_noise = noise, reference_noise
        self._unit = 0.0  # 0 until started
        self._steps, self._surprise = 0, 0.0

    @property
    def started(self) -> bool:
        """Whether the first readings were enough, so that each further one costs a step."""
        return self._unit > 0

    def update(self, reading: Array, magnitude: float) -> None:
        """Take one reading (3,) and the magnitude of the field."""
        unit = self._unit
        if unit == 0:
            begun = self._start.add(reading, magnitude)
            if begun is not None:
                self._begin(*begun)
            return
        try:
            self._x, self._P, surprise = type(self).step(
                self._x, self._P, reading / unit, magnitude / unit, self._noise, self._reference_noise
            )
        except (ArithmeticError, ValueError):  # a negative variance: nothing can be expected of it
            surprise = np.inf
        self._steps += 1
        self._surprise += surprise

    def estimate(self) -> Estimate:
        """Bias and D so far. Raises ArithmeticError (LinAlgError) while the readings do not determine them."""
        if not self.started:
            return self._start.settled()[1]
        free = len(self._start) - 9
        observed = (free + self._surprise) / (free + self._steps)  # over expected, residuals squared
        return scalar_check.from_c_E(self._x, self._P * observed).in_unit(self._unit)

    def diverged(self) -> str | None:
        """None, or a sentence: the innovations are larger than the filter believes."""
        if self._steps == 0:
            return None
        ratio = self._surprise / self._steps
        chance = float(fdtri(self._steps, len(self._start) - 9, 1 - CHANCE))
        if np.isfinite(ratio) and ratio < max(SURPRISE, chance):
            return None
        size = f"{ratio**0.5:.1f} times" if np.isfinite(ratio) else "beyond all bounds"
        return (
            f"the filter has diverged, or the sensor has changed: readings lie {size} farther from what it expects "
            "than the noise of the first ones allows"
        )

    def _begin(self, seen: Scalars, found: Estimate) -> None:
        unit = float(np.sqrt(np.mean(seen.magnitude**2)))
        scaled = found.in_unit(1 / unit)
        carried = scalar_check.jacobian(scaled.bias, scaled.D)
        self._x = scalar_check.to_c_E(scaled.bias, scaled.D)
        self._P = carried @ scaled.covariance @ carried.T
        self._noise, self._reference_noise = seen.noise / unit**2, seen.reference_noise / unit
        self._unit = unit


def nearly_linear(seen: Scalars, found: Estimate) -> bool:
    """Whether |b − b̂|² is small against the noise of the weighted mean of v, σ̄ of (16)."""
    P = found.covariance[:3, :3]
    c_E, rows = scalar_check.to_c_E(found.bias, found.D), scalar_check.regressors(seen.reading.T)
    variance = scalar_check.noise_variance(rows, seen.magnitude**2, c_E, seen.noise, seen.reference_noise)
    return bool(np.sqrt(2 * np.sum(P * P) * np.sum(1 / variance)) < NEGLIGIBLE)


def fit_live(run: Run, method: str, kind: type[LiveFilter]) -> Fit:
    """Feed a run to a filter, row by row, and answer with where it ends, or with why not."""
    try:
        seen = scalars(run)
        live = kind(seen.noise, seen.reference_noise)
        for reading, magnitude in zip(seen.reading, seen.magnitude.tolist(), strict=True):
            live.update(reading, magnitude)
        if why_not := live.diverged():
            return Fit(method, ok=False, why_not=why_not)
        found = live.estimate()
    except (ArithmeticError, ValueError) as error:
        return Fit(method, ok=False, why_not=str(error))
    scale = noise_scale(seen, found)
    return as_fit(run, method, seen.with_noise_times(scale), found)
