"""A device off the centre of finite coils: its place is read off a few rows, and the name is the gradient's."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import close_loop
from labcal.loop.candidates.few_rows import few_rows
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.model.effects import family

AT = {"place_lon_deg": 75.0, "place_lat_deg": 35.0, "place_up_deg": 10.0}
OF_THE_PAIRS = {"x4_x": 0.004, "y4_y": -0.006, "z4_z": 0.005, "x2_x": 0.001, "z1_xy": 0.002, "y1_xx": -0.0015}


@pytest.fixture
def off_centre(making: ModuleType, tmp_path: Path) -> Path:
    """A run whose device stands at that place in coils of these harmonics, in five fields."""
    rows, segments = making.recorded(seconds=45.0)
    turned = np.random.default_rng(8).normal(size=(len(segments), 3))
    for number, segment in enumerate(segments):  # each field points elsewhere
        here = np.asarray(rows["segment"]) == segment["id"]
        ref = 40000.0 * turned[number] / np.linalg.norm(turned[number]) + np.zeros((here.sum(), 3))
        axis = np.array(segment["axis_body"])
        along, angle = (ref @ axis)[:, None] * axis, rows["angle"][here][:, None]
        rows["ref"][here] = ref
        rows["dut"][here] = along + np.cos(angle) * (ref - along) - np.sin(angle) * np.cross(axis, ref)
    rows["dut"] = rows["dut"] + np.random.default_rng(9).normal(0, making.NOISE_nT, rows["dut"].shape)
    problem, *_ = prepare(session.load_run(str(making.written(tmp_path / "plain", rows, segments))))
    term = family("field-gradient").candidates(problem.run)[-1].with_values(**AT)
    beta = [OF_THE_PAIRS.get(name, 0.0) for name, _ in term.parameters]
    rows["dut"] = 1.05 * (rows["dut"] + term.columns(problem.scene) @ beta) + 800
    return Path(making.written(tmp_path / "run", rows, segments))


def test_the_place_is_found_and_the_gradient_named_down_to_the_noise(off_centre: Path) -> None:
    run = session.load_run(str(off_centre))
    pool = CandidateSet.of(prepare(run)[0], 1 / 1.15)
    smaller, larger = few_rows(pool, ())
    found = {shape.name: shape.value for shape in smaller.term.shape}
    assert all(abs(found[name] - value) < 5.0 for name, value in AT.items())
    assert smaller.term.shape == larger.term.shape
    before, left = (float(np.sqrt(np.mean(pool.residual(some) ** 2))) for some in ([], [smaller]))
    assert before > 2 * left
    assert left < 1.05
    closed = close_loop(run)
    assert [e.effect for e in closed.accepted] == ["field-gradient"]
    assert closed.verdict == "explained"


def test_where_nothing_is_left_no_place_is_looked_for(searching: Callable[..., CandidateSet]) -> None:
    assert few_rows(searching({}, {}), ()) == []
