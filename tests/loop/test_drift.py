"""An offset that wanders smoothly is a drift up to three cycles, where a line begins; a random walk is none."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import ClosedLoop, close_loop
from labcal.model.effects import family
from labcal.model.effects.scene import Scene

SIZE_nT = 150.0


def closed(making: ModuleType, folder: Path, added: np.ndarray) -> ClosedLoop:
    rows, segments = making.recorded()
    rows["dut"] = rows["dut"] + added
    return close_loop(session.load_run(str(making.written(folder, rows, segments))))


def smooth(t_s: np.ndarray, cycles: float, seed: int) -> np.ndarray:
    """On each axis a sum of many waves, of at most so many `cycles` in the run, of the stated rms (n, 3)."""
    draw = np.random.default_rng(seed)
    waves, phases = draw.uniform(0, cycles, (40, 1, 3)), draw.uniform(0, 2 * np.pi, (40, 1, 3))
    through = ((t_s - t_s[0]) / (t_s[-1] - t_s[0]))[None, :, None]
    found = np.sum(draw.normal(size=(40, 1, 3)) * np.cos(2 * np.pi * waves * through + phases), axis=0)
    return np.asarray(SIZE_nT * found / found.std())


@pytest.mark.parametrize(
    "seed", [pytest.param(1, marks=pytest.mark.slow), *(pytest.param(n, marks=pytest.mark.slow) for n in (2, 3))]
)
def test_a_slow_wave_with_bends_is_a_drift_whole(making: ModuleType, tmp_path: Path, seed: int) -> None:
    rows, _ = making.recorded()
    found = closed(making, tmp_path, smooth(rows["t_s"], 2.5, seed))
    assert [(e.effect, e.provisional) for e in found.accepted] == [("offset-drift", False)]
    assert found.after.holdout_rms_nT < 1.25 * found.noise_floor_nT  # of 36 parameters


@pytest.mark.parametrize("seed", [pytest.param(1, marks=pytest.mark.slow), pytest.param(2, marks=pytest.mark.slow), 3])
def test_a_random_walk_has_no_name(making: ModuleType, tmp_path: Path, seed: int) -> None:
    rows, _ = making.recorded()
    walk = np.cumsum(np.random.default_rng(seed).normal(size=(len(rows["t_s"]), 3)), axis=0)
    found = closed(making, tmp_path, SIZE_nT * (walk - walk.mean(axis=0)) / walk.std())
    assert ([e.effect for e in found.accepted], found.verdict) == ([], "unexplained")


def test_its_largest_form_follows_any_wave_of_three_cycles_in_the_run(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    largest = max(family("offset-drift").candidates(run), key=lambda term: len(term.parameters))
    t = run.t_s
    columns = largest.columns(Scene(t, run.segment_index, np.zeros((len(t), 3))))[:, 0]
    with_a_constant = np.column_stack([columns[:, columns.any(axis=0)], np.ones(len(t))])
    for phase in (0.0, 1.0):
        wave = np.cos(3 * 2 * np.pi * (t - t[0]) / (t[-1] - t[0]) + phase)
        left = wave - with_a_constant @ np.linalg.lstsq(with_a_constant, wave, rcond=None)[0]
        assert left.var() < 0.04 * wave.var()
