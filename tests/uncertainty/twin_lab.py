"""The same trials on the simulated lab: its own coils, platform, reference and device, wrong as they are declared."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from wrong_lab import Channels, Declared, Recorded, drawn, longer, turn

from labcal.twin import Lab, open_twin

RATE_DEG_PER_S, NOISE_nT = 6.0, 15.0
REST_S, TURN_S = 10.0, 62.0
EARTH_nT = np.array([20_400.0, 1_150.0, -43_700.0])


@dataclass(frozen=True)
class RecordedByTwin(Recorded):
    """A run of the twin; its fresh readings are the twin's own."""

    def fresh(self, seed: int, n: int = 200, noise_nT: float = NOISE_nT) -> tuple[np.ndarray, Channels, np.ndarray]:
        """Readings at rest after the run, the channels beside them, and the true field."""
        return self.more["fresh"]


def record(seed: int, declared: Declared, *, effect: str = "none", rows: int = 24) -> RecordedByTwin:
    """Three mountings, each turned once in six fields, then fresh readings in others."""
    draw = np.random.default_rng([seed, 7])
    wrong = drawn(draw, declared)
    lab = _lab(seed, wrong if declared.kind == "vector" else {**wrong, "zero": np.zeros(3)}, effect)
    segments, parts, t = [], [], 100.0
    for mounting in range(3):
        to_axis = np.roll(np.eye(3), mounting + 1, axis=0)
        lab.mount(t, (turn(wrong["body"]) @ to_axis).tolist())
        for number in range(6):
            _drive(lab, t, (20_000.0, 50_000.0)[number % 2] * _direction(draw, number))
            lab.platform.place(t, 0.0)
            lab.platform.move(t + REST_S, 360.0, RATE_DEG_PER_S)
            segments.append({"id": f"{'xyz'[mounting]}-{number}", "kind": "rotation",
                             "axis_body": tuple(np.eye(3)[mounting].tolist()), "axis_cage": (0.0, 0.0, 1.0),
                             "mounting": "xyz"[mounting]})  # fmt: skip
            parts.append(_sampled(lab, t + REST_S + np.linspace(0.5, TURN_S - 1.0, rows)))
            t += REST_S + TURN_S
    t_s, reading, reference, angle, current, warm = (np.concatenate([p[i] for p in parts]) for i in range(6))
    reference = reference if declared.kind == "vector" else longer(reference, wrong["zero"][0])
    unused = {"K": np.eye(3), "k_nT": np.zeros(3), "effect": effect}
    return RecordedByTwin(segments, t_s, np.repeat(np.arange(len(parts)), rows), reading, reference, angle, current,
                          warm, **unused, declared=declared, noise_nT=NOISE_nT,
                          more={"fresh": _fresh(lab, draw, t)})  # fmt: skip


def _lab(seed: int, wrong: dict, effect: str) -> Lab:
    one = float(1 + wrong["scale"])
    reference = {"scale": [one] * 3, "misalignment_deg": np.degrees(wrong["align"]).tolist(), "step_units": 1e-3,
                 "bias_nT": wrong["zero"].tolist(), "noise_nT": 3.0, "nT_per_unit": 1.0}  # fmt: skip
    dut = {"scale": [1.013, 0.985, 1.022], "nonorthogonality_deg": [0.7, -0.5, 0.9], "noise_nT": NOISE_nT,
           "bias_nT": [1850.0, -2400.0, 950.0], "nT_per_unit": 1.0, "step_units": 1e-3}  # fmt: skip
    effects = {} if effect == "none" else {effect: {}}
    table = {"reference": reference, "reference_place_m": [0.0, 0.0, 0.0], "dut": dut, "effects": effects,
             "ambient": {"earth_nT": EARTH_nT.tolist(), "mains_nT": 0.0}}  # fmt: skip
    return open_twin(table, seed)


def _direction(draw: np.random.Generator, number: int) -> np.ndarray:
    height, azimuth = (0.75, 0.0, -0.6)[number % 3], draw.uniform(0, 2 * np.pi)
    across = np.sqrt(1 - height**2)
    return np.array([across * np.cos(azimuth), across * np.sin(azimuth), height])


def _drive(lab: Lab, t: float, field_nT: np.ndarray) -> None:
    currents = np.linalg.solve(lab.coil_field.matrix_nT_per_A, field_nT - EARTH_nT)
    for axis, amps in zip("xyz", currents, strict=True):
        lab.coils[axis].drive(t, float(amps), 60.0, True)


def _sampled(lab: Lab, t_s: np.ndarray) -> tuple[np.ndarray, ...]:
    reference = lab.reference_nT(t_s)
    reading, told = lab.dut_reading(t_s)
    return t_s, reading, reference, lab.platform.at(t_s), told["i_eps"], told["temp_dut"]


def _fresh(lab: Lab, draw: np.random.Generator, t: float) -> tuple[np.ndarray, Channels, np.ndarray]:
    """Twelve fields of other directions and sizes, some seconds in each."""
    parts = []
    for _ in range(12):
        direction = draw.normal(size=3)
        _drive(lab, t, draw.uniform(20_000, 50_000) * direction / np.linalg.norm(direction))
        t_s = t + np.linspace(2.0, 40.0, 16)
        true = lab.moment(t_s)
        reading, told = lab.dut_reading(t_s)
        parts.append((reading, told["i_eps"], told["temp_dut"], true.into_body(true.field_cage)))
        t += 41.0
    reading, current, warm, field = (np.concatenate([p[i] for p in parts]) for i in range(4))
    return reading, {"i_eps": current, "temp_dut": warm}, field
