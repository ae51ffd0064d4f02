"""From loci to the swarm's answer: which objective, which weights, and the map repaired where it is a reflection."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.fit.swarm.loci import Loci
from labcal.fit.swarm.objectives import MagnitudeObjective, Planes, RotationAxisObjective, SignRule
from labcal.fit.swarm.particle_swarm import Objective, SwarmSettings, minimise, refine

Array = NDArray[np.float64]
LARGEST_U_TILT = 0.3  # rad, of the plane of a locus: one less certain has no plane to speak of


@dataclass(frozen=True, slots=True)
class Options:
    """How the swarm searches; gains per nominal gain, biases in nT. The ranges are those of Table I.

    `weights` "by-hand" are the paper's 1 and 4e4, "noise" those that make (10) fall with the likelihood. `log_det`
    adds the term that keeps the swarm from K → 0. `most_samples` thins the magnitudes that the swarm looks at.
    """

    settings: SwarmSettings = field(default_factory=lambda: SwarmSettings(iterations=200))
    gain_range: float = 1.0
    bias_range_nT: float = 5000.0
    refinements: int = 1
    gain_reach: float = 0.1
    bias_reach_nT: float = 1000.0
    sign: SignRule = "sequence"
    weights: Literal["by-hand", "noise"] = "by-hand"
    log_det: bool = True
    polish: bool = True
    most_samples: int = 1000


PUBLISHED = Options(SwarmSettings(), refinements=0, sign="two-samples", log_det=False, polish=False, most_samples=10**9)


@dataclass(frozen=True, slots=True, eq=False)
class SwarmResult:
    """The swarm's best map (12,), a rotation's worth of it repaired, and its value F_g of (10) [nT]."""

    theta: Array
    value: float


def search(loci: Loci, noise_nT: float, options: Options, seed: int, basis: Array | None = None) -> SwarmResult:
    """Let the swarm minimise (10), or (8) alone where `basis` (12, q) leaves no rotation to find."""
    objective = objective_of(loci, noise_nT, options, axes=basis is None)
    basis = np.eye(12) if basis is None else basis
    scale = np.where(basis[:9].any(axis=0), options.gain_range, options.bias_range_nT)
    reach = np.where(basis[:9].any(axis=0), options.gain_reach, options.bias_reach_nT)
    rng, inside = np.random.default_rng(seed), _within(objective, basis)
    best = minimise(inside, -scale, scale, rng, options.settings)
    for _ in range(options.refinements):
        best = refine(inside, best, reach, rng, options.settings)
    return SwarmResult(repaired(basis @ best.position), best.value)


def objective_of(loci: Loci, noise_nT: float, options: Options, *, axes: bool = True) -> RotationAxisObjective:
    """Equation (10) for these loci."""
    step = max(1, len(loci) // options.most_samples)
    magnitudes = MagnitudeObjective.of(loci.reading[::step], loci.magnitude[::step])
    n = len(magnitudes.magnitude)
    radius_squared = loci.magnitude**2 - np.nan_to_num(loci.along) ** 2
    wide = [i for i in range(len(loci.axes)) if _u_tilt(radius_squared[loci.rows(i)], noise_nT) < LARGEST_U_TILT]
    det = noise_nT / np.sqrt(n) if options.log_det else 0.0
    if not axes or not wide:
        return RotationAxisObjective(magnitudes, weight_det_nT=det)
    rows = [loci.rows(i) for i in wide]
    planes = Planes.of(
        [loci.reading[r] for r in rows], loci.axes[wide], options.sign, [loci.forward[r][:-1] for r in rows]
    )
    if options.weights == "by-hand":
        return RotationAxisObjective(magnitudes, planes, weight_det_nT=det)
    radius_squared_mean = float(np.mean(radius_squared[np.concatenate(rows)]))
    axis_weight = axis_weight_nT(noise_nT, n, len(wide), radius_squared_mean)
    return RotationAxisObjective(magnitudes, planes, 1.0, axis_weight, det)


def _u_tilt(radius_squared: Array, noise_nT: float) -> float:
    """Standard uncertainty [rad] of the normal of a full circle's plane, from its squared radii (n,)."""
    of_noise, spread = noise_nT**2, float(np.mean(radius_squared)) / 2
    return u_normal(spread + of_noise, of_noise, len(radius_squared))


def u_normal(middle: float, least: float, samples: int) -> float:
    """Standard uncertainty [rad] of a plane's normal, by which it tilts about the long way of its points.

    √(λ₂ λ₃ / n) / (λ₂ − λ₃) for the variances λ of the points, λ₃ across the plane (Anderson, Ann. Math. Statist. 34,
    122, 1963); infinite where these are alike.
    """
    apart = middle - least
    return float(np.sqrt(middle * least / samples) / apart) if apart > 0 else np.inf


def axis_weight_nT(noise_nT: float, samples: int, loci: int, radius_squared: float) -> float:
    """c_f2 for c_f1 = 1 that the noise asks for.

    A plane tilted by θ puts its n / n_l samples θ r / √2 (rms) off it, worth n r² θ² / 4 n_l σ² of log likelihood;
    √F2 is √n_l θ² / 2 where all tilts are alike, and a change of F1 by 2 σ² moves √F1 / n by σ / √n³. With the
    numbers of the paper's model 1 this is 5.3e4 against 4e4 by hand.
    """
    return float(np.sqrt(loci / samples) * radius_squared / (2 * noise_nT))


def repaired(theta: Array) -> Array:
    """Equation (11) with k: K and k change sign together where K is a reflection, as |K m − k| demands."""
    return np.asarray(theta if np.linalg.det(theta[:9].reshape(3, 3)) > 0 else -theta)


def _within(objective: RotationAxisObjective, basis: Array) -> Objective:
    if basis.shape[1] == 12:
        return objective
    return lambda positions: objective(positions @ basis.T)
