"""What several effects share: axes' names, moving channels, first-order filters and delays within a segment."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects.protocol import Array
from labcal.record import Run
from labcal.record.run import Channel

AXES = ("x", "y", "z")


def per_axis(name: str, unit: str) -> tuple[tuple[str, str], ...]:
    """Three parameters, one for each axis."""
    return tuple((f"{name}_{axis}", unit) for axis in AXES)


def on_each_axis(drive: Array) -> Array:
    """The same drive (n,) on each body axis, (n, 3, 3)."""
    return np.asarray(drive[:, None, None] * np.eye(3))


def moving(run: Run, quantities: Iterable[str]) -> list[Channel]:
    """Channels of the sensor's side with one of these quantities that move and are known for half of the rows."""
    return [c for c in run.channels if c.role == "dut" and c.quantity in quantities and _moves(c.values)]


def _moves(values: Array) -> bool:
    known = values[np.isfinite(values)]
    return 2 * len(known) >= len(values) and len(known) > 0 and float(np.ptp(known)) > 0


def middle(channel: Channel) -> float:
    """Where a channel counts as zero: its median."""
    return float(np.nanmedian(channel.values))


def stretches(segment: NDArray[np.intp]) -> list[slice]:
    """The runs of rows between changes of segment."""
    edges = np.flatnonzero(np.diff(segment)) + 1
    starts, ends = [0, *edges.tolist()], [*edges.tolist(), len(segment)]
    return [slice(a, b) for a, b in zip(starts, ends, strict=True)]


def low_passed(t_s: Array, segment: NDArray[np.intp], drive: Array, tau_s: float) -> Array:
    """First-order response (n,) to `drive` with time constant `tau_s`, starting anew in each segment.

    Before a segment's first row the drive is taken to have moved as it does over the first tau_s of it.
    """
    if tau_s <= 0:
        return drive
    out = np.empty_like(drive)
    for rows in stretches(segment):
        t, x = t_s[rows], drive[rows]
        out[rows] = _respond(t, x, tau_s, x[0] - tau_s * _slope(t, x, tau_s))
    return out


def _slope(t: Array, x: Array, tau_s: float) -> float:
    head = t <= t[0] + tau_s
    if head.sum() < 5 or np.ptp(t[head]) < tau_s / 4:
        return 0.0
    span = t[head] - t[head].mean()
    return float(span @ x[head] / (span @ span))


def _respond(t: Array, x: Array, tau_s: float, start: float) -> Array:
    """Exact for a drive that is linear between rows."""
    out, state = [start], start
    steps = np.diff(t) / tau_s
    keeps = np.exp(-steps)
    ramps = (1 - keeps) / np.where(steps > 0, steps, 1.0)
    for keep, ramp, before, after in zip(keeps.tolist(), ramps.tolist(), x[:-1].tolist(), x[1:].tolist(), strict=True):
        state = keep * state + (ramp - keep) * before + (1 - ramp) * after
        out.append(state)
    return np.array(out)


def shifted(t_s: Array, segment: NDArray[np.intp], values: Array, by_s: float) -> Array:
    """`values` (n, ...) at t + by_s, a cubic through the neighbours in the same segment; held slope beyond its ends."""
    from scipy.interpolate import CubicHermiteSpline

    out = np.array(values, dtype=float)
    for rows in stretches(segment):
        t, v = t_s[rows], values[rows]
        if len(t) < 3 or not np.all(np.diff(t) > 0):
            continue
        slope = np.gradient(v, t, axis=0)
        inside = np.clip(t + by_s, t[0], t[-1])
        beyond = (t + by_s - inside).reshape(-1, *[1] * (v.ndim - 1))
        spline = CubicHermiteSpline(t, v, slope, axis=0)
        out[rows] = spline(inside) + beyond * spline(inside, 1)
    return out
