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
from labcal.fit.swarm.objectives import Planes, cofactor
from labcal.fit.swarm.polish import Polished, noise_bias_in_sigma, polish, singular_values, worst_uncertainty_nT
from labcal.fit.swarm.search import PUBLISHED, Options, search
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
    if why_not := _open(singular_values(loci, theta), loci) or _turned_wrong(loci, theta):
        return refused(METHOD, why_not)
    if not options.polish:
        return Fit(METHOD, ok=True, affine=map_of(run, theta), frame_known=True)
    return polished_fit(METHOD, run, loci, theta, None)


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
    if why_not := _vague(found, loci):
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


def _vague(found: Polished, loci: Loci) -> str | None:
    worst = worst_uncertainty_nT(loci, found)
    if found.converged and worst < LARGEST_UNCERTAINTY * np.mean(loci.magnitude):
        return None
    how = f"the field would be uncertain by {worst:.0f} nT" if found.converged else "the likelihood has no clear summit"
    return f"the run does not determine the parameters: {how}; add longer arcs, another axis or another magnitude"


def _turned_wrong(loci: Loci, theta: Array) -> str | None:
    """A locus that turns against its axis, or lies far across it, contradicts what the run declares."""
    K, k = theta[:9].reshape(3, 3, 1), theta[9:, None]
    rows = [loci.rows(i) for i in range(len(loci.axes))]
    planes = Planes.of([loci.reading[r] for r in rows], loci.axes, "sequence", [loci.forward[r][:-1] for r in rows])
    cosine = planes.cosines(K, k, cofactor(K))[:, 0]
    cosine *= np.sign(np.sum(cosine)) or 1.0
    if np.min(cosine) > np.cos(np.radians(LARGEST_TILT_DEG)):
        return None
    worst = int(np.argmin(cosine))
    return (
        f"rotation segment {worst + 1} of {len(cosine)} does not turn about its declared axis_body: "
        f"{np.degrees(np.arccos(cosine[worst])):.0f} deg from it"
    )
