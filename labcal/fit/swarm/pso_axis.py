"""Particle swarm with rotation axis fitting: all twelve parameters from magnitudes and known rotation axes.

Riwanto, Tikka, Kestilä & Praks, IEEE Trans. Aerosp. Electron. Syst. 53(1), 2017. `PUBLISHED` is the method as
printed (with k flipped beside K in (11)); without it the swarm's best place is polished to the most likely one.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.fit.declared import contributions
from labcal.fit.result import Fit
from labcal.fit.swarm.loci import Loci, loci_of, reading_noise_nT
from labcal.fit.swarm.polish import Polished, noise_bias_in_sigma, polish, singular_values, worst_uncertainty_nT
from labcal.fit.swarm.search import PUBLISHED, Options, search, u_normal
from labcal.fit.vector.planes import CLEAR, sense
from labcal.model import AffineMap
from labcal.record import Run
from labcal.uncertainty import FitNoise, Sources

__all__ = ["PUBLISHED", "Options", "pso_axis"]

Array = NDArray[np.float64]
METHOD = "pso-axis"
LEAST_SINGULAR_VALUE = 1e-3
LARGEST_UNCERTAINTY = 0.1  # of the mean field
LARGEST_TILT_DEG = 30.0
LARGEST_BIAS = 0.15  # of an uncertainty; beyond it no covariance is given


def pso_axis(run: Run, *, seed: int = 0, options: Options | None = None) -> Fit:
    """Twelve parameters from the rotation segments of `run` that state their `axis_body`, repeatable from `seed`.

    `ok=False` with the reason where there is no such segment, or the run does not determine the parameters. The
    covariance comes with the polish; the swarm alone has none.
    """
    options = options or Options()
    try:
        loci = loci_of(run)
    except ValueError as error:
        return refused(METHOD, str(error))
    if not len(loci.axes):
        return refused(METHOD, "there is no rotation segment that states its axis_body; rotate about known body axes")
    theta = search(loci, reading_noise_nT(run, loci), options, seed).theta
    if why_not := _open(singular_values(loci, theta), loci):
        return refused(METHOD, why_not)
    found = Fit(METHOD, ok=True, affine=map_of(run, theta), frame_known=True)
    if options.polish:
        found = polished_fit(METHOD, run, loci, theta, None)
    if found.affine is None:
        return found
    why_not = _turned_wrong(loci, theta_of(run, found.affine), found.noise_nT or 0.0)
    return refused(METHOD, why_not) if why_not else found


def refused(method: str, why_not: str) -> Fit:
    """No answer, and why."""
    return Fit(method, ok=False, why_not=why_not)


def polished_fit(method: str, run: Run, loci: Loci, theta: Array, basis: Array | None) -> Fit:
    """The most likely map near `theta`; refused where its uncertainty leaves the field open.

    It has a covariance unless the noise, white in the readings, would bias it by a part of its uncertainty.
    """
    try:
        found = polish(loci, theta, basis=basis, reference_noise_nT=run.reference.noise_nT or 0.0)
    except np.linalg.LinAlgError:
        return refused(method, "the run does not determine the parameters: the normal equations are singular")
    if why_not := _undetermined(found, loci):
        return refused(method, why_not)
    unit = np.concatenate([np.full(9, run.dut.nominal_nT_per_unit), np.ones(3)])
    affine, frame_known = map_of(run, found.theta), basis is None
    noise = FitNoise.single(found.covariance * np.outer(unit, unit), float(len(loci) + np.sum(loci.locus >= 0)) - 12)
    sources = Sources(noise, contributions(run, affine, frame_known=frame_known))
    unbiased = noise_bias_in_sigma(loci, found) < LARGEST_BIAS
    return Fit(
        method,
        ok=True,
        affine=affine,
        covariance=sources.covariance if unbiased else None,
        sources=sources if unbiased else None,
        frame_known=frame_known,
        noise_nT=found.noise_nT,
    )


def map_of(run: Run, theta: Array) -> AffineMap:
    """The map in the DUT's unit from that of nominal readings."""
    return AffineMap(theta[:9].reshape(3, 3) * run.dut.nominal_nT_per_unit, theta[9:])


def theta_of(run: Run, affine: AffineMap) -> Array:
    """The map (12,) of nominal readings."""
    return np.concatenate([affine.K.ravel() / run.dut.nominal_nT_per_unit, affine.k_nT])


def _open(values: Array, loci: Loci) -> str | None:
    heights = len(values) - 12
    missing = int(np.sum(values < LEAST_SINGULAR_VALUE))
    if not missing:
        return None
    axes = len(np.unique(np.round(np.abs(loci.axes), 3), axis=0))
    return (
        f"the run determines {len(values) - missing - heights} of 12 parameters: {axes} rotation "
        f"{'axis' if axes == 1 else 'axes'} in {len(loci.axes)} segments; rotate about another body axis"
    )


def _undetermined(found: Polished, loci: Loci) -> str | None:
    worst = worst_uncertainty_nT(loci, found)
    if found.converged and worst < LARGEST_UNCERTAINTY * np.mean(loci.magnitude):
        return None
    how = f"the field would be uncertain by {worst:.0f} nT" if found.converged else "the likelihood has no clear summit"
    return f"the run does not determine the parameters: {how}; add longer arcs, another axis or another magnitude"


def _turned_wrong(loci: Loci, theta: Array, noise_nT: float) -> str | None:
    """A locus that turns against its axis, or lies far across it, contradicts what the run declares.

    It does so only where that is clear beyond noise: of the sense of turning, and of the plane's normal.
    """
    tilts = [_tilt_rad(loci, theta, noise_nT, index) for index in range(len(loci.axes))]
    worst = int(np.argmax(tilts))
    if tilts[worst] <= np.radians(LARGEST_TILT_DEG):
        return None
    return (
        f"rotation segment {worst + 1} of {len(tilts)} does not turn about its declared axis_body: at least "
        f"{np.degrees(tilts[worst]):.0f} deg from it"
    )


def _tilt_rad(loci: Loci, theta: Array, noise_nT: float, index: int) -> float:
    """How far the locus turns from its axis at least [rad]: CLEAR uncertainties less than what its points say.

    The noise is what the points show across their plane, but no less than `noise_nT` of one component.
    """
    rows, axis = loci.rows(index), loci.axes[index]
    field = loci.reading[rows] @ theta[:9].reshape(3, 3).T - theta[9:]
    variances, directions = np.linalg.eigh(np.cov(field.T))
    tilt = float(np.arccos(min(abs(directions[:, 0] @ axis), 1.0)))
    noise = max(float(variances[0]), noise_nT**2)
    u = u_normal(float(variances[1]), noise, len(rows))
    value, u_value = sense(field, axis, loci.forward[rows], noise * np.eye(3))
    if value < -CLEAR * u_value:
        tilt = np.pi - tilt
    return float(max(tilt - CLEAR * u, 0.0))
