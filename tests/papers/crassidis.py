"""Table 1 of Crassidis, Lai & Harman 2003: a TRMM-like orbit, thirty runs, the batch estimates and the filters.

Earth-pointing (z down, y against the orbit's normal), 402 km, 35°, 8 h at 10 s, Σ = (0.5 mG)² I in the field. The paper
does not state the orbit's phase; node at 30° and argument of latitude 270° come close to what it prints.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from datetime import datetime, timedelta
from functools import cache

import as_printed
import numpy as np
from numpy.typing import NDArray
from orbit import circular, field

from labcal.fit import fit
from labcal.fit.filters.ekf import EKF
from labcal.fit.filters.sequential import LiveFilter
from labcal.fit.filters.ukf import UKF, AugmentedUKF
from labcal.fit.scalar import centered, scalar_check, twostep
from labcal.fit.scalar.scalar_check import Estimate
from labcal.record import Dut, Reference, Run, Segment

Array = NDArray[np.float64]
NAMES = ("b1", "b2", "b3", "D11", "D22", "D33", "D12", "D13", "D23")
BIAS_MG, D = np.array([50.0, 30.0, 60.0]), np.full((3, 3), 0.05) + np.diag([0.0, 0.05, 0.0])
TRUTH = np.concatenate([BIAS_MG, scalar_check.stacked(D)])
SIGMA_MG = 0.5
NODE_DEG, LATITUDE_DEG = 30.0, 270.0
PHASES_DEG = np.arange(16) * 22.5
ORBITS_DEG = tuple((node, latitude) for node in (0.0, 90.0, 180.0, 270.0) for latitude in (0.0, 120.0, 240.0))
READING_NOISE = SIGMA_MG**2 * np.linalg.inv((np.eye(3) + D) @ (np.eye(3) + D))  # Σ as it stands at the reading

PRINTED = {  # mean and largest deviation of thirty runs
    "TWOSTEP": ((49.9620, 29.8174, 60.0331, 0.0500, 0.0993, 0.0500, 0.0499, 0.0499, 0.0501),
                (0.4320, 0.4258, 0.3165, 0.0001, 0.0014, 0.0001, 0.0010, 0.0001, 0.0007)),
    "Centered": ((49.9700, 29.5937, 60.0456, 0.0500, 0.0988, 0.0500, 0.0499, 0.0499, 0.0501),
                 (0.5525, 5.5779, 0.3165, 0.0001, 0.0123, 0.0001, 0.0011, 0.0001, 0.0007)),
    "EKF": ((49.4029, 19.5297, 50.3248, 0.0492, 0.0736, 0.0481, 0.0313, 0.0440, 0.0287),
            (2.2625, 2.2044, 1.2340, 0.0008, 0.0075, 0.0004, 0.0051, 0.0006, 0.0030)),
    "UF": ((49.7289, 29.4657, 59.4561, 0.0499, 0.0949, 0.0499, 0.0486, 0.0495, 0.0487),
           (0.4328, 0.3598, 0.2331, 0.0001, 0.0013, 0.0001, 0.0010, 0.0002, 0.0006)),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Column:
    """Estimates of several runs: mean and largest deviation (9,), mean normalised error squared (9 is expected)."""

    mean: Array
    deviation: Array
    error_squared: float


@cache
def trmm(latitude_deg: float = LATITUDE_DEG, node_deg: float = NODE_DEG, days: float = 0.0) -> Array:
    """The field in the body (2881, 3) [mG], so many days after the 1st of January 2003."""
    t = np.arange(0, 8 * 3600 + 1, 10.0)
    position, velocity = circular(t, altitude_km=402, inclination_deg=35, node_deg=node_deg, latitude_deg=latitude_deg)
    inertial = field(t, position, 402, datetime(2003, 1, 1) + timedelta(days=days)) / 100  # 1 mG = 100 nT
    axes = velocity, -np.cross(position, velocity), -position
    return np.stack([np.sum(inertial * axis, axis=1) for axis in axes], axis=1)


def readings(
    seed: int, latitude_deg: float = LATITUDE_DEG, node_deg: float = NODE_DEG, sigma_mG: float = SIGMA_MG
) -> tuple[Array, Array]:
    """Readings (2881, 3) by (1) and magnitudes (2881,) [mG]."""
    in_body = trmm(latitude_deg, node_deg)
    noisy = in_body + BIAS_MG + sigma_mG * np.random.default_rng(seed).standard_normal(in_body.shape)
    return np.linalg.solve(np.eye(3) + D, noisy.T).T, np.linalg.norm(in_body, axis=1)


def run_of(seed: int, orbit: tuple[float, ...], sigma_mG: float = SIGMA_MG) -> Run:
    """A run [nT] on the orbit (node, argument of latitude [deg], days), noise white in the readings, not declared."""
    node_deg, latitude_deg, *days = orbit
    in_body = 100 * trmm(latitude_deg, node_deg, *days)
    noise = 100 * sigma_mG * np.random.default_rng(seed).standard_normal(in_body.shape)
    return Run(
        run_id=f"trmm-{seed}",
        started_utc="2003-01-01T00:00:00Z",
        simulated=True,
        operator="",
        dut=Dut("model"),
        reference=Reference("scalar"),
        segments=(Segment("orbit", "free"),),
        t_s=10.0 * np.arange(len(in_body)),
        segment_index=np.zeros(len(in_body), dtype=np.intp),
        reading=np.linalg.solve(np.eye(3) + D, (in_body + 100 * BIAS_MG).T).T + noise,
        reference_magnitude=np.linalg.norm(in_body, axis=1),
    )


@dataclass(frozen=True, slots=True)
class Answers:
    """A method's answers over seeds on one orbit: errors and standard uncertainties (answered, 9) [nT, 1], refusals."""

    error: Array
    u: Array
    refused: int


