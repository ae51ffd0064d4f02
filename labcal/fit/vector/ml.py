"""Maximum likelihood for whatever a run offers: the default method."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.autocorrelation import variance_inflation
from labcal.fit.result import Fit
from labcal.fit.vector.declared import declared_contributions, residual_beside_declared
from labcal.fit.vector.identifiability import Identifiability, identify
from labcal.fit.vector.initial_values import starts
from labcal.fit.vector.observations import SCALAR, Observations, observe
from labcal.fit.vector.planes import in_planes, observe_planes
from labcal.fit.vector.solve import (
    HUBER_THRESHOLD,
    LEAST_SQUARES,
    ROBUST,
    Loss,
    Parameterisation,
    ParameterisationName,
    Solution,
    parameterise,
    solve,
)
from labcal.fit.vector.system import Noise, WhiteIn, map_of
from labcal.model import AffineMap
from labcal.record import Run
from labcal.uncertainty import Contribution, FitNoise, Sources
from labcal.uncertainty.beside_declared import share

Array = NDArray[np.float64]
MEDIAN_CHI2 = np.array([np.nan, 0.4549, 1.3863, 2.3660])  # of 1, 2 and 3 degrees of freedom
SUBSAMPLE = 500  # rows on which the starts compete
ROUNDS = 8  # of noise and fit
POLISHED = 2  # starts that are followed to their minimum


@dataclass(frozen=True, slots=True, eq=False)
class MaximumLikelihood:
    """All that a maximum-likelihood fit knows: what the loop builds on, where `Fit` is for people and files."""

    observations: Observations
    noise: Noise  # as used in the weights
    parameterisation: Parameterisation
    solution: Solution
    identified: Identifiability
    scale: float  # observed over expected standard deviation of the normalised residuals

    @property
    def affine(self) -> AffineMap:
        """The map in the DUT's unit."""
        return AffineMap(*map_of(self.solution.theta, self.observations.scale))

    @property
    def covariance(self) -> Array:
        """Covariance (12, 12) of K row by row, then k, in the DUT's unit."""
        unit = np.r_[np.full(9, 1 / self.observations.scale), np.ones(3)]
        return np.asarray(self.identified.covariance * np.outer(unit, unit))


def ml(run: Run, *, robust: bool = True, white_in: WhiteIn = "reading") -> Fit:
    """Maximum likelihood: K and k (and the starting phases) from vectors, axes and magnitudes, with covariance.

    `white_in` says where the sensor's noise is white, its axes alike: in the readings, as instruments have it, or in
    the field before K⁻¹ distorts it (Riwanto et al. 2017, (2a)); `dut.noise_nT` and `noise_nT` are meant there.
    Where the rotation cannot be seen K is symmetric, the covariance has rank 9 and `frame_known` is False; with a
    scalar reference, turns about known axes show it by their planes. A run that does not determine the map gets
    `ok=False` with the reason; where its magnitudes do, but its vectors do not, `left_open` says what is missing.
    `robust=False` is least squares.
    """
    if run.reference.kind == "none":
        return _refused("there is no reference, so the scale is open: a field of known magnitude is needed")
    left_open = None
    try:
        found = _on_planes(run, robust=robust, white_in=white_in) or estimate(run, robust=robust, white_in=white_in)
        if found.identified.why_not and (found.observations.kind != SCALAR).any():
            scalar = estimate(run, as_scalar=True, robust=robust, white_in=white_in)
            if scalar.identified.why_not is None:
                found, left_open = scalar, found.identified.why_not
    except (np.linalg.LinAlgError, ArithmeticError):
        return _refused("no map comes near these readings: they do not follow the reference at all")
    except ValueError as error:
        return _refused(str(error))
    if found.identified.why_not:
        return _refused(found.identified.why_not)
    frame_known = found.parameterisation.name != "symmetric"
    part, correlated = _beside_declared(run, found)
    wider = part * correlated
    noise = FitNoise.single(found.covariance * wider, _free(found) / max(wider, 1.0))
    sources = Sources(noise, _declared(run, found))
    return Fit(
        method="ml",
        ok=True,
        affine=found.affine,
        covariance=sources.covariance,
        sources=sources,
        frame_known=frame_known,
        phase_rad=found.solution.phase[: len(found.observations.phase_names)],
        left_open=left_open,
        noise_nT=found.noise.reading * run.dut.nominal_nT_per_unit * found.scale * float(np.sqrt(part)),
    )


