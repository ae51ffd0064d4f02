"""A device off the centre of coils of a finite size that are not alike, their field by Biot and Savart's law."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from scipy.special import eval_legendre

from labcal import session
from labcal.geometry import rotation, shortest_rotation
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.selection.stepwise import stepwise_forward
from labcal.model.effects.coil_pairs import ORDERS, zonal

UP = np.array([0.0, 0.0, 1.0])
EARTH_nT = np.array([19000.0, -3000.0, -42000.0])
SIZES_m = ((1.62, 1.60, 0.81), (1.30, 1.31, 0.66), (1.95, 1.94, 0.96))  # diameters of two halves, and their distance
COILS = tuple(f"coil_{a}_A" for a in "xyz")


def per_ampere_nT(axis: int, places_m: np.ndarray) -> np.ndarray:
    """The field (n, 3) of two round coils of 40 turns about an axis of the cage, at places (n, 3)."""
    first, second, apart = SIZES_m[axis]
    around = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    out = np.zeros_like(places_m)
    for diameter, height in ((first, -apart / 2), (second, apart / 2)):
        ring = np.column_stack([np.cos(around), np.sin(around), np.zeros_like(around)])
        wire = np.roll(diameter / 2 * ring + [0, 0, height], axis + 1, axis=1)
        steps = np.roll(np.cross([0, 0, 1.0], ring), axis + 1, axis=1) * (diameter / 2 * (around[1] - around[0]))
        away = places_m[:, None] - wire
        out += np.sum(np.cross(steps, away) / np.linalg.norm(away, axis=2)[:, :, None] ** 3, axis=1)
    return out * (40 * 100.0)  # mu_0 / 4 pi, in nT m / A


class OffCentre:
    """Six mountings on a platform that stands upright, its zero in each another one."""

    def __init__(self, making: ModuleType, earth_nT: np.ndarray, *, recorded: bool) -> None:
        self.making, self.earth_nT, self.recorded = making, earth_nT, recorded
        self.rows, self.segments = making.recorded(seconds=60.0)
        draw = np.random.default_rng(5)
        count = len(self.rows["t_s"])
        self.number, field = np.zeros(count, dtype=int), np.zeros((count, 3))
        for k, segment in enumerate(self.segments):
            del segment["body_from_cage"]
            segment["axis_cage"] = UP.tolist()
            here = np.flatnonzero(self.rows["segment"] == segment["id"])
            self.number[here] = k
            for some in np.array_split(here, 3):
                field[some] = 45000 * (v := draw.normal(size=3)) / np.linalg.norm(v)
        self.per_ampere = np.column_stack([per_ampere_nT(axis, np.zeros((1, 3)))[0] for axis in range(3)])
        self.amperes = np.linalg.solve(self.per_ampere, (field - earth_nT).T).T
        mounts = np.array([shortest_rotation(UP, s["axis_body"]) for s in self.segments])
        self.to_body = mounts[self.number] @ rotation(UP, -self.rows["angle"])
        self.rows["angle"] = self.rows["angle"] + draw.uniform(-3, 3, 6)[self.number]

    def problem(self, folder: Path, places_m: np.ndarray) -> LinearProblem:
        """The base fitted to what the device reads at places in the cage (n, 3), the reference being in the centre."""
        there = self.earth_nT + sum(per_ampere_nT(k, places_m) * self.amperes[:, [k]] for k in range(3))
        seen = np.einsum("nij,nj->ni", self.to_body, there)
        noise = np.random.default_rng(6).normal(0, self.making.NOISE_nT, seen.shape)
        rows = dict(self.rows, dut=1.03 * seen - 500 + noise, ref=self.amperes @ self.per_ampere.T + self.earth_nT)
        channels = dict(self.making.CHANNELS)
        if self.recorded:
            rows |= dict(zip(COILS, self.amperes.T, strict=True))
            channels |= {name: {"unit": "A", "quantity": "current", "role": "coil"} for name in COILS}
        return prepare(session.load_run(str(self.making.written(folder, rows, self.segments, channels))))[0]


@pytest.mark.parametrize(
    ("turns", "recorded"),
    [
        pytest.param(True, True, marks=pytest.mark.slow),
        (False, True),
        pytest.param(True, False, marks=pytest.mark.slow),
    ],
)
def test_a_device_off_the_centre_of_unlike_coils_is_a_gradient_down_to_the_noise(
    making: ModuleType, tmp_path: Path, turns: bool, recorded: bool
) -> None:
    lab = OffCentre(making, EARTH_nT * recorded, recorded=recorded)  # without currents in a room that is compensated
    away = np.array([0.10, -0.06, 0.05])
    in_body = np.einsum("nji,j->ni", lab.to_body, away) + [0.0, 0.0, 0.03]
    pool = CandidateSet.of(lab.problem(tmp_path, in_body if turns else np.tile(away, (len(in_body), 1))), 0.85)
    assert np.sqrt(np.mean(pool.residual(()) ** 2)) > 2
    accepted, _ = stepwise_forward(pool)
    assert [c.cause for c in accepted] == [("field-gradient", COILS if recorded else ())]
    assert np.sqrt(np.mean(pool.residual(accepted) ** 2)) < 1.1


def test_nothing_is_added_in_the_centre(making: ModuleType, tmp_path: Path) -> None:
    lab = OffCentre(making, EARTH_nT, recorded=True)
    assert stepwise_forward(CandidateSet.of(lab.problem(tmp_path, np.zeros_like(lab.amperes)), 0.85))[0] == []


@pytest.mark.parametrize("order", ORDERS)
def test_a_zonal_field_is_the_gradient_of_its_solid_harmonic(order: int) -> None:
    draw = np.random.default_rng(order)
    axis = (v := draw.normal(size=3)) / np.linalg.norm(v)
    places, step = draw.normal(size=(20, 3)), 1e-5

    def harmonic(at: np.ndarray) -> np.ndarray:
        r = np.linalg.norm(at, axis=1)
        return np.asarray(r**order * eval_legendre(order, at @ axis / r))

    slopes = [(harmonic(places + step * e) - harmonic(places - step * e)) / (2 * step) for e in np.eye(3)]
    assert np.allclose(zonal(order, places, axis), np.column_stack(slopes), rtol=1e-6, atol=1e-6)