def answers(method: str, orbit: tuple[float, ...], seeds: Iterable[int], sigma_mG: float = SIGMA_MG) -> Answers:
    """Fit every seed's run by `method`; k, then K's 11 22 33 12 13 23."""
    truth, order = np.concatenate([(np.eye(3) + D).ravel(), 100 * BIAS_MG]), [9, 10, 11, 0, 4, 8, 1, 2, 5]
    found = [fit(run_of(seed, orbit, sigma_mG), method, holdout=False) for seed in seeds]
    good = [one for one in found if one.ok]
    return Answers(
        np.array([(one.affine.parameters - truth)[order] for one in good]).reshape(-1, 9),
        np.array([np.sqrt(np.diag(one.covariance))[order] for one in good]).reshape(-1, 9),
        len(found) - len(good),
    )


def batch(module: object, *, unbiased: bool, noise: Array = READING_NOISE) -> Callable[[Array, Array], Estimate]:
    """`centered` or `twostep`, as published or with the noise's share taken off."""
    return lambda B, H: module.estimate(B, H, noise, unbiased=unbiased)


def printed_filter(*, unscented: bool, carried: bool = False) -> Callable[[Array, Array], Estimate]:
    """A filter as printed."""
    return lambda B, H: scalar_check.from_c_E(*as_printed.run(B, H, SIGMA_MG, unscented=unscented, carried=carried))


def our_filter(kind: type[LiveFilter]) -> Callable[[Array, Array], Estimate]:
    """A live filter, fed reading by reading; raises AssertionError where it says that it has diverged."""

    def end(B: Array, H: Array) -> Estimate:
        live = kind(READING_NOISE)
        for reading, magnitude in zip(B, H.tolist(), strict=True):
            live.update(reading, magnitude)
        assert live.diverged() is None
        return live.estimate()

    return end


def column(estimate: Callable[[Array, Array], Estimate], seeds: Iterable[int]) -> Column:
    """Run an estimator over seeds; a run that ends without real scale factors is left out."""
    values, squares = [], []
    for seed in seeds:
        try:
            found = estimate(*readings(seed))
        except ArithmeticError:
            continue
        values.append(found.theta)
        squares.append(error_squared(found))
    mean = np.mean(values, axis=0)
    return Column(mean, np.abs(np.array(values) - mean).max(axis=0), float(np.mean(squares)))


def error_squared(found: Estimate) -> float:
    """(θ̂ − θ)ᵀ P⁻¹ (θ̂ − θ)."""
    error = found.theta - TRUTH
    return float(error @ np.linalg.solve(found.covariance, error))


def over_phases(estimate: Callable[[Array, Array], Estimate]) -> tuple[Array, Array]:
    """Distance from TWOSTEP over its standard uncertainty (16, 9), and b1 (16,) [mG]; seed 0 in every phase."""
    distance, b1 = [], []
    for phase in PHASES_DEG:
        B, H = readings(0, phase)
        batch, found = twostep.estimate(B, H, READING_NOISE), estimate(B, H)
        distance.append((found.theta - batch.theta) / np.sqrt(np.diag(batch.covariance)))
        b1.append(found.bias[0])
    return np.array(distance), np.array(b1)