def estimate(
    run: Run,
    *,
    parameterisation: ParameterisationName | None = None,
    as_scalar: bool = False,
    as_planes: bool = False,
    robust: bool = True,
    white_in: WhiteIn = "reading",
) -> MaximumLikelihood:
    """Fit the form `allowed` (affine, or symmetric where all rows are magnitudes) to the usable rows of `run`.

    `as_planes`: with a scalar reference, turns about known axes are planes of unknown heights (`observe_planes`).

    Raises ValueError where the rows are too few, or the sensor or the reference is dead.
    Look at `identified.why_not` before using the numbers.
    """
    seen = observe_planes(run) if as_planes else observe(run, as_scalar=as_scalar)
    nominal = seen.scale * run.dut.nominal_nT_per_unit
    name = parameterisation or ("symmetric" if (seen.kind == SCALAR).all() else "affine")
    shape = parameterise(name, nominal)
    _require_excitation(seen, shape)
    noise = _declared_noise(run, seen)
    start = _best_start(seen, noise, shape, nominal)
    found, noise, loss, scale = _iterate(run, seen, noise, shape, start, robust=robust, white_in=white_in)
    identified = identify(seen, noise, shape, found, loss, scale)
    return MaximumLikelihood(seen, noise, shape, found, identified, scale)


def _on_planes(run: Run, *, robust: bool, white_in: WhiteIn) -> MaximumLikelihood | None:
    """The fit to the planes of turns about known axes, magnitudes alone known; None where they do not determine it."""
    if run.reference.kind != "scalar" or not observe_planes(run).loci:
        return None
    try:
        found = estimate(run, as_planes=True, robust=robust, white_in=white_in)
    except (ArithmeticError, ValueError):
        return None
    good = found.identified.why_not is None and in_planes(run, found.observations, found.noise, found.solution)
    return found if good else None


def _declared(run: Run, found: MaximumLikelihood) -> tuple[Contribution, ...]:
    return declared_contributions(run, found.observations, found.noise, found.parameterisation, found.solution)


def _free(found: MaximumLikelihood) -> float:
    """Residual components by their weights, less the parameters fitted to them."""
    components = float(np.sum(found.solution.weight * found.observations.kind))
    return float(components - found.parameterisation.basis.shape[1] - len(found.solution.phase))


def _beside_declared(run: Run, found: MaximumLikelihood) -> tuple[float, float]:
    """The part of the residual's square that is no declared error's, and how much its correlation widens a covariance.

    Residuals that declared errors enlarged have enlarged the noise already: that is taken back as far as the declared
    noise. They are the reference's and the mounting's, and in no reading of the device.
    """
    parts = found.observations, found.noise, found.parameterisation, found.solution
    residual, left = residual_beside_declared(run, *parts)
    part = share(residual, left)
    if run.dut.noise_nT is not None:
        part = max(part, 1 / found.scale**2)
    return part, variance_inflation(left, found.observations.segment)


def _require_excitation(seen: Observations, shape: Parameterisation) -> None:
    free, given = shape.basis.shape[1] + seen.unknowns, int(seen.kind.sum())
    if given <= free:
        raise ValueError(f"{len(seen)} usable rows give {given} numbers; the map needs more than {free}")
    if not seen.magnitude.any():
        raise ValueError("the reference is zero throughout")
    for name, column in zip(("dut_x", "dut_y", "dut_z"), seen.reading.T, strict=True):
        if shape.name in ("affine", "symmetric") and np.ptp(column) == 0:
            raise ValueError(f"{name} never changes: nothing determines its scale; turn the sensor or look at the axis")


def _refused(why: str) -> Fit:
    return Fit(method="ml", ok=False, why_not=why)


