"""Rows that say nothing of the sensor: a rail is where readings pile up beyond chance, not where a turn comes back."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop.data.outliers import at_saturation_limit
from labcal.record import Run


@pytest.fixture
def plain(making: ModuleType, tmp_path: Path) -> Run:
    return session.load_run(str(making.written(tmp_path, *making.recorded())))


def test_readings_clipped_at_the_device_s_range_lie_at_its_rail(plain: Run) -> None:
    cut = np.clip(plain.reading, -38e3, 38e3)
    clipped = (cut != plain.reading).any(axis=1)
    assert clipped.sum() > 20
    assert np.array_equal(at_saturation_limit(replace(plain, reading=cut)), clipped)


def test_a_coarse_reading_that_dwells_where_the_turn_comes_back_is_at_no_rail(plain: Run) -> None:
    draw = np.random.default_rng(0)
    turn = np.linspace(0.0, 6 * np.pi, len(plain))[:, None] + np.array([0.0, 1.0, 2.0])
    dwelling = 50e3 * np.cos(np.where(np.sin(turn) < 0.3, turn, np.round(turn, 1)))
    false = 0
    for _ in range(200):
        read = 13.0 * np.round((dwelling + draw.normal(0, 15.0, dwelling.shape)) / 13.0)
        false += bool(at_saturation_limit(replace(plain, reading=read)).any())
    assert false == 0
