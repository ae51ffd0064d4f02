"""Panel currents, each with its own vector, none of which carries half: found as one set, told one by one."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.loop import ClosedLoop, close_loop

Rows = dict[str, np.ndarray]


def panels(t: np.ndarray, draw: np.random.Generator, count: int, idle: int = 0) -> tuple[Rows, np.ndarray, Rows]:
    """Currents of solar panels as housekeeping tells them, their effect (n, 3) [nT], and the vector of each [nT/A].

    A panel is lit by turns and shaded now and then; its telemetry is noisy, in steps, and slower than the sensor. The
    last `idle` ones do nothing.
    """
    true, told, vectors = dict[str, np.ndarray](), dict[str, np.ndarray](), dict[str, np.ndarray]()
    for number in range(count + idle):
        turn, phase = draw.uniform(60, 140), 2 * np.pi * (number / (count + idle) + draw.uniform(-0.1, 0.1))
        lit = np.maximum(np.cos(2 * np.pi * t / turn + phase), 0.0) * draw.uniform(0.6, 1.4)
        shade, on = draw.uniform(23, 71), draw.uniform(0.5, 0.85)
        name = f"i_panel{number + 1}"
        true[name] = lit * (np.mod(t / shade + draw.uniform(), 1.0) < on)
        at = np.arange(t[0], t[-1] + 2, draw.uniform(0.6, 1.1))
        seen = np.interp(at, t, true[name]) + draw.normal(0, 0.004, len(at))
        step = draw.uniform(0.004, 0.012)
        told[name] = np.round(np.interp(t, at, seen) / step) * step
        vector = draw.normal(size=3)
        vectors[name] = vector / np.linalg.norm(vector) * draw.uniform(150, 280) * (number < count)
    return told, sum(true[name][:, None] * vectors[name] for name in true) + 0.0, vectors


def _closed(making: ModuleType, folder: Path, told: Rows, effect: Any) -> ClosedLoop:
    rows, segments = making.recorded()
    rows["dut"] = rows["dut"] + 1.05 * effect
    channels = {name: {"unit": "A", "quantity": "current"} for name in told}
    folder = making.written(folder, rows | told, segments, channels)
    return close_loop(session.load_run(str(folder)))


@pytest.mark.parametrize(("seed", "count", "idle"), [(11, 4, 1), pytest.param(12, 6, 2, marks=pytest.mark.slow)])
def test_a_set_of_panels_is_found_whole_and_nothing_else(
    making: ModuleType, tmp_path: Path, seed: int, count: int, idle: int
) -> None:
    told, effect, vectors = panels(making.recorded()[0]["t_s"], np.random.default_rng(seed), count, idle)
    closed = _closed(making, tmp_path, told, effect)
    named = {e.channels[0]: e for e in closed.accepted}
    assert {e.effect for e in closed.accepted} == {"offset-current"}
    assert set(named) == {f"i_panel{k + 1}" for k in range(count)}
    assert closed.after.holdout_rms_nT < 0.35 * closed.before.holdout_rms_nT
    assert len({e.group for e in closed.accepted}) == 1
    for name, record in named.items():
        found = np.array([p.value for p in record.parameters[:3]])
        assert np.linalg.norm(found - vectors[name]) < 0.2 * np.linalg.norm(vectors[name])
        assert record.group
        assert all(p.u > 0 for p in record.parameters[:3])
        assert record.improvement_ci95_nT is not None
        assert record.improvement_ci95_nT[0] > 0


@pytest.mark.slow
def test_one_load_among_idle_ones_is_no_set(making: ModuleType, tmp_path: Path) -> None:
    told, effect, _ = panels(making.recorded()[0]["t_s"], np.random.default_rng(21), 1, 5)
    closed = _closed(making, tmp_path, told, effect)
    assert [(e.effect, e.channels, e.group) for e in closed.accepted] == [("offset-current", ("i_panel1",), "")]


def test_of_three_currents_that_add_up_any_two_are_the_set(making: ModuleType, tmp_path: Path) -> None:
    told, effect, _ = panels(making.recorded()[0]["t_s"], np.random.default_rng(31), 2)
    one, other = told.values()
    told["i_bus"] = one + other
    closed = _closed(making, tmp_path, told, effect)
    assert len(closed.accepted) == 2
    assert closed.verdict != "ambiguous"
    assert {e.group for e in closed.accepted} == {f"any 2 of {', '.join(_bound(closed, told))}"}


def _bound(closed: ClosedLoop, told: Rows) -> list[str]:
    named = [e.channels[0] for e in closed.accepted]
    return [*named, *(name for name in told if name not in named)]


@pytest.mark.slow
def test_idle_panels_make_no_set(making: ModuleType, tmp_path: Path) -> None:
    told, _, _ = panels(making.recorded()[0]["t_s"], np.random.default_rng(41), 0, 8)
    closed = _closed(making, tmp_path, told, 0.0)
    assert closed.accepted == ()
    assert closed.verdict == "clean"