def section(seeds: int = 30) -> str:
    """The section of docs/papers.md."""
    print_of = [(name, Column(np.array(m), np.array(d), np.nan)) for name, (m, d) in PRINTED.items()]
    batches = [
        ("TWOSTEP, published", column(batch(twostep, unbiased=False), range(seeds))),
        ("`twostep`", column(batch(twostep, unbiased=True), range(seeds))),
        ("Centered, published", column(batch(centered, unbiased=False), range(seeds))),
        ("`centered`", column(batch(centered, unbiased=True), range(seeds))),
    ]
    filters = [
        ("EKF as printed", column(printed_filter(unscented=False), range(seeds))),
        ("UF as printed", column(printed_filter(unscented=True), range(seeds))),
        ("UF, (48) carried to (c, E)", column(printed_filter(unscented=True, carried=True), range(seeds))),
        ("`ekf`", column(our_filter(EKF), range(seeds))),
        ("`ukf`", column(our_filter(UKF), range(seeds))),
        ("`ukf-augmented`", column(our_filter(AugmentedUKF), range(seeds))),
    ]
    phases = [
        ("UF as printed", over_phases(printed_filter(unscented=True))),
        ("`ukf`", over_phases(our_filter(UKF))),
    ]
    return TEXT.format(
        last=seeds - 1,
        batches=table([print_of[0], *batches[:2], print_of[1], *batches[2:]]),
        filters=table([print_of[2], filters[0], print_of[3], *filters[1:]]),
        centred="\n".join(centred_row(method, range(seeds)) for method in ("centered", "centered-sequential")),
        phases="\n".join(
            f"| {name} | {np.sqrt(np.mean(z**2)):.2f} | {np.abs(z).max():.2f} | {b1.min():.1f} to {b1.max():.1f} |"
            for name, (z, b1) in phases
        ),
    )


def centred_row(method: str, seeds: Iterable[int]) -> str:
    """A line about all of ORBITS_DEG: answers, error over uncertainty, and what b2, the worst of nine, scatters by."""
    found = [answers(method, orbit, seeds) for orbit in ORBITS_DEG]
    answered, refused = sum(len(one.u) for one in found), sum(one.refused for one in found)
    z = np.concatenate([one.error / one.u for one in found])
    scatter, u = [one.error[:, 1].std(ddof=1) for one in found], [np.median(one.u[:, 1]) for one in found]
    return (
        f"| `{method}` | {answered} of {answered + refused} | {np.sqrt(np.mean(z**2)):.2f} | "
        f"{100 * np.mean(np.abs(z) < 1.96):.1f} % | {min(scatter):.0f} to {max(scatter):.0f} nT | "
        f"{min(u):.0f} to {max(u):.0f} nT |"
    )


def table(columns: list[tuple[str, Column]]) -> str:
    """One row an estimator: mean ± largest deviation of each parameter, then the normalised error squared."""
    head = "| | " + " | ".join((*NAMES, "error²")) + " |\n|" + "---|" * 11
    truth = "| truth | " + " | ".join([*(f"{t:g}" for t in TRUTH), "9"]) + " |"
    return "\n".join([head, truth, *(row(name, found) for name, found in columns)])


def row(name: str, found: Column) -> str:
    """A line of the table."""
    digits = [2, 2, 2, 4, 4, 4, 4, 4, 4]
    cells = [f"{m:.{d}f} ± {x:.{d}f}" for m, x, d in zip(found.mean, found.deviation, digits, strict=True)]
    return (
        f"| {name} | "
        + " | ".join([*cells, "" if np.isnan(found.error_squared) else f"{found.error_squared:.3g}"])
        + " |"
    )


TEXT = """## Crassidis, Lai & Harman 2003, Table 1

A TRMM-like orbit (402 km, 35°, Earth-pointing, node at 30°, argument of latitude 270° at the start), 8 h at 10 s, noise
0.5 mG, seeds 0 to {last}. Mean ± largest deviation, b in mG; "error²" is the mean of the normalised error squared,
(θ̂ − θ)ᵀ P⁻¹ (θ̂ − θ), 9 where the covariance is honest. Rows without it are the paper's.

{batches}

"Published" keeps the share of the noise in the moments: the regressors are made of the readings, so their noise
correlates with that of the observation. Our estimates take it off.

{filters}

The filters' columns cannot be reproduced as printed. Their start (48) is written for (b, D) and used for (c, E), where
the true E22 = 0.215 lies 6.8 standard deviations out; the covariance is too small by far. Carrying the start properly
and subtracting the noise mean does not mend it: what one linearisation of |b|² gets wrong is the same in every later
sample and never averages out. Ours keep the first readings (about an orbit here) until TWOSTEP on them knows b well
enough for |b|² to be linear within their noise, and start from its covariance.

The centred estimates on twelve orbits (nodes 0°, 90°, 180° and 270°, arguments of latitude 0°, 120° and 240°), noise
white in the readings and not declared, seeds 0 to {last} on each: error over standard uncertainty (rms of all nine
parameters), truths inside 95 % intervals, and the least and the most that b2 scatters over the seeds of one orbit,
beside the uncertainty stated. The residual is taken about its mean: the error of |b|² stays in that mean by (17), and
with it the noise would come out up to three times too large.

| method | answered | error / u | held | b2, scatter | b2, u |
|---|---|---|---|---|---|
{centred}

Over 16 phases of the orbit (argument of latitude in steps of 22.5°, seed 0), distance from `twostep` over its standard
uncertainty, of all nine parameters, and the range of b1:

| filter | rms | largest | b1, mG |
|---|---|---|---|
{phases}
"""
