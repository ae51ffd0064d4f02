"""From a run to arrays and from an estimate to a `Fit`, shared by the methods of Crassidis, Lai & Harman 2003."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from labcal.fit.autocorrelation import variance_inflation
from labcal.fit.declared import contributions
from labcal.fit.result import Fit
from labcal.fit.scalar import scalar_check
from labcal.fit.scalar.scalar_check import COLUMN, MISSING, ROW, Estimate
from labcal.geometry import unit
from labcal.model import AffineMap
from labcal.record import Run
from labcal.uncertainty import FitNoise, Sources

Array = NDArray[np.float64]
LARGEST_U = 0.05  # of the field: an estimate less certain than this anywhere in the field is refused
ROUNDS = 4  # noise and estimate in turn
FIRST_NOISE = 2e-3  # of the field, where none is declared


class Estimator(Protocol):
    """Bias and D from readings, magnitudes and noise; `centered.estimate` and `twostep.estimate` are two."""

    def __call__(
        self,
        reading: Array,
        magnitude: Array,
        noise: Array,
        reference_noise: float = 0.0,
        *,
        unbiased: bool = True,
        near: Estimate | None = None,
    ) -> Estimate:
        """Return the estimate; raises ArithmeticError where there is none."""


@dataclass(frozen=True, slots=True, eq=False)
class Scalars:
    """Readings (n, 3), magnitudes (n,), covariance (3, 3) of a reading, standard deviation of a magnitude; one unit."""

    reading: Array
    magnitude: Array
    noise: Array
    reference_noise: float = 0.0

    def with_noise_times(self, scale: float) -> Scalars:
        """The same with all noise times `scale`."""
        return Scalars(self.reading, self.magnitude, self.noise * scale**2, self.reference_noise * scale)


def usable(run: Run) -> NDArray[np.bool_]:
    """Which rows (n,) have a reading and a reference. Raises ValueError where the run has no reference."""
    return np.asarray(np.isfinite(run.magnitude_nT) & np.isfinite(run.reading).all(axis=1))


def scalars(run: Run) -> Scalars:
    """The rows with a reading and a reference, in nT. Raises ValueError where there are fewer than ten."""
    rows = usable(run)
    if rows.sum() < 10:
        raise ValueError(f"{rows.sum()} rows have both a reading and a reference magnitude; nine parameters need ten")
    reading, magnitude = run.reading_nT[rows], run.magnitude_nT[rows]
    noise = run.dut.noise_nT or FIRST_NOISE * float(np.sqrt(np.mean(magnitude**2)))
    return Scalars(reading, magnitude, noise**2 * np.eye(3), run.reference.noise_nT or 0.0)


def fit_scalar(run: Run, method: str, estimate: Estimator) -> Fit:
    """Calibrate `run` by a batch estimator, or say why not."""
    try:
        seen, found = settle(scalars(run), estimate)
    except np.linalg.LinAlgError:
        return Fit(method, ok=False, why_not=f"the magnitudes do not determine all nine parameters: {MISSING}")
    except (ArithmeticError, ValueError) as error:
        return Fit(method, ok=False, why_not=str(error))
    return as_fit(run, method, seen, found)


def settle(seen: Scalars, estimate: Estimator) -> tuple[Scalars, Estimate]:
    """Estimate and noise in turn: the first estimate is the published one, the rest know the noise of the residuals."""
    found = estimate(seen.reading, seen.magnitude, seen.noise, seen.reference_noise, unbiased=False)
    for _ in range(ROUNDS):
        scale = noise_scale(seen, found)
        seen = seen.with_noise_times(scale)
        found = estimate(seen.reading, seen.magnitude, seen.noise, seen.reference_noise, near=found)
        if abs(scale - 1) < 0.002:
            break
    return seen, found


def as_fit(run: Run, method: str, seen: Scalars, found: Estimate, *, widened: bool = False) -> Fit:
    """The contract's K and k, or the refusal of what the run does not determine.

    The covariance is widened for residuals that correlate, unless it has been (`widened`).
    """
    slope, gain = to_contract(run.dut.nominal_nT_per_unit), run.dut.nominal_nT_per_unit
    if not widened:
        wider = variance_inflation(residual(seen, found)[:, None], run.segment_index[usable(run)])
        found = found.wider(wider)
    if not certain(seen, found):
        uncertain = worst_uncertainty(found, float(seen.magnitude.max()))
        return Fit(method, ok=False, why_not=f"the field would be uncertain by {uncertain:.0f} nT: {MISSING}")
    affine = AffineMap(gain * (np.eye(3) + found.D), found.bias)
    noise = FitNoise.single(slope @ found.covariance @ slope.T, len(seen.reading) - 9.0)
    sources = Sources(noise, contributions(run, affine, frame_known=False))
    return Fit(
        method,
        ok=True,
        affine=affine,
        covariance=sources.covariance,
        sources=sources,
        bias_nT=found.bias,
        D=found.D,
        noise_nT=float(np.sqrt(np.trace(seen.noise) / 3)),
    )


def to_contract(gain: float) -> Array:
    """∂(K row by row, k)/∂(b, D) (12, 9) with K = gain (I + D), k = b."""
    out = np.zeros((12, 9))
    for six, (row, column) in enumerate(zip(ROW, COLUMN, strict=True)):
        out[[3 * row + column, 3 * column + row], 3 + six] = gain
    out[9:, :3] = np.eye(3)
    return out


def residual(seen: Scalars, found: Estimate) -> Array:
    """The residual of (3b) over its standard deviation (n,), less the mean that a centred estimate leaves open, (17).

    That mean is |b|² of the estimate less |b|² of the data: an error of the bias along itself, many times the noise of
    the mean, and in the covariance of the bias already.
    """
    c_E, rows = scalar_check.to_c_E(found.bias, found.D), scalar_check.regressors(seen.reading.T)
    variance = scalar_check.noise_variance(rows, seen.magnitude**2, c_E, seen.noise, seen.reference_noise)
    field = seen.reading + seen.reading @ found.D - found.bias
    v = np.einsum("ij,ij->i", field, field) - seen.magnitude**2 - scalar_check.noise_mean(c_E, seen.noise)
    if found.centred:
        v -= np.average(v, weights=1 / variance)
    return np.asarray(v / np.sqrt(variance))


def noise_scale(seen: Scalars, found: Estimate) -> float:
    """Observed over expected standard deviation of the residuals, the fitted parameters' degrees of freedom off."""
    r = residual(seen, found)
    return float(np.sqrt(r @ r / (len(r) - 9 - found.centred)))


def certain(seen: Scalars, found: Estimate) -> bool:
    """Whether the field is known to LARGEST_U of its largest value."""
    largest = float(seen.magnitude.max())
    return worst_uncertainty(found, largest) <= LARGEST_U * largest


def worst_uncertainty(found: Estimate, field: float) -> float:
    """The largest standard uncertainty of |(I + D) B − b| over 26 directions of a field of that size."""
    grid = np.stack(np.meshgrid(*[[-1.0, 0.0, 1.0]] * 3), axis=-1).reshape(-1, 3)
    h = unit(grid[grid.any(axis=1)])
    B = np.linalg.solve(np.eye(3) + found.D, (field * h + found.bias).T).T
    symmetric = (h[:, ROW] * B[:, COLUMN] + h[:, COLUMN] * B[:, ROW]) * np.where(ROW == COLUMN, 0.5, 1.0)
    slope = np.hstack([-h, symmetric])
    return float(np.sqrt(np.einsum("ij,jk,ik->i", slope, found.covariance, slope).max()))
