"""`centered-sequential`: the recursion of the centred estimate (Crassidis, Lai & Harman 2003, (19) to (22)).

As printed, the second terms of (19) carry the new mean's variance σ̄²_{k+1}; they need the old one's, σ̄²_k. For L̃ about
the new mean the scalar in (22) is σ⁴/(σ² + σ̄²_k); here L is taken from the old mean, with σ² + σ̄²_k. So corrected, the
recursion equals the batch on the same weights.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.fit.filters.scalar_step import terms
from labcal.fit.filters.sequential import Start
from labcal.fit.result import Fit
from labcal.fit.scalar import centered, scalar_check
from labcal.fit.scalar.moments import Moments, moments, noise_information
from labcal.fit.scalar.scalar_check import Estimate
from labcal.fit.scalar.scalar_run import Scalars, as_fit, certain, noise_scale, scalars
from labcal.record import Run

Array = NDArray[np.float64]


def centered_sequential(run: Run) -> Fit:
    """Calibrate `run` from magnitudes, row by row. A constant magnitude leaves the scale open and is refused."""
    try:
        seen = scalars(run)
        live = CenteredSequential(seen.noise, seen.reference_noise)
        for reading, magnitude in zip(seen.reading, seen.magnitude.tolist(), strict=True):
            live.update(reading, magnitude)
        found = live.estimate()
    except (ArithmeticError, ValueError) as error:
        return Fit("centered-sequential", ok=False, why_not=str(error))
    return as_fit(run, "centered-sequential", seen.with_noise_times(noise_scale(seen, found)), found)


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """The means (19) and (20), z less its noise mean, and the estimate θ̃' (9,) with its covariance (9, 9)."""

    L: Array
    z: float
    variance: float
    c_E: Array
    covariance: Array

    @classmethod
    def of(cls, found: Moments) -> State:
        """The state after the samples of a batch, (15) to (18)."""
        covariance = np.linalg.inv(found.information)
        return cls(found.L, found.z, found.variance, covariance @ found.projection, np.asarray(covariance))


def advance(state: State, L: Array, z: float, variance: float) -> tuple[State, float]:
    """One sample more, and its innovation squared over what it was expected to be, (19) to (22).

    `L` (9,) is its regressor, `z` its observation less the noise mean, `variance` σ².
    """
    both = variance + state.variance
    ahead = L - state.L
    gain = state.covariance @ ahead
    expected = float(ahead @ gain) + both
    innovation = z - state.z - float(ahead @ state.c_E)
    share = state.variance / both
    after = State(
        state.L + share * ahead,
        state.z + share * (z - state.z),
        share * variance,
        state.c_E + gain * (innovation / expected),
        state.covariance - (gain / expected)[:, None] * gain,
    )
    return after, innovation * innovation / expected


class CenteredSequential:
    """The centred estimate, live: `update` takes each reading, `estimate` answers at any time.

    `noise` (3, 3) is the covariance of a reading, `reference_noise` the standard deviation of a magnitude. A small
    batch starts it, as the paper says below (22), but one that determines the field: where noise stands in for
    excitation it gives weights that ruin all that follows. Residuals, first the batch's, correct the noise. σ² is (5b)
    at the estimate before.
    """

    def __init__(self, noise: Array, reference_noise: float = 0.0) -> None:
        self._start = Start(noise, reference_noise, centered.estimate, certain)
        self._noise, self._reference_noise = noise, reference_noise
        self._state: State | None = None
        self._unit = 1.0
        self._steps, self._surprise = 0, 0.0

    @property
    def started(self) -> bool:
        """Whether the first readings were enough."""
        return self._state is not None

    def update(self, reading: Array, magnitude: float) -> None:
        """Take one reading (3,) and the magnitude of the field."""
        if self._state is None:
            begun = self._start.add(reading, magnitude)
            if begun is not None:
                self._begin(*begun)
            return
        c_E, unit = self._state.c_E, self._unit
        at = terms(c_E, reading / unit, magnitude / unit, self._noise, self._reference_noise)
        L = np.array(at.regressor)
        z = at.innovation + float(L @ c_E) - at.square
        self._state, surprise = advance(self._state, L, z, at.variance)
        self._steps += 1
        self._surprise += surprise

    def estimate(self) -> Estimate:
        """Bias and D so far, the noise's share taken off. Raises ArithmeticError while undetermined."""
        if self._state is None:
            return self._start.settled()[1]
        s = self._state
        information = np.linalg.inv(s.covariance)
        share = noise_information(s.L, s.variance, self._noise)
        free = len(self._start) - 10
        observed = (free + self._surprise) / (free + self._steps)  # over expected, residuals squared
        found = Moments(s.L, s.z, s.variance, np.asarray(information), information @ s.c_E, observed * share)
        c_E, covariance = centered.solve(found)
        return centered.answer(c_E, covariance * observed).in_unit(self._unit)

    def _begin(self, seen: Scalars, found: Estimate) -> None:
        self._unit = unit = float(np.sqrt(np.mean(seen.magnitude**2)))
        self._noise, self._reference_noise = seen.noise / unit**2, seen.reference_noise / unit
        at, rows = scalar_check.to_c_E(found.bias / unit, found.D), scalar_check.regressors(seen.reading.T / unit)
        first = moments(rows, (seen.magnitude / unit) ** 2, at, self._noise, self._reference_noise)
        self._state = State.of(first)
