"""What a turn shows while the DUT still stands on the platform: its noise, its sense, and how late the DUT is.

Across the axis a constant field is seen as p(θ) = c + z e^(−iθ) + w e^(+iθ), with p the two components as one complex
number: z turns as it must, w is what soft iron mirrors. A delay τ turns z by ω τ, so turns to and fro tell it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.steps import Blocks, dut_nT
from labcal.bench.streams.samples import Samples, samples
from labcal.geometry import shortest_rotation, unit

Array = NDArray[np.float64]
FEWEST = 20  # samples of a turn that says anything
LEAST_TURN_DEG = 90.0
LEAST_ALONG = 0.2  # of |b| along the axis: less says nothing about its sign
TO_AND_FRO = 0.5  # of the mean rate: as much must the rates of an axis' turns differ
FOURTH = np.sqrt(70.0)  # of white noise in its fourth differences, 1 −4 6 −4 1
OF_MEDIAN = 1.4826  # standard deviation over median deviation, Gaussian


@dataclass(frozen=True, slots=True)
class Turned:
    """One turn as the DUT saw it. `phase_rad` is that of z against the reference; None without a vector reference."""

    noise_nT: float
    u_noise_nT: float
    wrong_signs: int | None  # None where the turn is too short to tell
    rate_rad_per_s: float = 0.0
    phase_rad: float | None = None
    u_phase_rad: float = 0.0


def look_at_turn(bench: Bench, axis_body: Sequence[float], blocks: Blocks) -> Turned:
    """What `blocks`, recorded during a turn about `axis_body`, show."""
    dut, axis = dut_nT(bench, blocks), np.asarray(axis_body, dtype=float)
    noise, u = white_noise(dut.values)
    angle = samples(blocks, "angle", "angle_deg")
    seen = dut.between(angle.t_s[0], angle.t_s[-1])
    theta = np.radians(np.unwrap(angle.values[:, 0], period=360.0))
    if len(seen) < FEWEST or np.ptp(theta) < np.radians(LEAST_TURN_DEG) or not bench.platform.motorised:
        return Turned(noise, u, None)
    z, w, u_phase = _turning(seen.values @ _across(axis), np.interp(seen.t_s, angle.t_s, theta))
    wrong, rate = int(abs(w) > abs(z)), float(np.ptp(theta) / np.ptp(angle.t_s) * np.sign(theta[-1] - theta[0]))
    if bench.config.reference.kind != "vector":
        return Turned(noise, u, wrong, rate)
    field = shortest_rotation(bench.config.platform.axis_cage, axis) @ samples(blocks, "reference").mean
    wrong += _along_is_wrong(seen, field, axis)
    first, second = field @ _across(axis)
    return Turned(noise, u, wrong, rate, float(np.angle(z * (first - 1j * second))), u_phase)


def white_noise(values: Array) -> tuple[float, float]:
    """Standard deviation of the white noise of one axis of `values` (n, 3), and its standard uncertainty.

    From fourth differences, in which a turn of a few degrees a sample is gone, by their median: an outlier is no noise.
    """
    if len(values) < FEWEST:
        return 0.0, np.inf
    steps = np.diff(values, n=4, axis=0)
    found = float(np.mean(OF_MEDIAN * np.median(np.abs(steps), axis=0) / FOURTH))
    return found, found * float(np.sqrt(5.0 / (6.0 * len(steps))))


def delay_of(turns: Sequence[Turned]) -> tuple[float, float] | None:
    """Delay [s] of the DUT behind the angle and its standard uncertainty; None where no turn went back."""
    known = [one for one in turns if one.phase_rad is not None]
    rate = np.array([one.rate_rad_per_s for one in known])
    if len(known) < 2 or np.ptp(rate) < TO_AND_FRO * float(np.mean(np.abs(rate))):
        return None
    phase = np.unwrap([one.phase_rad or 0.0 for one in known])
    A = np.column_stack([rate, np.ones_like(rate)])
    solution = np.linalg.lstsq(A, phase, rcond=None)[0]
    free = max(1, len(known) - 2)
    spread = np.hypot(np.linalg.norm(phase - A @ solution) / np.sqrt(free), max(one.u_phase_rad for one in known))
    return float(solution[0]), float(spread * np.sqrt(np.linalg.inv(A.T @ A)[0, 0]))


def _turning(plane: Array, theta: Array) -> tuple[complex, complex, float]:
    """z, w, and the standard uncertainty [rad] of the phase of z."""
    p = plane[:, 0] + 1j * plane[:, 1]
    A = np.column_stack([np.ones_like(theta), np.exp(-1j * theta), np.exp(1j * theta)])
    solution = np.linalg.lstsq(A, p, rcond=None)[0]
    left = float(np.sqrt(np.mean(np.abs(p - A @ solution) ** 2)))
    z, w = complex(solution[1]), complex(solution[2])
    return z, w, left / (max(abs(z), 1e-9) * np.sqrt(len(p)))


def _across(axis: Array) -> Array:
    """Two unit vectors (3, 2) across `axis` that are right-handed with it."""
    first = unit(np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))]))
    return np.column_stack([first, np.cross(axis, first)])


def _along_is_wrong(seen: Samples, field: Array, axis: Array) -> int:
    along, expected = float(seen.mean @ axis), float(field @ axis)
    least = LEAST_ALONG * float(np.linalg.norm(field))
    return int(min(abs(along), abs(expected)) > least and along * expected < 0)
