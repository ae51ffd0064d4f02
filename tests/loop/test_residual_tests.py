"""Whether there is anything to explain, and what it looks like: the tests and the shape of a residual."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import narrative
from labcal.loop.close import prepare
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.findings.residual_shape import describe
from labcal.loop.findings.residual_tests import residual_tests as residual_tests
from labcal.loop.noise.autocorrelation import LAGS, ljung_box

Prepared = Callable[..., LinearProblem]


@pytest.fixture
def with_offset(making: ModuleType, tmp_path: Path) -> Prepared:
    """The base fitted to a plain run with an offset (n, 3) [nT] in its readings."""

    def make(offset: np.ndarray, seconds: float = 45.0) -> LinearProblem:
        rows, segments = making.recorded(seconds=seconds)
        rows["dut"] = rows["dut"] + offset
        return prepare(session.load_run(str(making.written(tmp_path, rows, segments))))[0]

    return make


@pytest.fixture
def t(making: ModuleType) -> np.ndarray:
    return making.recorded()[0]["t_s"]


def _all(problem: LinearProblem) -> np.ndarray:
    return np.ones(len(problem), dtype=bool)


def test_ljung_box_has_its_chi_squared_mean_and_spread_on_white_noise() -> None:
    draw = np.random.default_rng(0)
    q = [ljung_box(draw.normal(size=(120, 3))) for _ in range(400)]
    free = 3 * LAGS
    assert abs(np.mean(q) - free) < 4 * np.sqrt(2 * free / 400) + 0.5  # half a unit: the mean is taken off each
    assert 0.85 < np.std(q) / np.sqrt(2 * free) < 1.15


def test_white_noise_passes_every_test(with_offset: Prepared, t: np.ndarray) -> None:
    found = residual_tests(with_offset(np.zeros((len(t), 3))), np.ones(len(t), dtype=bool))
    assert {test.test for test in found} == {"whiteness", "independence"}
    assert all(test.passes for test in found), [test.says for test in found if not test.passes]
    assert "no material structure" in narrative.tests_text(found, more_than_noise=False)
    said = narrative.tests_text(found, more_than_noise=True)  # beside "There is structure that no known effect carries"
    assert "no material structure" not in said
    assert "more than noise" in said


def test_a_residual_that_follows_a_channel_is_not_independent_of_it(
    with_offset: Prepared, making: ModuleType, t: np.ndarray
) -> None:
    load = making.recorded()[0]["i_load"]
    problem = with_offset(load[:, None] * [40.0, -20, 0])
    failed = {
        test.of for test in residual_tests(problem, _all(problem)) if not test.passes and test.test == "independence"
    }
    assert "i_load" in failed
    assert "temp" not in failed


def test_two_correlated_but_unrelated_wanders_are_mostly_called_independent(
    with_offset: Prepared, t: np.ndarray
) -> None:
    """Both the residual and time are slow: the band has to allow for that (Bartlett)."""
    failures = 0
    for seed in range(6):
        draw = np.random.default_rng(seed)
        wander = np.zeros((len(t), 3))
        for row in range(1, len(t)):
            wander[row] = 0.97 * wander[row - 1] + draw.normal(0, 10, 3)
        problem = with_offset(wander)
        failures += sum(
            not test.passes and test.of in ("i_load", "temp") for test in residual_tests(problem, _all(problem))
        )
    assert failures <= 2  # of 12


def test_what_comes_again_with_the_field_is_a_lack_of_fit_and_noise_is_none(
    with_offset: Prepared, making: ModuleType
) -> None:
    rows, _ = making.recorded(seconds=170)
    x = rows["dut"][:, 0] / 50000
    for offset, passes in ((0.0 * x, True), (400 * x**3, False)):
        problem = with_offset(np.column_stack([offset, 0 * x, 0 * x]), seconds=170)
        fit = [test for test in residual_tests(problem, _all(problem)) if test.test == "lack-of-fit"]
        assert [test.passes for test in fit] == [passes]


def test_a_line_is_described_with_its_period_and_axis(with_offset: Prepared, t: np.ndarray) -> None:
    offset = np.zeros((len(t), 3))
    offset[:, 1] = 80 * np.sin(2 * np.pi * t / 7.3)
    shape = describe(problem := with_offset(offset), _all(problem))
    assert (shape.kind, shape.axis) == ("line", "axis y")
    assert shape.period_s == pytest.approx(7.3, abs=0.05)


def test_a_step_is_described_with_its_time(with_offset: Prepared, t: np.ndarray) -> None:
    offset = np.zeros((len(t), 3))
    offset[t > 280, 0] = 120.0
    shape = describe(problem := with_offset(offset), _all(problem))
    assert (shape.kind, shape.axis) == ("step", "axis x")
    assert shape.steps_s[0] == pytest.approx(280, abs=1.0)


def test_two_levels_are_told_from_a_random_walk(with_offset: Prepared, t: np.ndarray) -> None:
    draw, said = np.random.default_rng(3), []
    for _ in range(4):
        levels, walk = np.zeros((len(t), 3)), np.zeros((len(t), 3))
        levels[:, 2] = 120 * (np.cumsum(draw.random(len(t)) < 0.04) % 2)
        walk[:, 2] = np.cumsum(draw.normal(0, 12, len(t)))
        said.append([describe(p := with_offset(offset), _all(p)) for offset in (levels, walk)])
    assert all(shape.axis == "axis z" for pair in said for shape in pair)
    assert [telegraph.kind for telegraph, _ in said] == 4 * ["telegraph"]
    assert sum(walk.kind == "telegraph" for _, walk in said) == 0


@pytest.mark.parametrize("memory", [0.0, 0.7])
def test_noise_is_no_two_levels(making: ModuleType, tmp_path: Path, memory: float) -> None:
    """Gaussian, a little less than is stated: two signs of a magnitude take as much off as is above that."""
    rows, segments = making.recorded()
    draw, clean, said = np.random.default_rng(7), (rows["dut"] - 800) / 1.05, []
    for run in range(3):
        noise = draw.normal(0, making.NOISE_nT, clean.shape)
        for i in range(1, len(clean)):
            noise[i] = memory * noise[i - 1] + np.sqrt(1 - memory**2) * noise[i]
        rows["dut"] = clean + noise
        free = [{"id": segment["id"], "kind": "free"} for segment in segments]
        bundle = making.written(tmp_path / str(run), rows, free, noise_nT=1.5 * making.NOISE_nT)
        problem = prepare(session.load_run(str(bundle)))[0]
        said.append(describe(problem, _all(problem)).kind)
    assert "telegraph" not in said


def test_structure_in_the_large_field_alone_is_placed_there(with_offset: Prepared, t: np.ndarray) -> None:
    offset = np.zeros((len(t), 3))
    large = t >= 3 * 85
    offset[large, 0] = np.random.default_rng(1).normal(0, 90, large.sum())
    shape = describe(problem := with_offset(offset), _all(problem))
    assert shape.field_nT is not None
    assert shape.field_nT[1] > 45000
    assert shape.angle_deg is None
