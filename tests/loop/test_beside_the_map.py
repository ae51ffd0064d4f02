"""What the device's map takes of an effect of the rig, which no fit can give back, is in the map's uncertainty."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.geometry import rotate
from labcal.loop.candidates.library import expand_library
from labcal.loop.close import prepare
from labcal.loop.selection.joint_fit import JointFit, joint_fit
from labcal.loop.uncertainty import of_the_file, uncertainty_of
from labcal.model.effects import iron

ANSWERS, REMANENT_nT, GAIN = 5e-3, 100.0, 1.05


def beside_iron(making: ModuleType, folder: Path, draw: np.random.Generator) -> JointFit:
    """The fit of iron that answers the field by some tensor, in fields of three directions."""
    rows, segments = making.recorded(seconds=30.0)
    of_segment = np.repeat(np.arange(len(segments)), len(rows["t_s"]) // len(segments))
    rows["ref"] = draw.normal(0, 25000.0, (len(segments), 3))[of_segment]
    axis = np.array([s["axis_body"] for s in segments])[of_segment]
    answer = draw.normal(0, ANSWERS, (3, 3))
    there = rows["ref"] @ (np.eye(3) + answer).T + draw.normal(0, REMANENT_nT, 3)
    noise = draw.normal(0, making.NOISE_nT, there.shape)
    rows["dut"] = GAIN * rotate(axis, -rows["angle"], there) + 800 + noise
    problem, *_ = prepare(session.load_run(str(making.written(folder, rows, segments))))
    beside = {name for name, _ in iron.BESIDE}
    term = next(
        c.term for c in expand_library(problem) if c.label == "cage-field" and beside <= dict(c.term.parameters).keys()
    )
    return joint_fit(problem, [term])


# 99.9 % of the mean of as many squares of chi
@pytest.mark.parametrize(
    ("draws", "low", "high"), [(8, 0.089, 3.48), pytest.param(24, 0.3, 2.2, marks=pytest.mark.slow)]
)
def test_a_gain_that_iron_may_have_given_is_as_uncertain_as_the_iron_is_strong(
    making: ModuleType, tmp_path: Path, draws: int, low: float, high: float
) -> None:
    draw, squares = np.random.default_rng(6), []
    for number in range(draws):
        found = beside_iron(making, tmp_path / str(number), draw)
        uncertain = of_the_file(found, uncertainty_of(found), [False]).sources
        gain = np.isin(np.arange(12), [0, 4, 8]) / 3  # of K and k
        off = float(np.trace(found.problem.affine.K) / 3 - 1 / GAIN)
        of_noise = float(np.sqrt(gain @ uncertain.noise.covariance @ gain))
        assert of_noise < ANSWERS / 10
        squares.append(off**2 / (gain @ uncertain.covariance @ gain))
    assert low < np.mean(squares) < high
    (told,) = {one.source for one in uncertain.declared}
    assert told == "cage-field: what K and k take as well"


def test_the_fit_is_no_worse_along_what_the_map_takes(making: ModuleType, tmp_path: Path) -> None:
    found = beside_iron(making, tmp_path, np.random.default_rng(7))
    columns = np.concatenate([found.problem.T, *(-found.problem.all_columns(t) for t in found.terms)], axis=2)
    hidden = uncertainty_of(found).declared
    assert hidden
    for one in hidden:
        base = found.problem.T @ one.shift[: found.problem.T.shape[2]]
        assert np.sqrt(np.mean((columns @ one.shift[: columns.shape[2]]) ** 2)) < 0.05 * np.sqrt(np.mean(base**2))
