"""Gaps of a channel: a switched load keeps its level, what is smooth is bridged, what nothing tells is left out."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.loop.data.gaps import unresolved_gaps
from labcal.model.gaps import bridged

T = np.arange(0.0, 600.0, 0.5)


def _without(values: np.ndarray, *gaps: tuple[float, float]) -> np.ndarray:
    lost = np.any([(start <= T) & (stop > T) for start, stop in gaps], axis=0)
    return np.where(lost, np.nan, values)


def test_a_switched_load_keeps_its_level_and_where_it_switched_unseen_nothing_is_told() -> None:
    load = (np.mod(T, 40.0) < 15.0) * 0.8 + np.random.default_rng(1).normal(0, 0.005, len(T))
    filled, sure = bridged(T, _without(load, (42.0, 50.0), (90.0, 100.0), (300.0, 390.0)))
    assert np.minimum(np.abs(filled - 0.8), np.abs(filled)).max() < 0.03  # never between the two
    assert sure[(T >= 42.0) & (T < 50.0)].all()  # on before and after
    assert not sure[(T >= 90.0) & (T < 100.0)].any()  # on before, off after
    assert not sure[(T >= 300.0) & (T < 390.0)].any()  # off before and after, and on between
    assert sure.sum() == len(T) - 20 - 180


def test_what_is_smooth_is_bridged_over_gaps_short_beside_its_memory() -> None:
    warm = 20 + 3 * np.sin(2 * np.pi * T / 200.0)
    filled, sure = bridged(T, _without(warm, (100.0, 108.0), (300.0, 420.0), (590.0, 600.0)))
    short = (T >= 100.0) & (T < 108.0)
    assert np.abs(filled - warm)[short].max() < 0.05
    assert sure[short].all()
    assert not sure[(T >= 300.0) & (T < 420.0)].any()
    assert not sure[T >= 590.0].any()  # nothing comes after


def test_slow_telemetry_of_what_is_smooth_names_its_cause(
    making: ModuleType, tmp_path: Path, closed_loop: Callable[[Path], tuple[int, dict[str, Any], str]]
) -> None:
    """Four of five cells are empty: two lines in time would do as well as the current that they are."""
    rows, segments = making.recorded(seed=3)
    t = rows["t_s"]
    current = 0.3 + 0.2 * np.sin(t / 5.3) + 0.1 * np.sin(t / 17.0)
    rows["dut"] = rows["dut"] + current[:, None] * [180.0, 90.0, -240.0]
    told = np.arange(len(t)) % 5 == 0
    rows["i_load"] = np.where(told, current, np.nan)
    rows["temp"][len(t) // 5 :] = np.nan  # it was lost, and nothing after is sure
    _, result, _ = closed_loop(making.written(tmp_path, rows, segments))
    assert [(found["effect"], found["channels"]) for found in result["accepted"]] == [("offset-current", ["i_load"])]
    assert result["verdict"] == "explained"
    (silent,) = [found["says"] for found in result["findings"] if found["kind"] == "silent-channel"]
    assert "no value, nor a sure one between two others, in most rows: temp." in silent


@pytest.mark.slow
@pytest.mark.parametrize("levels", [2, 4])
def test_a_load_with_gaps_is_not_taken_for_its_square(
    making: ModuleType, tmp_path: Path, closed_loop: Callable[[Path], tuple[int, dict[str, Any], str]], levels: int
) -> None:
    """Bridged straight, a line and a parabola through two levels would differ where nothing was recorded."""
    rows, segments = making.recorded(seed=7)
    t, draw = rows["t_s"], np.random.default_rng(107)
    load = (np.mod(t, 47.0) < 19.0) * (0.8 if levels == 2 else 0.32 + 0.24 * np.mod(t // 47.0, 3))
    rows["dut"] = rows["dut"] + load[:, None] * [90.0, -63.0, 45.0]
    lost = np.zeros(len(t), dtype=bool)
    while lost.mean() < 0.25:
        start = draw.uniform(t[0], t[-1])
        lost |= (t > start) & (t < start + draw.exponential(8.0))
    rows["i_load"] = np.where(lost, np.nan, load)
    bundle = making.written(tmp_path, rows, segments)
    _, result, _ = closed_loop(bundle)
    (found,) = result["accepted"]
    named = {found["effect"], *(rival["effect"] for rival in found["rivals"])}
    assert (result["verdict"], named) == ("explained", {"offset-current"})
    assert unresolved_gaps(session.load_run(str(bundle)), {"i_load"}).mean() > 0.05
