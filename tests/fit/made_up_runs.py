"""Runs of a made-up sensor in a made-up cage, for the tests of the scalar methods."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from labcal.record import Channel, Dut, Reference, Run, Segment

BIAS = np.array([1800.0, -950.0, 2600.0])
D = np.array([[0.03, 0.012, -0.02], [0.012, -0.025, 0.008], [-0.02, 0.008, 0.015]])


def run_of(
    field: np.ndarray, seed: int, *, noise: float = 25.0, bias: object = BIAS, gain: float = 1.0, **more: object
) -> Run:
    """A free run whose DUT sees `field` (n, 3) [nT, B] and reads ((I + D)⁻¹ (field + bias) + noise) / gain."""
    random = np.random.default_rng(seed)
    reading = np.linalg.solve(np.eye(3) + D, (field + bias).T).T + noise * random.standard_normal(field.shape)
    return Run(
        run_id="made-up",
        started_utc="2026-01-01T00:00:00Z",
        simulated=True,
        operator="",
        dut=Dut(serial="s", unit="nT" if gain == 1 else "count", nominal_nT_per_unit=gain, noise_nT=noise or 1.0),
        reference=Reference(kind="scalar"),
        segments=(Segment("all", "free"),),
        t_s=np.arange(len(field)) * 0.1,
        segment_index=np.zeros(len(field), dtype=np.intp),
        reading=reading / gain,
        reference_magnitude=np.linalg.norm(field, axis=1),
        **more,
    )


def circles(
    axes: Sequence[int], magnitudes: Sequence[float], *, angle_to_axis_deg: float = 90.0, each: int = 300
) -> np.ndarray:
    """Fields (n, 3) [nT, B] while the body turns once about each axis in fields of each magnitude."""
    turn = np.linspace(0, 2 * np.pi, each, endpoint=False)
    tilt = np.radians(angle_to_axis_deg)
    out = []
    for axis in axes:
        for magnitude in magnitudes:
            circle = np.stack(
                [np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.full(each, np.cos(tilt))], 1
            )
            out.append(magnitude * np.roll(circle, axis + 1, axis=1))
    return np.vstack(out)


def tumbling(seed: int, n: int = 1000, *, low: float = 20_000.0, high: float = 48_000.0) -> np.ndarray:
    """Fields (n, 3) [nT, B] in every direction, their magnitude between `low` and `high`."""
    random = np.random.default_rng([seed, 7])
    direction = random.standard_normal((n, 3))
    return direction / np.linalg.norm(direction, axis=1, keepdims=True) * random.uniform(low, high, (n, 1))


def current(name: str, values: np.ndarray) -> Channel:
    return Channel(name, "A", "current", values)
