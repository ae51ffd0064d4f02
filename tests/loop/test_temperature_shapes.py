"""What a temperature does beyond a straight line: a gain that bends, an offset unlike in heating and cooling."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.fit import draft_calibration
from labcal.loop import close_loop
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.selection.select import likeliest_own_forms
from labcal.model import apply as applying
from labcal.model.readings import readings_of

DIRECTIONS = np.array([1.0, -0.7, 0.5])
Rows = dict[str, np.ndarray]


def _warmed(rows: Rows) -> np.ndarray:
    t = rows["t_s"]
    T = 20 + 5 * np.sin(t / 46.0) + 2 * np.sin(t / 15.0)
    rows["temp"] = T + np.random.default_rng(9).normal(0, 0.03, len(t))
    return T - 20


def _branch(warm: np.ndarray, turn: float) -> np.ndarray:
    """1 where it has been heating by twice the turn, −1 where cooling."""
    stop = np.zeros(len(warm))
    for i in range(1, len(warm)):
        stop[i] = np.clip(stop[i - 1] + warm[i] - warm[i - 1], -turn, turn)
    return stop / turn


def test_a_gain_that_bends_with_temperature(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    warm, field = _warmed(rows)[:, None], (rows["dut"] - 800) / 1.05
    rows["dut"] = rows["dut"] + 1.05 * field * (2e-4 * warm + 2e-4 * warm**2) * DIRECTIONS
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert ([e.effect for e in closed.accepted], closed.verdict) == (["gain-temperature"], "explained")
    found = {p.name: p for p in closed.accepted[0].parameters}
    for axis, size in zip("xyz", DIRECTIONS, strict=True):
        assert abs(found[f"h_{axis}"].value - 2e-4 * size) < max(4 * found[f"h_{axis}"].u, 2e-5)


@pytest.mark.parametrize("slope", [pytest.param(0.0, marks=pytest.mark.slow), 9.0])
def test_an_offset_unlike_in_heating_and_cooling_has_two_branches(
    making: ModuleType, tmp_path: Path, slope: float
) -> None:
    rows, segments = making.recorded()
    warm, clean, turn = _warmed(rows), rows["dut"], 1.3
    branch = _branch(warm, turn)
    rows["dut"] = clean + (20 * warm + 65 * branch + slope * warm * branch)[:, None] * DIRECTIONS
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    closed = close_loop(run)
    assert ([(e.effect, e.channels) for e in closed.accepted], closed.verdict) == (
        [("offset-temperature", ("temp",))],
        "explained",
    )
    found = {p.name: p for p in closed.accepted[0].parameters}
    assert abs(found["r_C"].value - turn) < max(4 * found["r_C"].u, 0.2)
    at_reference = 65 + slope * (closed.accepted[0].reference_value["temp"] - 20)
    assert abs(found["b_x"].value - at_reference / 1.05) < 6
    assert ("f_x" in found) == bool(slope)
    calibration, readings = draft_calibration(run, closed.fit(), ""), readings_of(run)
    whole = applying.apply(calibration, readings)
    assert np.sqrt(np.mean((whole.field_nT - (clean - 800) / 1.05) ** 2)) < 10
    parts = list(applying.apply_in_pieces(calibration, readings, 37))
    assert np.allclose(np.concatenate([part.field_nT for part in parts]), whole.field_nT, atol=1e-6)


def test_a_form_that_came_before_the_other_effects_is_chosen_again_beside_them(
    making: ModuleType, tmp_path: Path
) -> None:
    rows, segments = making.recorded()
    warm, field = _warmed(rows), (rows["dut"] - 800) / 1.05
    offset, gain = (
        (20 * warm + 65 * _branch(warm, 1.3))[:, None] * DIRECTIONS,
        1e-3 * warm[:, None] * field * DIRECTIONS,
    )
    rows["dut"] = rows["dut"] + offset + gain
    pool = CandidateSet.of(prepare(session.load_run(str(making.written(tmp_path, rows, segments))))[0], 0.85)

    behind, at_once = (
        next(c for c in pool.candidates if c.family.id == effect and {s.name for s in c.term.shape} == shape)
        for effect, shape in (("offset-temperature", {"tau_s"}), ("gain-temperature", set[str]()))
    )
    offset_found, gain_found = likeliest_own_forms(pool, [behind, at_once])
    assert {s.name for s in offset_found.term.shape} == {"r_C"}
    assert gain_found is at_once
    assert likeliest_own_forms(pool, [behind]) == [behind]  # alone it was chosen among all
