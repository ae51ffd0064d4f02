"""What can be at work in a blind run: effects of the sensor and of the rig, as functions of a scene."""

from __future__ import annotations

import numpy as np


def log_uniform(rng, low, high):
    """One positive number, each octave as likely as any other."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def follow(s, name, tau):
    """First-order response to a channel at the rows: it goes on between recordings as the quantity itself does."""
    t, drive = s.clocks[name]
    return np.interp(s.t, t, followed(t, drive, tau))


def followed(t, drive, tau):
    """First-order response on fine times."""
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
    along = S if seed % 2 else np.eye(3)  # what acts follows the sensor's axes, or a part's beside it

    def value(s, name):
        return s.channels[names[name]][3]

    def sized(s):
        return s.body @ along.T / 50000.0

    if kind == "offset-current":
        tau = log_uniform(rng, 2.0, 30.0) if rng.random() < 0.5 else 0.0
        slow = log_uniform(rng, 15.0, 60.0) if rng.random() < 0.3 else 0.0

        def effect(s):
            i = value(s, "load")
            fast = follow(s, names["load"], tau) if tau else i
            return (fast + 0.5 * follow(s, names["load"], slow) if slow else fast)[:, None] * c

        return effect
    if kind == "offset-current-squared":
        return lambda s: (value(s, "levels") ** 2)[:, None] * c
    if kind == "offset-temperature":
        tau = log_uniform(rng, 30.0, 400.0) if rng.random() < 0.5 else 0.0
        curve = log_uniform(rng, 0.003, 0.03) if rng.random() < 1 / 3 else 0.0

        def effect(s):
            T = follow(s, names["temperature"], tau) if tau else value(s, "temperature")
            T = T - 22
            return (T + curve * T**2)[:, None] * c

        return effect
    if kind == "offset-channel":
        return lambda s: (value(s, "voltage") - 8)[:, None] * c
    if kind == "gain-temperature":
        return lambda s: (value(s, "temperature") - 22)[:, None] * sized(s) * c
    if kind == "offset-drift":
        how, tau = rng.integers(3), log_uniform(rng, 0.1, 1.0)
        shapes = (lambda u: u, lambda u: np.sqrt(u + 0.01), lambda u: 1 - np.exp(-u / tau))
        return lambda s: shapes[how](s.t / span)[:, None] * c
    if kind == "offset-step":
        at = rng.uniform(0.25, 0.75) * span
        return lambda s: (s.t > at).astype(float)[:, None] * c
    if kind == "offset-mode":
        return lambda s: (s.mode != "nominal").astype(float)[:, None] * c
    if kind == "nonlinearity":
        steep = log_uniform(rng, 0.7, 2.8)
        shapes = (lambda x: x**3, lambda x: np.tanh(steep * x) - steep * x, lambda x: x**2, lambda x: np.abs(x) * x)
        how = shapes[rng.integers(4)]
        return lambda s: how(sized(s)) * c
    if kind == "cross-field":
        other, part = rng.permutation([1, 2]), rng.uniform(0.2, 1.0)
        if rng.random() < 0.5:
            return lambda s: sized(s) * np.roll(sized(s), other[0], axis=1) * c
        return lambda s: (
            np.roll(sized(s), 1, axis=1) * np.roll(sized(s), 2, axis=1) * c
            + part * np.roll(sized(s), other[0], axis=1) ** 2 * c[::-1]
        )
    if kind == "hysteresis":
        if rng.random() < 0.5:
            r = rng.uniform(600, 5000)
            return lambda s: (
                (per_segment(s, s.body @ along.T, lambda x: play(x, r)) - s.body @ along.T) * (np.abs(c) + 0.3)
            )
        return lambda s: per_segment(s, s.body @ along.T, lambda x: relays(x, rng, seed)) * (np.abs(c) + 0.3)
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
        centres, width = draw.uniform(0, span, int(span / 40)), draw.uniform(1.5, 4.0)
        return lambda s: np.sum(np.exp(-0.5 * ((s.t[:, None] - centres) / width) ** 2), axis=1)[:, None] * c
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

    def into(s, cage):
        return np.einsum("nij,nj->ni", s.to_body, cage)

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
        if rng.random() < 0.5:
            return lambda s: into(s, s.cage @ g)
        return lambda s: into(s, np.linalg.norm(s.cage, axis=1)[:, None] * (np.einsum("nji,j->ni", s.to_body, d) @ g))
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