def _declared_noise(run: Run, seen: Observations) -> Noise:
    """The declared noise; a DUT whose noise is not declared starts at 1 nT and is estimated."""
    angle = np.radians([s.angle_noise_deg or 0.0 for s in run.segments])[seen.segment]
    shared = run.reference.u_time_s or 0.0
    time = np.array([s.u_time_s or shared for s in run.segments])[seen.segment]
    reading = (run.dut.noise_nT or 1.0) / run.dut.nominal_nT_per_unit
    return Noise(reading, run.reference.noise_nT or 0.0, angle, time)


def _best_start(seen: Observations, noise: Noise, shape: Parameterisation, nominal: float) -> Solution:
    """Of the closed-form starts, polished on a subsample with Huber's loss, the one with the smallest residuals."""
    rows = np.unique(np.linspace(0, len(seen) - 1, SUBSAMPLE).astype(np.intp))
    few, few_noise = seen.select(rows), noise.select(rows)

    def polish(start: Solution, loss: Loss, iterations: int) -> Solution:
        return solve(few, few_noise, shape, start.theta, start.phase, loss, iterations=iterations)

    candidates = starts(few, nominal, symmetric=shape.name == "symmetric")
    rough = [solve(few, few_noise, shape, *start, LEAST_SQUARES, iterations=0) for start in candidates]
    best = sorted(rough, key=lambda one: typical(few, one))[:POLISHED]
    rough = [polish(one, LEAST_SQUARES, 6) for one in best]
    return min((polish(r, Loss(typical(few, r), np.inf), 6) for r in rough), key=lambda end: typical(few, end))


def _iterate(
    run: Run,
    seen: Observations,
    noise: Noise,
    shape: Parameterisation,
    start: Solution,
    *,
    robust: bool,
    white_in: WhiteIn,
) -> tuple[Solution, Noise, Loss, float]:
    """Alternate the fit with the scale of its residuals until both stand: solution, noise, loss, scale left over.

    The scale goes into the reading's noise where none is declared; else it widens the covariance, never narrows it.
    """
    found, scale, loss = start, 1.0, LEAST_SQUARES
    for _ in range(ROUNDS):
        last = found.theta
        if white_in == "field":
            noise = replace(noise, shape=_through(found.theta, seen.scale * run.dut.nominal_nT_per_unit))
        at_start = solve(seen, noise, shape, found.theta, found.phase, LEAST_SQUARES, iterations=0)
        loss = replace(ROBUST, threshold=_huber_threshold(seen, at_start)) if robust else LEAST_SQUARES
        found = solve(seen, noise, shape, found.theta, found.phase, loss)
        before, scale = scale, _scale(seen, found, shape)
        if run.dut.noise_nT is None:
            noise, before, scale = replace(noise, reading=noise.reading * scale), 1.0 / scale, 1.0
        moved = np.linalg.norm(found.theta - last) / np.linalg.norm(last)
        if abs(scale / before - 1) < 0.005 and (white_in == "reading" or moved < 1e-6):
            break
    return found, noise, loss, max(scale, 1.0)


def _through(theta: Array, nominal: float) -> Array:
    """Covariance (3, 3) that noise white in the field has in the readings, over its own in nominal units."""
    inverse = nominal * np.linalg.inv(theta[:9].reshape(3, 3))
    return np.asarray(inverse @ inverse.T)


def _huber_threshold(seen: Observations, found: Solution) -> float:
    """Where weights begin to fall: by the residuals' median, but so that at most a tenth of the rows lose any.

    More rows than that are no outliers: the model lacks something, and to leave them out would hide it.
    """
    return max(typical(seen, found), float(np.quantile(np.sqrt(found.cost) / HUBER_THRESHOLD[seen.kind], 0.9)), 1.0)


def typical(seen: Observations, found: Solution) -> float:
    """Observed over expected length of the normalised residuals, by their median."""
    return float(np.sqrt(np.median(found.cost / MEDIAN_CHI2[seen.kind])))


def _scale(seen: Observations, found: Solution, shape: Parameterisation) -> float:
    """Observed over expected standard deviation of the normalised residuals, degrees of freedom taken off."""
    free = float(np.sum(found.weight * seen.kind)) - shape.basis.shape[1] - len(found.phase)
    return float(np.sqrt(np.sum(found.weight * found.cost) / max(free, 1.0)))
