"""A lab in plain numpy that shares no code with labcal: what a run would be whose reference and mounting are wrong.

A device on a platform is turned about each of its axes in fields of a cage. What is declared of the reference and of
the mounting is drawn once a run: a scale, a zero for each axis, a turn of the reference, a turn of the axes.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

Channels = dict[str, np.ndarray]

NOISE_nT, REFERENCE_NOISE_nT, PERIOD_S = 20.0, 3.0, 0.5
LOAD_A, MEAN_C, SWING_C = 0.4, 24.0, 3.0
EFFECTS = ("none", "offset-current", "offset-temperature", "gain-temperature")
OFFSET_nT_PER_A, OFFSET_nT_PER_C = np.array([300.0, -150.0, 90.0]), np.array([40.0, -30.0, 25.0])
GAIN_PER_C = np.array([8e-4, -5e-4, 6e-4])


@dataclass(frozen=True)
class Declared:
    """Standard uncertainties of one run's reference and mounting; what is None is neither wrong nor declared."""

    scale_ppm: float | None = None
    zero_nT: float | None = None
    align_deg: float | None = None
    body_deg: float | None = None
    kind: str = "vector"


@dataclass(frozen=True)
class Recorded:
    """What the lab has of a run, and what nobody told it."""

    segments: list[dict]
    t_s: np.ndarray
    segment: np.ndarray
    reading: np.ndarray
    reference: np.ndarray
    angle_deg: np.ndarray
    current_A: np.ndarray
    warm_C: np.ndarray
    K: np.ndarray
    k_nT: np.ndarray
    effect: str
    declared: Declared
    noise_nT: float = NOISE_nT
    more: dict = field(default_factory=dict)

    def fresh(self, seed: int, n: int = 200, noise_nT: float = NOISE_nT) -> tuple[np.ndarray, Channels, np.ndarray]:
        """Readings (n, 3) at another time, the channels beside them, and the true field in the body that they saw."""
        draw = np.random.default_rng([seed, 99])
        b = draw.normal(size=(n, 3))
        b *= draw.uniform(20_000, 50_000, (n, 1)) / np.linalg.norm(b, axis=1, keepdims=True)
        current = LOAD_A * (draw.random(n) < 0.5)
        noise = noise_nT * draw.normal(size=(n, 3))
        warm = MEAN_C + SWING_C * draw.uniform(-1, 1, n)
        return self.read(b, current, warm, noise), {"i_eps": current, "temp_dut": warm}, b

    def read(self, b: np.ndarray, current: np.ndarray, warm: np.ndarray, noise: np.ndarray) -> np.ndarray:
        """What the device reads in `b`."""
        seen, warmer = b + self.k_nT, (warm - MEAN_C)[:, None]
        if self.effect == "offset-current":
            seen = seen + current[:, None] * OFFSET_nT_PER_A
        if self.effect == "offset-temperature":
            seen = seen + warmer * OFFSET_nT_PER_C
        if self.effect == "gain-temperature":
            seen = seen + warmer * GAIN_PER_C * b
        return np.linalg.solve(self.K, seen.T).T + noise


def turn(w: np.ndarray) -> np.ndarray:
    """Exp [w]x by its series of quaternions: another formula than labcal's."""
    half = np.linalg.norm(w) / 2
    x, y, z = w / 2 * np.sinc(half / np.pi)
    c = np.cos(half)
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - c * z), 2 * (x * z + c * y)],
        [2 * (x * y + c * z), 1 - 2 * (x * x + z * z), 2 * (y * z - c * x)],
        [2 * (x * z - c * y), 2 * (y * z + c * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def record(seed: int, declared: Declared, *, effect: str = "none", rows: int = 60) -> Recorded:
    """Three mountings, each turned once in six fields; `rows` a turn."""
    draw = np.random.default_rng(seed)
    K = np.eye(3) + draw.normal(0, 0.02, (3, 3))
    device = {"K": K, "k_nT": draw.normal(0, 1500, 3), "effect": effect}
    wrong = drawn(draw, declared)
    segments, parts = [], []
    for mounting in range(3):
        phase = draw.uniform(0, 2 * np.pi)
        for number, direction in enumerate(_directions(draw)):
            size = (20_000.0, 50_000.0)[number % 2]
            name = f"{'xyz'[mounting]}-{number}"
            segments.append({"id": name, "kind": "rotation", "axis_body": tuple(np.eye(3)[mounting].tolist()),
                             "axis_cage": (0.0, 0.0, 1.0), "mounting": "xyz"[mounting]})  # fmt: skip
            parts.append(_part(mounting, phase, size * direction, rows, declared.kind, wrong))
    body, reference, angle = (np.concatenate([part[i] for part in parts]) for i in range(3))
    n = len(body)
    t = np.arange(n) * PERIOD_S + 20.0 * np.repeat(np.arange(len(parts)), rows)
    current = LOAD_A * (np.mod(t, 37.0) < 17.0)
    warm = MEAN_C + SWING_C * np.sin(2 * np.pi * t / 411.0)
    shown = reference + REFERENCE_NOISE_nT * draw.normal(size=(n, 3))
    made = Recorded(segments, t, np.repeat(np.arange(len(parts)), rows), np.zeros((n, 3)), shown, angle, current, warm,
                    **device, declared=declared)  # fmt: skip
    reading = made.read(body, current, warm, NOISE_nT * draw.normal(size=(n, 3)))
    return Recorded(**{**made.__dict__, "reading": reading})


def longer(field: np.ndarray, by_nT: float) -> np.ndarray:
    """Fields (…, 3) of a magnitude larger by so much: all that a scalar reference's zero is."""
    return field * (1 + by_nT / np.linalg.norm(field, axis=-1, keepdims=True))


def drawn(draw: np.random.Generator, d: Declared) -> dict[str, np.ndarray]:
    sizes = {"scale": ((), 1e-6 * (d.scale_ppm or 0)), "zero": ((3,), d.zero_nT or 0),
             "align": ((3,), np.radians(d.align_deg or 0)), "body": ((3,), np.radians(d.body_deg or 0))}  # fmt: skip
    return {name: size * draw.normal(size=shape) for name, (shape, size) in sizes.items()}


def _directions(draw: np.random.Generator) -> np.ndarray:
    """Three pairs of directions, none along the platform axis."""
    azimuth = draw.uniform(0, 2 * np.pi, 6)
    height = np.tile([0.75, 0.0, -0.6], 2)
    across = np.sqrt(1 - height**2)
    return np.column_stack([across * np.cos(azimuth), across * np.sin(azimuth), height])


def _part(
    mounting: int, phase: float, field_C: np.ndarray, rows: int, kind: str, wrong: dict
) -> tuple[np.ndarray, ...]:
    """True field in the body, what the reference shows without noise, and the angle of one turn."""
    angle = 2 * np.pi * np.arange(rows) / rows
    to_axis = np.roll(np.eye(3), mounting + 1, axis=0)  # carries the cage's z onto this axis of the body
    seen = np.array([turn(-(a + phase) * np.eye(3)[mounting]) @ to_axis @ field_C for a in angle])
    shown = (1 + wrong["scale"]) * (turn(wrong["align"]) @ field_C)
    shown = shown + wrong["zero"] if kind == "vector" else longer(shown, wrong["zero"][0])
    return seen @ turn(wrong["body"]).T, np.tile(shown, (rows, 1)), np.degrees(angle)
