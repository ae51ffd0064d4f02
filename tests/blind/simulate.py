"""Runs with an undeclared effect, by a simulator that shares nothing with labcal: `simulate.py OUT COUNT SEED`.

Each run gets a folder: `bundle/` as the contract has it, `fresh.csv` and `truth_fresh.csv` (another recording of the
same device), and under OUT/truth a file that the analysis never sees. Plain numpy, in the device's own reading:
reading = S b + offset + effect + noise.
"""

from __future__ import annotations

import csv
import json
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

AXES = {"x": np.array([1.0, 0, 0]), "y": np.array([0, 1.0, 0]), "z": np.array([0, 0, 1.0])}
SENSOR = (
    "offset-current", "offset-current-squared", "offset-temperature", "offset-channel", "gain-temperature",
    "offset-drift", "offset-step", "offset-mode", "nonlinearity", "cross-field", "hysteresis", "lag", "periodic",
)  # fmt: skip
RIG = ("axis-tilt", "field-gradient", "cage-field", "reference-drift", "dut-dipole-at-reference")
DATA = ("saturation", "outliers")
STRANGE = ("random-walk", "telegraph", "bursts", "rate-squared")
STRENGTHS = (0.5, 2.0, 10.0)


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
    angle = np.radians(sweep) * 0.5 * (1 - np.cos(2 * np.pi * (t - t[0]) / (t[-1] - t[0])))
    cage = size * direction + drift(t)
    zero = rng.uniform(0, 2 * np.pi)
    at_zero = carry(np.array([0, 0, 1.0]), axis)
    to_body = turn(axis, -(angle + zero)) @ at_zero
    return Part(name, "rotation", t, cage, to_body, angle + rng.uniform(0, 6.28), axis, mode)


def carry(a, b):
    """A rotation that takes a to b."""
    v, c = np.cross(a, b), float(a @ b)
    k = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return np.diag([1.0, -1, -1]) if c < -0.999 else np.eye(3) + k + k @ k / (1 + c)


def static_part(rng, name, along, start, seconds, dt, drift):
    """At rest while one coil steps up and down."""
    t = start + np.arange(0, seconds, dt)
    level = np.round(11 * np.sin(2 * np.pi * (t - t[0]) / seconds)) / 11 * rng.uniform(45000, 56000)
    cage = np.array([1400.0, -2000, 1700]) + level[:, None] * AXES[along] + drift(t)
    w = rng.normal(0, 0.25, 3)
    attitude = turn(w / np.linalg.norm(w), np.full(1, np.linalg.norm(w)))[0]
    return Part(
        name, "static", t, cage, np.repeat(attitude[None], len(t), 0), np.full(len(t), np.nan), at_zero=attitude
    )


