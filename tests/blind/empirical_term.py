"""The empirical term where no effect file has the physics: `empirical_term.py [--shapes N] [--noises N] [--seed S]`.

Shapes: a device whose offset is a smooth function of something recorded, and a fresh recording of it without noise;
told is the share of the error's square that the term takes off the fresh rows inside its domain. Noises: nothing smooth
is at work, but the noise is coloured, stepped, rounded or heavy-tailed; told is how often a term is built.
"""

from __future__ import annotations

import argparse
import json
import time
from dataclasses import replace

import numpy as np

from labcal.fit import draft_calibration
from labcal.loop import close_loop
from labcal.record import Channel, Dut, Reference, Run, Segment
from labcal.testing.made_up_runs import body_field

STEP_S, ROWS, NOISE_nT = 0.5, 130, 25.0
K, k = np.array([[1.05, 0.03, -0.02], [-0.02, 0.95, 0.04], [0.02, -0.05, 1.01]]), np.array([1500.0, -2500.0, 900.0])
FIELDS = ((15e3, -10e3, 12e3), (28e3, 20e3, 24e3))
QUANTITIES = {"temp": ("degC", "temperature"), "v_bus": ("V", "voltage"), "p_tank": ("hPa", "pressure")}


def lab(draw):
    """Times, segments, the field in the body (n, 3), the rate (n,) and channels (n,) that wander between −1 and 1."""
    body, cage, index, angles, rates = [], [], [], [], []
    for number, (axis, field) in enumerate((a, f) for f in FIELDS for a in np.eye(3)):
        rate = 22 + 18 * np.sin(2 * np.pi * np.arange(ROWS) / ROWS * draw.uniform(0.8, 2.2) + draw.uniform(0, 6))
        angle = np.radians(np.cumsum(rate * STEP_S))
        body.append(body_field(axis, angle, 0.0, np.array(field)))
        cage.append(np.tile(field, (ROWS, 1)))
        angles.append(np.degrees(angle) % 360)
        index += [number] * ROWS
        rates.append(rate)
    n = 6 * ROWS
    t = np.arange(n) * STEP_S
    channels = {name: wander(draw, t) for name in QUANTITIES}
    body, cage, angles, rates = map(np.concatenate, (body, cage, angles, rates))
    return t, np.array(index), body, cage, angles, rates, channels


def wander(draw, t):
    """Two slow waves, and a little noise."""
    periods = draw.uniform(30, 160, 2)
    waves = [np.sin(2 * np.pi * t / p + draw.uniform(0, 6)) for p in periods]
    return 0.65 * waves[0] + 0.35 * waves[1] + draw.normal(0, 0.005, len(t))


def recorded(scene, reading, noise_nT=NOISE_nT):
    """The run of these readings."""
    t, index, _, cage, angles, _, channels = scene
    axes = [tuple(axis) for _ in FIELDS for axis in np.eye(3)]
    segments = tuple(
        Segment(f"s{i}", "rotation", axis_body=axis, axis_cage=(0.0, 0.0, 1.0)) for i, axis in enumerate(axes)
    )
    made = tuple(
        Channel(name, *QUANTITIES[name], {"temp": 20 + 9 * x, "v_bus": 12 + x, "p_tank": 1000 + 40 * x}[name])
        for name, x in channels.items()
    )
    return Run(
        run_id="nameless", started_utc="2026-01-01T00:00:00Z", simulated=True, operator="",
        dut=Dut(serial="S", noise_nT=noise_nT), reference=Reference(kind="vector"), segments=segments, t_s=t,
        segment_index=index.astype(np.intp), reading=reading, reference_vector=cage, angle_deg=angles, channels=made,
    )  # fmt: skip


def lorentz(x, at, width):
    """A resonance."""
    return 1 / (1 + ((x - at) / width) ** 2)


SHAPES = {  # of scaled channels c, the field's direction u, the field b, the rate w: a function that is smooth in them
    "saturating in temperature": lambda c, u, b, w, d: np.tanh(
        (c["temp"] - d.uniform(-0.3, 0.3)) / d.uniform(0.1, 0.2)
    ),
    "resonant in a voltage": lambda c, u, b, w, d: lorentz(c["v_bus"], d.uniform(-0.4, 0.4), d.uniform(0.15, 0.3)),
    "resonant in the rate": lambda c, u, b, w, d: lorentz(w, d.uniform(15, 30), d.uniform(3, 6)),
    "cubic in a voltage": lambda c, u, b, w, d: (c["v_bus"] - d.uniform(-0.1, 0.1)) ** 3 * 2 - 0.9 * c["v_bus"],
    "wavy in a pressure": lambda c, u, b, w, d: np.sin(d.uniform(3.5, 6) * c["p_tank"] + d.uniform(0, 6)),
    "two channels' product": lambda c, u, b, w, d: c["temp"] * c["v_bus"],
    "a hill over two channels": lambda c, u, b, w, d: np.exp(-((c["temp"] - 0.2) ** 2 + c["p_tank"] ** 2) / 0.2),
    "a power of a channel": lambda c, u, b, w, d: np.abs(c["p_tank"] - d.uniform(-0.3, 0.3)) ** d.uniform(1.7, 2.8),
    "a lobe in the attitude": lambda c, u, b, w, d: np.exp(-((u[:, 0] - d.uniform(-0.3, 0.3)) ** 2) / 0.06),
    "temperature times field": lambda c, u, b, w, d: np.tanh(c["temp"] / 0.25) * b[:, 2] / 3e4,
}


