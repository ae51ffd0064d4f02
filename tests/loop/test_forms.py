"""Shapes that a cause takes on a bench, each made from its physics: named, and fitted down to the noise."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.geometry import rotate, rotation_vector
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.selection.stepwise import stepwise_forward

Rows = dict[str, np.ndarray]
Segments = list[dict[str, Any]]


def _each_mounted_askew(rows: Rows, segments: Segments) -> None:
    """Every time the device is mounted its axis is another tenth of a degree off the platform's."""
    draw = np.random.default_rng(8)
    for segment in segments:
        here = rows["segment"] == segment["id"]
        off = np.cross(segment["axis_body"], draw.normal(size=3))
        turned = rotation_vector(np.radians(0.15) * off)
        rows["dut"][here] = 800 + (rows["dut"][here] - 800) @ turned.T


def _wobbling(rows: Rows, segments: Segments) -> None:
    """The platform's axis nods by 0.2° once in a turn, in fields of two directions."""
    draw = np.random.default_rng(8)
    for number, segment in enumerate(segments):
        here = rows["segment"] == segment["id"]
        ref, angle = rows["ref"][here] * [1, 1 if number % 2 else -1, 1], rows["angle"][here]
        nod = np.radians(0.2) * np.cos(angle)[:, None] * [0.6, -0.7, 0.4]
        seen = rotate(np.array(segment["axis_body"]), -angle, ref - np.cross(nod, ref))
        rows["ref"][here], rows["dut"][here] = ref, 1.05 * seen + 800 + draw.normal(0, 20, seen.shape)


def _slipped_between_two_segments(rows: Rows, segments: Segments) -> None:
    """The device sits in its third mounting otherwise after the coils were set anew, all else being as it was."""
    for segment in segments:
        segment["mounting"] = segment["id"][0]
    here = rows["segment"] == segments[-1]["id"]
    turned = rotation_vector(np.radians([0.1, -0.15, 0.08]))
    rows["dut"][here] = 800 + (rows["dut"][here] - 800) @ turned.T


def _standing_askew_among_coils(rows: Rows, segments: Segments) -> None:
    """At rest in six attitudes, each missed by a tenth of a degree, in fields of many directions."""
    draw = np.random.default_rng(8)
    rows["angle"] = np.full(len(rows["t_s"]), np.nan)
    for segment in segments:
        here = rows["segment"] == segment["id"]
        attitude = rotation_vector(np.pi / 2 * draw.integers(0, 4, 3))
        segment["kind"], segment["body_from_cage"] = "static", attitude.tolist()
        segment["axis_body"] = (attitude @ segment["axis_cage"]).tolist()
        ref = np.repeat(draw.normal(0, 25000.0, (here.sum() // 5, 3)), 5, axis=0)
        seen = ref @ attitude.T @ rotation_vector(np.radians(0.1) * draw.normal(size=3)).T
        rows["ref"][here], rows["dut"][here] = ref, 1.05 * seen + 800 + draw.normal(0, 20, seen.shape)


def _beside_a_reference(rows: Rows, segments: Segments) -> None:
    """A reference at an unstated place reads the field of a moment that turns with the device."""
    towards = np.array([0.6, -0.64, 0.48])
    for segment in segments:
        here = rows["segment"] == segment["id"]
        moment = rotate(
            np.array(segment["axis_body"]),
            rows["angle"][here],
            np.array([60.0, -90.0, 40.0]) + np.zeros((here.sum(), 3)),
        )
        rows["ref"][here] += 3 * (moment @ towards)[:, None] * towards - moment


def _another_gain_for_each_sign(rows: Rows, segments: Segments) -> None:
    field = (rows["dut"] - 800) / 1.05
    rows["dut"] = rows["dut"] + 0.02 * np.abs(field) * [1.0, -0.7, 0.4]


@pytest.mark.parametrize(
    ("shape", "cause"),
    [
        (_each_mounted_askew, "axis-tilt"),
        pytest.param(_wobbling, "axis-tilt", marks=pytest.mark.slow),
        pytest.param(_slipped_between_two_segments, "axis-tilt", marks=pytest.mark.slow),
        pytest.param(_standing_askew_among_coils, "axis-tilt", marks=pytest.mark.slow),
        (_beside_a_reference, "dut-dipole-at-reference"),
        (_another_gain_for_each_sign, "nonlinearity"),
    ],
)
def test_a_shape_from_the_bench_is_named_and_fitted_to_the_noise(
    making: ModuleType, tmp_path: Path, shape: Callable[[Rows, Segments], None], cause: str
) -> None:
    rows, segments = making.recorded()
    shape(rows, segments)
    pool = CandidateSet.of(prepare(session.load_run(str(making.written(tmp_path, rows, segments))))[0], 0.85)
    assert np.sqrt(np.mean(pool.residual(()) ** 2)) > 1.3
    accepted, _ = stepwise_forward(pool)
    assert [c.family.id for c in accepted] == [cause]
    assert np.sqrt(np.mean(pool.residual(accepted) ** 2)) < 1.05