def record(rng, *, statics, long, modes):
    """Two recordings of one lab: the run, and a fresh one in its gaps about other axes."""
    dt, seconds = (1.0, 280.0) if long else (0.5, 110.0)
    direction = rng.normal(size=3)
    direction /= np.linalg.norm(direction)
    direction[2] = abs(direction[2]) if abs(direction[2]) > 0.35 else 0.5
    direction /= np.linalg.norm(direction)
    slope = rng.normal(0, 0.02, 3)
    drift = lambda t: slope * t[:, None] / 1.0  # noqa: E731
    plan = [(a, 20000.0) for a in "xyz"] + [(a, 50000.0) for a in "xyz"]
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
        other = rng.choice([30000.0, 40000.0])
        fresh.append(rotation_part(rng, f"e{k}", tilted, other, now, 45.0, dt, direction, drift, mode))
        now += 45 + rng.uniform(20, 40)
        if statics and k % 2 == 1:
            parts.append(static_part(rng, f"s{k // 2}", "xyz"[k // 2], now, 80.0, dt, drift))
            now += 80 + rng.uniform(20, 60)
    return Scene(rng, parts).gather(), Scene(rng, fresh[:-1]).gather(), now


def on_clock(run, fresh, end, make):
    """A quantity on one fine clock, read by both recordings."""
    grid = np.arange(0.0, end + 10, 0.25)
    values = make(grid)
    return [np.interp(s.t, grid, values) for s in (run, fresh)]


def load_current(rng, levels=2):
    """A load that switches, with ripple."""

    def make(grid):
        edges = np.sort(rng.uniform(0, grid[-1], int(grid[-1] / 18)))
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
        for scene, values in zip((run, fresh), on_clock(run, fresh, end, make), strict=True):
            step = {"A": 0.002, "degC": 0.0625, "V": 0.004}[unit]
            scene.channels[name] = (np.round(values / step) * step, unit, quantity, values)
    return names


def follow(t, drive, tau):
    """First-order response on the rows' own times, carried over the gaps."""
    out, state = np.empty_like(drive), drive[0]
    for i in range(len(t)):
        if i:
            keep = np.exp(-(t[i] - t[i - 1]) / tau)
            state = keep * state + (1 - keep) * 0.5 * (drive[i] + drive[i - 1])
        out[i] = state
    return out


def relays(x, rng, seed):
    """Preisach: relays with random thresholds, started at rest in each segment (n,)."""
    draw = np.random.default_rng(seed)
    half = draw.gamma(2.0, 1500.0, 150)
    centre = draw.normal(0, 15000.0, 150)
    state = np.sign(x[0] - centre)
    out = np.empty_like(x)
    for i, v in enumerate(x):
        state = np.where(v > centre + half, 1.0, np.where(v < centre - half, -1.0, state))
        out[i] = state.mean()
    return out


def play(x, r):
    """Backlash of half-width r (n,), starting in the middle."""
    out, state = np.empty_like(x), x[0]
    for i, v in enumerate(x):
        state = min(max(state, v - r), v + r)
        out[i] = state
    return out


def per_segment(scene, values, rule):
    """Apply `rule` (n,) -> (n,) to every axis of every segment."""
    out = np.empty_like(values)
    for s in np.unique(scene.segment):
        rows = scene.segment == s
        out[rows] = np.stack([rule(values[rows, k]) for k in range(3)], axis=1)
    return out


def sensor_effect(kind, rng, names, S, span):
    """A function of a scene that gives the effect in the reading (n, 3), at any size."""
    c, seed = rng.normal(size=3), int(rng.integers(1 << 30))
    value = lambda s, name: s.channels[names[name]][3]  # noqa: E731
    sized = lambda s: s.body @ S.T / 50000.0  # noqa: E731
    if kind == "offset-current":
        tau, second = rng.choice([0.0, 0.0, 4.0, 12.0]), rng.random() < 0.3

        def effect(s):
            i = value(s, "load")
            fast = follow(s.t, i, tau) if tau else i
            return (fast + 0.5 * follow(s.t, i, 30.0) if second else fast)[:, None] * c

        return effect
    if kind == "offset-current-squared":
        return lambda s: (value(s, "levels") ** 2)[:, None] * c
    if kind == "offset-temperature":
        tau, curve = rng.choice([0.0, 0.0, 60.0, 200.0]), rng.choice([0.0, 0.0, 0.01])

        def effect(s):
            T = value(s, "temperature") - 22
            T = follow(s.t, T, tau) if tau else T
            return (T + curve * T**2)[:, None] * c

        return effect
    if kind == "offset-channel":
        return lambda s: (value(s, "voltage") - 8)[:, None] * c
    if kind == "gain-temperature":
        return lambda s: (value(s, "temperature") - 22)[:, None] * sized(s) * c
    if kind == "offset-drift":
        how = rng.integers(3)
        shapes = (lambda u: u, lambda u: np.sqrt(u + 0.01), lambda u: 1 - np.exp(-u / 0.3))
        return lambda s: shapes[how](s.t / span)[:, None] * c
    if kind == "offset-step":
        at = rng.uniform(0.25, 0.75) * span
        return lambda s: (s.t > at).astype(float)[:, None] * c
    if kind == "offset-mode":
        return lambda s: (s.mode != "nominal").astype(float)[:, None] * c
    if kind == "nonlinearity":
        shapes = (lambda x: x**3, lambda x: np.tanh(1.4 * x) - 1.4 * x, lambda x: x**2, lambda x: np.abs(x) * x)
        how = shapes[rng.integers(4)]
        return lambda s: how(sized(s)) * c
    if kind == "cross-field":
        other = rng.permutation([1, 2])
        if rng.random() < 0.5:
            return lambda s: sized(s) * np.roll(sized(s), other[0], axis=1) * c
        return lambda s: (
            np.roll(sized(s), 1, axis=1) * np.roll(sized(s), 2, axis=1) * c
            + 0.5 * np.roll(sized(s), other[0], axis=1) ** 2 * c[::-1]
        )
    if kind == "hysteresis":
        if rng.random() < 0.5:
            r = rng.uniform(600, 5000)
            return lambda s: (per_segment(s, s.body @ S.T, lambda x: play(x, r)) - s.body @ S.T) * (np.abs(c) + 0.3)
        return lambda s: per_segment(s, s.body @ S.T, lambda x: relays(x, rng, seed)) * (np.abs(c) + 0.3)
    if kind == "periodic":
        f, phase = rng.uniform(0.06, 0.4), rng.uniform(0, 6.28, 3)
        return lambda s: np.cos(2 * np.pi * f * s.t[:, None] + phase) * c
    if kind == "random-walk":
        grid = np.arange(0, span + 400, 0.25)
        walk = np.cumsum(np.random.default_rng(seed).normal(size=(len(grid), 3)), axis=0)
        return lambda s: np.stack([np.interp(s.t, grid, walk[:, k]) for k in range(3)], axis=1) * c
    if kind == "telegraph":
        draw = np.random.default_rng(seed)
        edges = np.cumsum(draw.exponential(draw.uniform(8, 60), 4000))
        return lambda s: (np.searchsorted(edges, s.t) % 2)[:, None] * c
    if kind == "bursts":
        draw = np.random.default_rng(seed)
        centres = draw.uniform(0, span, int(span / 40))
        return lambda s: np.sum(np.exp(-0.5 * ((s.t[:, None] - centres) / 2.5) ** 2), axis=1)[:, None] * c
    if kind == "rate-squared":

        def effect(s):
            rate = np.zeros(len(s.t))
            for k in np.unique(s.segment):
                rows = s.segment == k
                rate[rows] = np.nan_to_num(np.gradient(s.angle[rows], s.t[rows]))
            return (rate**2)[:, None] * c

        return effect
    raise ValueError(kind)


def rig_effect(kind, rng, span, near):
    """A function of a scene that changes the field at the device (n, 3) in B, or the reference (n, 3) in C."""
    d = rng.normal(size=3)
    into = lambda s, cage: np.einsum("nij,nj->ni", s.to_body, cage)  # noqa: E731
    if kind == "axis-tilt":
        per_axis = rng.random() < 0.6
        tilts = {k: np.array([*rng.normal(size=2), 0]) for k in "xyz"}

        def effect(s):
            out = np.zeros_like(s.body)
            for k, p in enumerate(s.parts):
                if p.kind == "rotation":
                    rows = s.segment == k
                    tilt = tilts["xyz"[int(np.argmax(np.abs(p.axis)))]] if per_axis else tilts["x"]
                    out[rows] = into_rows(s, rows, -np.cross(tilt, s.cage[rows]))
            return out

        return effect
    if kind == "field-gradient":
        g = rng.normal(size=(3, 3))
        g = g + g.T - np.eye(3) * 2 * np.trace(g) / 3
        return lambda s: into(s, s.cage @ g)
    if kind == "cage-field":
        e, f = rng.normal(size=3), rng.normal(size=3)
        if rng.random() < 0.5:
            return lambda s: into(s, np.ones((len(s.t), 1)) * d)
        return lambda s: into(
            s, d + np.cos(np.nan_to_num(s.angle))[:, None] * e + np.sin(np.nan_to_num(s.angle))[:, None] * f
        )
    if kind == "dut-dipole-at-reference":
        r = np.linalg.norm(near)
        u = near / r
        return lambda s: into(
            s, -(3 * (np.einsum("nji,j->ni", s.to_body, d) @ u)[:, None] * u - np.einsum("nji,j->ni", s.to_body, d))
        )
    raise ValueError(kind)


def into_rows(s, rows, cage):
    """Cage vectors of some rows into the body."""
    return np.einsum("nij,nj->ni", s.to_body[rows], cage)


def left_by_base(scene, effect, S):
    """Rms length of what K, k and the phases cannot absorb of an effect (n, 3) in the reading."""
    inverse = np.linalg.inv(S)
    e = effect @ inverse.T
    n = len(e)
    A = [np.kron(scene.body, np.eye(3)), np.kron(np.ones((n, 1)), np.eye(3))]
    for k, p in enumerate(scene.parts):
        if p.kind == "rotation":
            A.append((np.cross(p.axis, scene.body) * (scene.segment == k)[:, None]).reshape(-1, 1))
    A = np.concatenate(A, axis=1)
    A = A / np.linalg.norm(A, axis=0)
    y = e.reshape(-1)
    left = y - A @ np.linalg.lstsq(A, y, rcond=1e-8)[0]
    return float(np.sqrt(np.sum(left**2) / n))


def make_run(seed, kinds, strength):
    """One run: scenes, readings, truth."""
    rng = np.random.default_rng(seed)
    scalar = not set(kinds) & {*RIG, "lag", "reference-drift", "saturation"} and rng.random() < 0.12
    no_angle = not scalar and not set(kinds) & {*RIG, "lag", "reference-drift"} and rng.random() < 0.05
    modes = ["nominal", "full-power"] if "offset-mode" in kinds or rng.random() < 0.3 else ["nominal"]
    run, fresh, end = record(
        rng, statics=rng.random() < 0.5 and not scalar, long="lag" in kinds or rng.random() < 0.2, modes=modes
    )
    wanted = {"offset-current": ["load"], "offset-current-squared": ["levels"], "offset-temperature": ["temperature"],
              "gain-temperature": ["temperature"], "offset-channel": ["voltage"]}  # fmt: skip
    names = add_channels(rng, run, fresh, end, [w for k in kinds for w in wanted.get(k, [])])
    S = np.eye(3) + rng.normal(0, 0.05, (3, 3))
    offset = rng.normal(0, 3500, 3)
    noise = float(rng.choice([20, 25, 30, 45, 50]))
    near = rng.normal(size=3)
    near *= 0.25 / np.linalg.norm(near)
    floor = noise * np.sqrt(np.sum(np.linalg.inv(S) ** 2))
    zero = [np.zeros_like(run.cage), np.zeros_like(fresh.cage)]
    state = {"run": run, "fresh": fresh, "S": S, "noise": noise, "lag": 0.0, "reference": zero}
    readings = [np.zeros_like(s.body) for s in (run, fresh)]
    sizes = []
    for kind in kinds:
        if kind in DATA:
            continue
        if kind == "lag":
            pilot = shift(run, 0.5) @ S.T - run.body @ S.T
            state["lag"] = min(0.5 * strength * floor / left_by_base(run, pilot, S), 4.0) * rng.choice([-1, 1])
            continue
        if kind == "reference-drift":
            d = rng.normal(size=3)
            slope = lambda s, d=d: (s.t / end)[:, None] * d  # noqa: E731
            unit = left_by_base(run, np.einsum("nij,nj->ni", run.to_body, slope(run)) @ S.T, S)
            state["reference"] = [slope(s) * strength * floor / unit for s in (run, fresh)]
            continue
        if kind in RIG:
            effect = rig_effect(kind, rng, end, near)
            here = [effect(s) @ S.T for s in (run, fresh)]
        else:
            effect = sensor_effect(kind, rng, names, S, end)
            here = [effect(s) for s in (run, fresh)]
        unit = left_by_base(run, here[0], S)
        size = strength * floor / max(unit, 1e-12)
        sizes.append(size)
        # what the rig does is there in the run; the fresh recording is scored against the field at the device
        for out, add, fresh_one in zip(readings, here, (False, True), strict=True):
            if not (fresh_one and kind in RIG):
                out += size * add
    out = []
    for scene, effect, ref in zip((run, fresh), readings, state["reference"], strict=True):
        seen = shift(scene, -state["lag"]) if state["lag"] else scene.body
        clean = seen @ S.T + offset + rng.normal(0, noise, scene.body.shape)
        out.append((clean + effect, scene.cage + ref + rng.normal(0, 3.5, scene.cage.shape), clean))
    return rng, state, names, out, scalar, no_angle, near, offset


def shift(scene, by):
    """The field at the device `by` seconds later (n, 3)."""
    out = np.empty_like(scene.body)
    for k in np.unique(scene.segment):
        rows = scene.segment == k
        for j in range(3):
            out[rows, j] = np.interp(scene.t[rows] + by, scene.t[rows], scene.body[rows, j])
    return out


def spoil(rng, kinds, readings, noise, strength):
    """Outliers and a rail, in place."""
    valid = np.ones(len(readings), dtype=bool)
    if "outliers" in kinds:
        rows = rng.choice(len(readings), int(len(readings) * rng.uniform(0.005, 0.03)), replace=False)
        readings[rows] += rng.normal(0, 60 * noise, (len(rows), 3)) + 30 * noise * rng.choice([-1, 1], (len(rows), 3))
        valid[rows] = False
    if "saturation" in kinds:
        rail = np.quantile(np.abs(readings), 1 - {0.5: 0.01, 2.0: 0.03, 10.0: 0.08}[strength])
        valid &= ~(np.abs(readings) > rail).any(axis=1)
        np.clip(readings, -rail, rail, out=readings)
    return valid


def write(folder, scene, reading, reference, channels, scalar, no_angle, with_reference, rng):
    """samples.csv with what belongs in it."""
    head = ["t_s", "segment", "dut_x", "dut_y", "dut_z"] + (["ref_f"] if scalar else ["ref_x", "ref_y", "ref_z"])
    head += [] if scalar or no_angle else ["angle_deg"]
    head += [*channels, "mode"]
    gaps = {name: rng.random(len(scene.t)) < (0.02 if rng.random() < 0.25 else 0) for name in channels}
    folder.parent.mkdir(parents=True, exist_ok=True)
    with folder.open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(head)
        for i in range(len(scene.t)):
            row = [
                f"{scene.t[i]:.4f}",
                scene.parts[scene.segment[i]].id,
                *(f"{np.round(v * 2) / 2:.1f}" for v in reading[i]),
            ]
            ref = [np.linalg.norm(reference[i])] if scalar else reference[i]
            row += [f"{v:.2f}" if with_reference else "" for v in ref]
            if not (scalar or no_angle):
                a = np.degrees(scene.angle[i])
                row.append("" if np.isnan(a) else f"{np.round(a / 0.02) * 0.02 % 360:.2f}")
            row += ["" if gaps[c][i] else f"{scene.channels[c][0][i]:.4f}" for c in channels]
            row.append(scene.mode[i])
            out.writerow(row)


def segment_json(part, scalar, no_angle):
    """What run.json says of a segment."""
    out = {"id": part.id, "kind": "free" if scalar else part.kind, "mode": part.mode, "note": ""}
    if not scalar and part.kind == "rotation":
        out |= {"axis_body": [float(v) for v in part.axis], "axis_cage": [0.0, 0.0, 1.0]}
    if not scalar and part.kind == "static":
        out["body_from_cage"] = np.round(part.at_zero, 9).tolist()
    return out


def publish(out, index, seed, kinds, strength):
    """Write one run and its truth."""
    rng, state, names, recordings, scalar, no_angle, near, offset = make_run(seed, kinds, strength)
    run, fresh, noise = state["run"], state["fresh"], state["noise"]
    (reading, reference, _), (fresh_reading, _, fresh_clean) = recordings
    spoil(rng, kinds, reading, noise, strength)
    name = f"b{index:04d}"
    channels = sorted(run.channels)
    write(out / name / "bundle" / "samples.csv", run, reading, reference, channels, scalar, no_angle, True, rng)
    write(
        out / name / "fresh.csv",
        fresh,
        fresh_reading,
        fresh.cage,
        channels,
        scalar,
        no_angle,
        False,
        np.random.default_rng(0),
    )
    meta = {
        "format": "labcal-run/1", "run_id": name, "started_utc": "2026-05-01T08:00:00Z", "simulated": True, "operator": "",
        "dut": {"serial": f"SN{seed % 1000}", "model": "M", "unit": "nT", "nominal_nT_per_unit": 1.0, "noise_nT": noise},
        "reference": {"kind": "scalar" if scalar else "vector", "serial": "R"},
        "segments": [segment_json(p, scalar, no_angle) for p in run.parts],
        "channels": {c: {"unit": run.channels[c][1], "quantity": run.channels[c][2]} for c in channels},
    }  # fmt: skip
    if "dut-dipole-at-reference" in kinds:
        meta["reference"]["position_m"] = near.tolist()
    (out / name / "bundle" / "run.json").write_text(json.dumps(meta, indent=1))
    np.savetxt(out / name / "truth_fresh.csv", fresh.body, delimiter=",", fmt="%.3f")
    inverse = np.linalg.inv(state["S"])
    knowing = (fresh_clean - offset) @ inverse.T
    truth_body = shift(fresh, -state["lag"]) if state["lag"] else fresh.body
    knew = (
        np.linalg.norm(knowing, axis=1) - np.linalg.norm(truth_body, axis=1)
        if scalar
        else np.linalg.norm(knowing - truth_body, axis=1)
    )
    truth = {"seed": seed, "cause": list(kinds), "strength": strength, "scalar": scalar, "no_angle": no_angle,
             "channels": names, "knowing_rms_nT": float(np.sqrt(np.mean(knew**2))), "lag_s": state["lag"]}  # fmt: skip
    (out / "truth").mkdir(exist_ok=True)
    (out / "truth" / f"{name}.json").write_text(json.dumps(truth))


def menu(count, seed):
    """Causes and strengths of `count` runs, in a mixed order."""
    rng = np.random.default_rng(seed)
    single = [(k,) for k in (*SENSOR, *RIG, *DATA)]
    out = []
    while len(out) < count:
        turn_ = [(kinds, strength) for kinds in single for strength in STRENGTHS]
        turn_ += [((k,), s) for k in STRANGE for s in (2.0, 10.0)]
        turn_ += [((), 0.0)] * 32
        pairs = [("offset-current", "offset-temperature"), ("lag", "offset-current"), ("nonlinearity", "offset-temperature"),
                 ("axis-tilt", "offset-current"), ("hysteresis", "gain-temperature"), ("offset-mode", "cross-field")]  # fmt: skip
        turn_ += [(p, s) for p in pairs for s in (2.0, 10.0)]
        out += [turn_[i] for i in rng.permutation(len(turn_))]
    return out[:count]


def main(out, count, seed):
    """Write the runs."""
    for index, (kinds, strength) in enumerate(menu(count, seed)):
        publish(Path(out), index, seed * 100000 + index, kinds, strength)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
