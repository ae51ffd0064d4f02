"""The lab of the blind runs: a platform, a coil, channels. Plain numpy, nothing of labcal's."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

AXES = {"x": np.array([1.0, 0, 0]), "y": np.array([0, 1.0, 0]), "z": np.array([0, 0, 1.0])}


def turn(axis, angle):
    """Rotation matrices (n, 3, 3) about one axis."""
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    s, c = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.eye(3) + s * k + (1 - c) * (k @ k)


@dataclass
class Part:
    """One segment."""

    id: str
    kind: str
    t: Any
    cage: Any  # (n, 3) the field in the cage
    to_body: Any  # (n, 3, 3)
    angle: Any  # (n,) rad, NaN where there is none
    at: Any  # a function of times: the field in the body there; at rest before and after
    axis: Any = None
    mode: str = "nominal"
    at_zero: Any = None


@dataclass
class Scene:
    """The whole recording, rows of all segments in time."""

    rng: Any
    parts: list
    t: Any = None
    cage: Any = None
    body: Any = None
    to_body: Any = None
    angle: Any = None
    segment: Any = None
    mode: Any = None
    channels: dict = field(default_factory=dict)  # name -> (values on all rows, unit, quantity)
    clocks: dict = field(default_factory=dict)  # name -> (times, values) of the quantity itself, between recordings too

    def gather(self):
        """Lay the segments end to end."""
        self.t, self.cage = np.concatenate([p.t for p in self.parts]), np.concatenate([p.cage for p in self.parts])
        self.to_body = np.concatenate([p.to_body for p in self.parts])
        self.angle = np.concatenate([p.angle for p in self.parts])
        self.segment = np.concatenate([np.full(len(p.t), i) for i, p in enumerate(self.parts)])
        self.mode = np.concatenate([np.full(len(p.t), p.mode) for p in self.parts])
        self.body = np.einsum("nij,nj->ni", self.to_body, self.cage)
        return self


def rotation_part(rng, name, axis, size, start, seconds, dt, direction, drift, mode):
    """Forth and back about the vertical, the rate a half sine each way."""
    t = start + np.arange(0, seconds, dt) + rng.normal(0, 0.003, int(np.ceil(seconds / dt)))
    t = np.sort(t)
    sweep = rng.uniform(380, 520) * rng.choice([-1, 1])
    zero = rng.uniform(0, 2 * np.pi)
    at_zero = carry(np.array([0, 0, 1.0]), axis)

    def turned(when):
        return np.radians(sweep) * 0.5 * (1 - np.cos(2 * np.pi * (np.clip(when, t[0], t[-1]) - t[0]) / (t[-1] - t[0])))

    def there(when):
        return turn(axis, -(turned(when) + zero)) @ at_zero

    def at(when):
        return np.einsum("nij,nj->ni", there(when), size * direction + drift(when))

    return Part(
        name, "rotation", t, size * direction + drift(t), there(t), turned(t) + rng.uniform(0, 6.28), at, axis, mode
    )


def carry(a, b):
    """A rotation that takes a to b."""
    v, c = np.cross(a, b), float(a @ b)
    k = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return np.diag([1.0, -1, -1]) if c < -0.999 else np.eye(3) + k + k @ k / (1 + c)


def static_part(rng, name, along, start, seconds, dt, drift):
    """At rest while one coil steps up and down."""
    t = start + np.arange(0, seconds, dt)
    top = rng.uniform(45000, 56000)
    w = rng.normal(0, 0.25, 3)
    attitude = turn(w / np.linalg.norm(w), np.full(1, np.linalg.norm(w)))[0]

    def cage(when):
        level = np.round(11 * np.sin(2 * np.pi * (np.clip(when, t[0], t[-1]) - t[0]) / seconds)) / 11 * top
        return np.array([1400.0, -2000, 1700]) + level[:, None] * AXES[along] + drift(when)

    def at(when):
        return cage(when) @ attitude.T

    still = np.repeat(attitude[None], len(t), 0)
    return Part(name, "static", t, cage(t), still, np.full(len(t), np.nan), at, at_zero=attitude)


def record(rng, *, statics, long, modes):
    """Two recordings of one lab: the run, and a fresh one in its gaps about other axes."""
    dt, seconds = (rng.uniform(0.8, 1.25), 280.0) if long else (rng.uniform(0.4, 0.6), 110.0)
    direction = rng.normal(size=3)
    direction /= np.linalg.norm(direction)
    direction[2] = abs(direction[2]) if abs(direction[2]) > 0.35 else 0.5
    direction /= np.linalg.norm(direction)
    slope = rng.normal(0, 0.02, 3)

    def drift(t):
        return slope * t[:, None]

    weak, strong = rng.uniform(16000.0, 25000.0), rng.uniform(42000.0, 52000.0)
    plan = [(a, weak) for a in "xyz"] + [(a, strong) for a in "xyz"]
    plan = [plan[i] for i in rng.permutation(len(plan))]
    parts, fresh, now = [], [], 20.0
    for k, (axis, size) in enumerate(plan):
        mode = modes[k % len(modes)] if rng.random() < 0.8 else modes[0]
        parts.append(
            rotation_part(
                rng, f"{axis}-{size / 1000:.0f}uT", AXES[axis], size, now, seconds, dt, direction, drift, mode
            )
        )
        now += seconds + 25
        tilted = rng.normal(size=3)
        tilted /= np.linalg.norm(tilted)
        other = rng.uniform(28000.0, 42000.0)
        fresh.append(rotation_part(rng, f"e{k}", tilted, other, now, 45.0, dt, direction, drift, mode))
        now += 45 + rng.uniform(20, 40)
        if statics and k % 2 == 1:
            parts.append(static_part(rng, f"s{k // 2}", "xyz"[k // 2], now, 80.0, dt, drift))
            now += 80 + rng.uniform(20, 60)
    return Scene(rng, parts).gather(), Scene(rng, fresh[:-1]).gather(), now


def on_clock(end, make):
    """A quantity on one fine clock: times and values."""
    grid = np.arange(0.0, end + 10, 0.25)
    return grid, make(grid)


def load_current(rng, levels=2):
    """A load that switches, with ripple."""

    def make(grid):
        edges = np.sort(rng.uniform(0, grid[-1], int(grid[-1] / rng.uniform(12, 27))))
        steps = rng.integers(0, levels, len(edges) + 1) / max(levels - 1, 1)
        return 0.2 + rng.uniform(0.4, 1.0) * steps[np.searchsorted(edges, grid)] + rng.normal(0, 0.05, len(grid))

    return make


def quiet_current(rng):
    """A small standing current that wanders."""
    return lambda grid: 0.12 + 0.1 * np.abs(np.sin(grid / rng.uniform(60, 400))) + rng.normal(0, 0.004, len(grid))


def temperature(rng):
    """A room that warms, or a heater that cycles."""
    a, tau, period = rng.uniform(4, 16) * rng.choice([-1, 1]), rng.uniform(200, 900), rng.uniform(250, 800)
    wave = rng.random() < 0.7

    def make(grid):
        trend = a * (1 - np.exp(-grid / tau))
        return 22 + (trend + 0.6 * a * np.sin(2 * np.pi * grid / period) if wave else trend)

    return make


def voltage(rng):
    """A battery that sags and is charged."""
    p = rng.uniform(150, 600)
    return lambda grid: 8.2 - 0.4 * np.abs(np.sin(np.pi * grid / p)) + rng.normal(0, 0.006, len(grid))


def add_channels(rng, run, fresh, end, wanted):
    """What the effect needs, and what has nothing to do with it."""
    makers = {
        "load": (load_current(rng), "A", "current"), "levels": (load_current(rng, 5), "A", "current"),
        "temperature": (temperature(rng), "degC", "temperature"), "voltage": (voltage(rng), "V", "voltage"),
        "quiet": (quiet_current(rng), "A", "current"),
    }  # fmt: skip
    others = [k for k in ("temperature", "voltage", "quiet") if k not in wanted]
    chosen = [*wanted, *[k for k in others if rng.random() < 0.7]]
    names = {}
    for number, index in enumerate(rng.permutation(len(chosen)), start=1):
        make, unit, quantity = makers[chosen[index]]
        names[chosen[index]] = name = f"hk{number:02d}"
        clock = on_clock(end, make)
        for scene in (run, fresh):
            values, scene.clocks[name] = np.interp(scene.t, *clock), clock
            step = {"A": 0.002, "degC": 0.0625, "V": 0.004}[unit]
            scene.channels[name] = (np.round(values / step) * step, unit, quantity, values)
    return names


def shift(scene, by):
    """The field at the device `by` seconds later (n, 3), the device at rest before and after a segment."""
    return np.concatenate([p.at(p.t + by) for p in scene.parts])