def shape_trial(name, seed):
    """One device: the verdict, the term, and what is left of fresh rows inside and outside its domain."""
    scenes = [lab(np.random.default_rng([seed, i])) for i in (0, 1)]
    along = np.random.default_rng([seed, 2]).normal(size=3)
    size = np.random.default_rng([seed, 3]).uniform(3.0, 12.0) * NOISE_nT
    effects = []
    for scene in scenes:
        _, _, body, _, _, rates, channels = scene
        unit = body / np.linalg.norm(body, axis=1)[:, None]
        effects.append(SHAPES[name](channels, unit, body, rates, np.random.default_rng([seed, 4])))
    size /= np.std(effects[0])
    readings = [
        (scene[2] + size * e[:, None] * along / np.linalg.norm(along) + k) @ np.linalg.inv(K).T
        for scene, e in zip(scenes, effects, strict=True)
    ]
    run = recorded(scenes[0], readings[0] + np.random.default_rng([seed, 5]).normal(0, NOISE_nT, readings[0].shape))
    start = time.process_time()
    closed = close_loop(run, empirical=True)
    plain = replace(closed, accepted=tuple(e for e in closed.accepted if e.basis is None))
    told = {"shape": name, "seed": seed, "verdict": closed.verdict, "named": [e.effect for e in plain.accepted],
            "seconds": time.process_time() - start}  # fmt: skip
    term = next((e for e in closed.accepted if e.basis is not None), None)
    if term is None:
        return told
    applied = draft_calibration(run, closed.fit(), "0" * 64).apply(recorded(scenes[1], readings[1]))
    without = draft_calibration(run, close_without(run).fit(), "0" * 64).apply(recorded(scenes[1], readings[1]))
    inside = np.array(["domain" not in flag for flag in applied.flags])
    left, before = (np.sum((one.field_nT - scenes[1][2]) ** 2, axis=1) for one in (applied, without))
    z = (applied.field_nT - scenes[1][2])[~inside] / applied.u_nT[~inside, None] if (~inside).any() else np.zeros(1)
    return told | {
        "inputs": term.inputs, "gone": float(1 - left[inside].mean() / before[inside].mean()),
        "outside": float((~inside).mean()), "z_outside": float(np.sqrt(np.mean(z**2))),
        "error_nT": float(np.sqrt(left[inside].mean() / 3)), "u_nT": float(applied.u_nT[inside].mean()),
    }  # fmt: skip


def close_without(run):
    """The result without the term."""
    return close_loop(run)


def noise(kind, draw, n):
    """Noise (n, 3) [standard deviations of the white one]."""
    white = draw.normal(0, 1, (n, 3))
    if kind == "random walk":
        return white + np.cumsum(draw.normal(0, draw.uniform(0.1, 0.5), (n, 3)), axis=0)
    if kind == "telegraph":
        level = np.cumsum(draw.random(n) < draw.uniform(0.005, 0.05)) % 2
        return white + level[:, None] * draw.normal(0, 4, 3)
    if kind == "exponential":
        keep, out = np.exp(-1 / draw.uniform(5, 80)), np.zeros((n, 3))
        for i in range(1, n):
            out[i] = keep * out[i - 1] + draw.normal(0, 2 * np.sqrt(1 - keep**2), 3)
        return white + out
    if kind == "flicker":
        spectrum = (
            np.fft.rfft(draw.normal(0, 1, (n, 3)), axis=0) / np.sqrt(np.maximum(np.arange(n // 2 + 1), 1))[:, None]
        )
        flicker = np.fft.irfft(spectrum, n, axis=0)
        return white + 2 * flicker / flicker.std()
    if kind == "heavy tails":
        return draw.standard_t(4, (n, 3)) / np.sqrt(2)
    if kind == "rounded":
        return np.round(white / 2) * 2
    return white


NOISES = ("white", "random walk", "telegraph", "exponential", "flicker", "heavy tails", "rounded")


def noise_trial(kind, seed):
    """Whether a term is built where there is nothing to build."""
    draw = np.random.default_rng([seed, 9])
    scene = lab(draw)
    reading = (scene[2] + k) @ np.linalg.inv(K).T + NOISE_nT * noise(kind, draw, len(scene[0]))
    start = time.process_time()
    closed = close_loop(recorded(scene, reading, None if kind == "rounded" else NOISE_nT))
    return {"noise": kind, "seed": seed, "verdict": closed.verdict, "named": [e.effect for e in closed.accepted],
            "built": [e.inputs for e in closed.proposed], "seconds": time.process_time() - start}  # fmt: skip


def main():
    """Print one JSON line a run, then the sums."""
    asked = argparse.ArgumentParser()
    asked.add_argument("--shapes", type=int, default=30)
    asked.add_argument("--noises", type=int, default=105)
    asked.add_argument("--seed", type=int, default=2026)
    told = asked.parse_args()
    names, found = list(SHAPES), []
    for i in range(told.shapes):
        found.append(shape_trial(names[i % len(names)], told.seed + i))
        print(json.dumps(found[-1]), flush=True)
    for i in range(told.noises):
        found.append(noise_trial(NOISES[i % len(NOISES)], told.seed + i))
        print(json.dumps(found[-1]), flush=True)
    gone = [one["gone"] for one in found if "gone" in one]
    print(f"{sum(g >= 0.7 for g in gone)} of {told.shapes} runs lost 70 % and more; {len(gone)} terms were built")
    print(f"built on noise: {sum(bool(one.get('built')) for one in found)} of {told.noises}")


if __name__ == "__main__":
    main()
