"""Rows that say nothing of the sensor: a rail is where readings pile up beyond chance, not where a turn comes back."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.loop import close_loop
from labcal.loop.close import prepare
from labcal.loop.data.outliers import hampel_outliers
from labcal.loop.data.saturation import at_saturation_limit, beyond_limit
from labcal.record import Run

Rows = dict[str, np.ndarray]


@pytest.fixture
def plain(making: ModuleType, tmp_path: Path) -> Run:
    return session.load_run(str(making.written(tmp_path, *making.recorded())))


def test_readings_clipped_at_the_device_s_range_lie_at_its_rail(plain: Run) -> None:
    cut = np.clip(plain.reading, -38e3, 38e3)
    clipped = (cut != plain.reading).any(axis=1)
    assert clipped.sum() > 20
    assert np.array_equal(at_saturation_limit(replace(plain, reading=cut)), clipped)


def test_an_end_as_far_out_as_a_limit_is_one_though_the_base_does_not_say_so() -> None:
    read = np.zeros((12, 3))
    read[:6] = np.arange(6.0)[:, None] * 100
    read[6:9, 0], read[9:, 0], read[6:9, 1] = 1000.0, -1000.0, 700.0
    stuck = np.arange(12) >= 6
    lacking = np.zeros((12, 3))  # what an effect that the base lacks does to the residual
    lacking[6:9, 0], lacking[9:, 0] = -80.0, -60.0  # beyond the upper end, short of the lower one
    everything: Any = SimpleNamespace(
        kind="vector", run=SimpleNamespace(reading=read), affine=SimpleNamespace(K=np.eye(3)), residual_nT=lacking
    )
    assert np.array_equal(beyond_limit(everything, stuck), stuck)
    read[9:, 0] = -990.0
    assert np.array_equal(np.flatnonzero(beyond_limit(everything, stuck)), [6, 7, 8])


def test_a_coarse_reading_that_dwells_where_the_turn_comes_back_is_at_no_rail(plain: Run) -> None:
    draw = np.random.default_rng(0)
    turn = np.linspace(0.0, 6 * np.pi, len(plain))[:, None] + np.array([0.0, 1.0, 2.0])
    dwelling = 50e3 * np.cos(np.where(np.sin(turn) < 0.3, turn, np.round(turn, 1)))
    false = 0
    for _ in range(200):
        read = 13.0 * np.round((dwelling + draw.normal(0, 15.0, dwelling.shape)) / 13.0)
        false += bool(at_saturation_limit(replace(plain, reading=read)).any())
    assert false == 0


def _with_bursts(rows: Rows, seed: int) -> np.ndarray:
    """Stretches of 3 to 10 wild readings in 1 to 2 % of the rows; which rows they are."""
    draw, n = np.random.default_rng(seed), len(rows["t_s"])
    wild = np.zeros(n, dtype=bool)
    while wild.mean() < 0.012:
        start = int(draw.integers(15, n - 25))
        wild[start : start + int(draw.integers(3, 11))] = True
    rows["dut"][wild] += draw.normal(0, 8000.0, (int(wild.sum()), 3))
    return wild


@pytest.mark.slow
def test_bursts_are_set_aside_and_leave_the_calibration_as_it_was(making: ModuleType, tmp_path: Path) -> None:
    """Their noise is not declared: neither the map nor its uncertainty may swell."""
    (rows, segments), (spoiled, _) = making.recorded(), making.recorded()
    wild = _with_bursts(spoiled, 3)
    clean, burst = (
        close_loop(session.load_run(str(making.written(tmp_path / name, some, segments, noise_nT=None))))
        for name, some in (("clean", rows), ("burst", spoiled))
    )
    assert abs(burst.set_aside["outliers"] - wild.sum()) <= 0.1 * wild.sum() + 1
    assert [e.effect for e in burst.accepted] == ["outliers"]
    assert burst.noise_nT < 1.15 * clean.noise_nT
    assert np.linalg.norm(burst.affine.k_nT - clean.affine.k_nT) < 5.0


def test_what_keeps_a_run_of_many_wild_rows_from_being_explained_is_told(making: ModuleType, tmp_path: Path) -> None:
    """Nothing else is left of it: no shape may be told, and none asked for."""
    rows, segments = making.recorded()
    rows["dut"][8::16] += np.random.default_rng(5).normal(0, 3000.0, (len(rows["dut"][8::16]), 3))
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert closed.verdict == "partly-explained"
    assert "more than 5 % of its rows set aside as outliers" in closed.summary
    assert "What is left" not in closed.summary
    assert closed.next_experiment is not None
    assert "link" in closed.next_experiment.do


@pytest.mark.parametrize("level", [400.0, 8000.0])
def test_a_pulse_that_holds_its_level_is_no_burst(level: float) -> None:
    draw = np.random.default_rng(2)
    residual = draw.normal(0, 1.0, (600, 3))
    for start in range(40, 560, 70):
        residual[start : start + 6] += level
    assert not hampel_outliers(residual, np.zeros(600, dtype=np.intp)).any()


def test_wild_stretches_in_many_rows_are_a_process_and_no_bursts() -> None:
    draw = np.random.default_rng(2)
    residual = draw.normal(0, 1.0, (600, 3))
    for start in range(20, 580, 30):
        residual[start : start + 5] += draw.normal(0, 300.0, (5, 3))
    aside = hampel_outliers(residual, np.zeros(600, dtype=np.intp))
    assert aside.mean() < 0.05


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("begins", [300, 301, 302, 340])
def test_the_milder_rows_in_the_middle_of_a_burst_are_set_aside_with_it(begins: int, seed: int) -> None:
    """Wild neighbours are no measure; at a segment's end a burst counts no more than elsewhere."""
    residual, segment = np.random.default_rng(seed).normal(size=(600, 3)), np.repeat(np.arange(2), 300)
    residual[begins : begins + 9] = [
        *([199, -126, -93], [43, -127, -354], [50, -82, -135], [18, -17, 17], [-20, 18, 19], [-132, -43, -102]),
        *([205, 75, -128], [64, -27, -19], [66, 137, 122]),
    ]
    assert np.flatnonzero(hampel_outliers(residual, segment)).tolist() == list(range(begins, begins + 9))


def test_a_wild_row_between_others_is_set_aside_and_a_mild_one_is_not() -> None:
    """A burst whose second row is hidden by its neighbours, its third by chance as mild as the rows beside it."""
    residual = np.random.default_rng(9).normal(size=(600, 1))
    residual[39:45, 0] = [70.0, 190.0, 1.5, 60.0, -330.0, 150.0]
    aside = hampel_outliers(residual, np.zeros(600, dtype=np.intp))
    assert np.flatnonzero(aside).tolist() == [39, 40, 42, 43, 44]


@pytest.mark.parametrize("rows", [3, 10, 12])
def test_a_burst_may_be_as_long_as_leaves_most_of_a_row_s_neighbours_good(rows: int) -> None:
    """Twelve rows: eleven of the twenty-four neighbours of each are wild."""
    residual = np.random.default_rng(7).normal(size=(600, 3))
    residual[200 : 200 + rows] = np.random.default_rng(8).choice([-1, 1], (rows, 3)) * (60.0 + np.arange(rows)[:, None])
    residual[200 : 200 + rows : 2] *= -1
    aside = hampel_outliers(residual, np.zeros(600, dtype=np.intp))
    assert np.flatnonzero(aside).tolist() == list(range(200, 200 + rows))


def test_a_level_that_holds_beside_a_burst_is_a_process() -> None:
    draw = np.random.default_rng(5)
    residual = draw.normal(size=(600, 3))
    residual[200:260] += 40.0
    residual[400:405] = draw.normal(scale=200.0, size=(5, 3))
    aside = hampel_outliers(residual, np.zeros(600, dtype=np.intp))
    assert not aside[195:265].any()
    assert aside[400:405].all()


def _coarse(run: Run, step_nT: float, limit_nT: float = np.inf) -> Run:
    """Its readings in such steps, as far as the device goes."""
    return replace(run, reading=step_nT * np.round(np.clip(run.reading, -limit_nT, limit_nT) / step_nT))


def test_coarse_readings_that_pile_up_where_a_field_turns_back_stay(plain: Run) -> None:
    assert at_saturation_limit(_coarse(plain, 2000.0)).any()
    assert prepare(_coarse(plain, 2000.0))[2] == 0


def test_coarse_readings_of_a_field_that_goes_beyond_are_set_aside(plain: Run) -> None:
    far_beyond = int((np.abs(plain.reading) > 36.2e3).any(axis=1).sum())
    assert prepare(_coarse(plain, 400.0, 36e3))[2] >= far_beyond > 100


def test_an_end_that_few_rows_reach_is_a_limit_where_another_as_far_from_zero_is_one(plain: Run) -> None:
    read = plain.reading.copy()
    read[:, 0] *= 0.93  # it just reaches what the others go far beyond
    cut = np.clip(read, -38e3, 38e3)
    clipped = (cut != read).any(axis=1)
    few = int((cut[:, 0] == 38e3).sum())
    assert 0 < few < 12
    assert np.array_equal(at_saturation_limit(replace(plain, reading=cut)), clipped)


def test_a_reading_that_no_field_made_is_set_aside_before_anything_else(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded(seconds=20.0)
    amps = (np.sin(rows["t_s"] / 3.7) > 0).astype(float)
    rows["dut"] = rows["dut"] + np.outer(amps, [900.0, -600.0, 300.0])
    rows["i_radio"] = amps
    channels = {"i_radio": {"unit": "A", "quantity": "current"}}
    run = session.load_run(str(making.written(tmp_path, rows, segments, channels)))
    wild = run.reading.copy()
    wild[17, 1] = 2147483647.0
    closed, spoilt = close_loop(run), close_loop(replace(run, reading=wild))
    assert [e.effect for e in closed.accepted] == ["offset-current"]
    assert (spoilt.verdict, [e.effect for e in spoilt.accepted]) == (closed.verdict, ["offset-current"])
    assert spoilt.set_aside["outliers"] == closed.set_aside["outliers"] + 1
    assert spoilt.after.holdout_rms_nT == pytest.approx(closed.after.holdout_rms_nT, rel=0.05)
