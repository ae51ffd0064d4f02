"""Lines in time: fixed to the device, or to the cage while the device turns in it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.errors import InputError
from labcal.geometry import rotate
from labcal.loop import close_loop
from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.folded_lines import unfolded_line
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.data.decimate import rows_per_bin
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.noise.periodogram import periodogram
from labcal.loop.selection.crossval import HeldOutErrors
from labcal.loop.selection.discrepancy import is_narrow_line
from labcal.loop.selection.heldout_rules import first_unsupported
from labcal.model.effects.registry import load_shipped
from labcal.model.effects.regressors import stretches

Rows = dict[str, np.ndarray]
LINE_nT, NYQUIST_Hz = 138 * np.array([0.6, -0.64, 0.48]), 1.0


def _in_the_body(rows: Rows, segments: list[dict[str, Any]], field_nT: np.ndarray) -> np.ndarray:
    """A field of the cage (n, 3) as the device sees it."""
    out = np.zeros_like(field_nT)
    for segment in segments:
        here = rows["segment"] == segment["id"]
        out[here] = rotate(np.array(segment["axis_body"]), -rows["angle"][here], field_nT[here])
    return out


@pytest.mark.parametrize(
    ("frame", "owner", "f_Hz"), [("cage", "rig", 0.93 * NYQUIST_Hz), ("body", "sensor", 0.3), ("body", "sensor", 0.991)]
)
def test_a_line_is_found_in_the_frame_that_it_is_fixed_to(
    making: ModuleType, tmp_path: Path, frame: str, owner: str, f_Hz: float
) -> None:
    rows, segments = making.recorded()
    line = np.cos(2 * np.pi * f_Hz * rows["t_s"] + 0.4)[:, None] * LINE_nT
    rows["dut"] = rows["dut"] + 1.05 * (_in_the_body(rows, segments, line) if frame == "cage" else line)
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert [(e.effect, e.belongs_to) for e in closed.accepted] == [("periodic", owner)]
    assert closed.verdict == "explained"
    found = {p.name: p for p in closed.accepted[0].parameters}
    prefix = "cage_" if frame == "cage" else ""
    sizes = [np.hypot(found[f"{prefix}cos_{a}"].value, found[f"{prefix}sin_{a}"].value) for a in "xyz"]
    assert np.allclose(sizes, np.abs(LINE_nT), atol=5 * found[f"{prefix}cos_x"].u)
    assert abs(found["f_Hz"].value - f_Hz) < 5 * found["f_Hz"].u
    if frame == "cage":
        with pytest.raises(InputError, match="the rig's, never the sensor's"):
            load_shipped(replace(closed.accepted[0], belongs_to="sensor"))


def test_rows_are_not_binned_where_a_fast_line_of_the_cage_would_be_lost(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded("z", seconds=2700.0)
    draw = np.random.default_rng(1)
    rows["angle"] = rows["angle"] + np.cumsum(draw.normal(0, 0.1, len(rows["angle"])))  # smears it over the body's axes
    line = 30 * np.cos(2 * np.pi * 0.9 * rows["t_s"])[:, None] * [1.0, 0.0, 0.0]
    seen = _in_the_body(rows, segments, rows["ref"] + line)
    rows["dut"] = 1.05 * seen + 800 + draw.normal(0, 20, seen.shape)
    problem, _, _ = prepare(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert rows_per_bin(problem) == 1


@pytest.mark.parametrize(("period_s", "f_Hz"), [(None, 50.3143), (1.13, 60.0271), (0.45847, 60.0)])
def test_the_mains_are_found_at_their_own_frequency_where_the_recorder_starts_anew(
    making: ModuleType, tmp_path: Path, period_s: float | None, f_Hz: float
) -> None:
    rows, segments = making.recorded()
    if period_s is not None:
        rows["t_s"] = rows["t_s"] * (period_s / np.median(np.diff(rows["t_s"])))
    for number, segment in enumerate(segments):
        rows["t_s"][rows["segment"] == segment["id"]] += [0.1317, 0.3702, 0.0285, 0.2939, 0.4411, 0.2123][number]
    line = np.cos(2 * np.pi * f_Hz * rows["t_s"] + 0.4)[:, None] * LINE_nT
    rows["dut"] = rows["dut"] + 1.05 * line
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert ([e.effect for e in closed.accepted], closed.verdict) == (["periodic"], "explained")
    found = {p.name: p for p in closed.accepted[0].parameters}
    assert abs(found["f_Hz"].value - f_Hz) < max(5 * found["f_Hz"].u, 1e-4)
    assert abs(np.hypot(found["cos_x"].value, found["sin_x"].value) - LINE_nT[0]) < 5


Started = Callable[..., LinearProblem]


def _lines(pool: CandidateSet) -> list[Candidate]:
    return [c for c in all_candidates(pool, []) if c.family.id == "periodic" and c.belongs_to == "sensor"]


@pytest.mark.parametrize("between", [0.0, 0.25, 0.5])
def test_a_line_is_offered_at_its_own_frequency_wherever_it_lies_between_those_of_a_spectrum(
    started: Started, between: float
) -> None:
    """A quarter of a run's resolution off, a line of half an hour has lost a third of itself by its end."""
    t_s = started().scene.t_s
    frequency, _ = periodogram(t_s, np.zeros((len(t_s), 1)))
    f_Hz = frequency[300] + between * (frequency[1] - frequency[0])
    pool = CandidateSet.of(started(lambda rows: np.cos(2 * np.pi * f_Hz * rows["t_s"])[:, None] * LINE_nT), 0.85)
    off = min(abs(c.term.at("f_Hz") - f_Hz) for c in _lines(pool))
    assert off * np.ptp(t_s) < 0.1


@pytest.mark.parametrize(("phases_rad", "narrow"), [(0.0, True), (2.0, False)])
def test_what_begins_anew_in_each_segment_is_no_line_however_alike_it_is_within(
    started: Started, phases_rad: float, narrow: bool
) -> None:
    def wave(rows: Rows) -> np.ndarray:
        number = np.unique(rows["segment"], return_inverse=True)[1]
        phase = phases_rad * np.random.default_rng(4).normal(size=number.max() + 1)
        return np.cos(2 * np.pi * 0.13 * rows["t_s"] + phase[number])[:, None] * LINE_nT

    pool = CandidateSet.of(started(wave), 0.85)
    assert len(stretches(pool.problem.scene.segment)) == 6
    null = pool.null_model()
    best = max((pool.score(c, null) for c in _lines(pool)), key=lambda w: w.evidence)
    assert best.evidence > 100
    assert is_narrow_line(pool, [], refined(pool, best.candidate, [])) is narrow


def test_a_line_is_named_beside_what_nothing_explains_and_a_wave_of_many_phases_is_not(started: Started) -> None:
    def beside(rows: Rows, phases_rad: float) -> np.ndarray:
        draw, number = np.random.default_rng(8), np.unique(rows["segment"], return_inverse=True)[1]
        phase = phases_rad * draw.normal(size=number.max() + 1)
        popcorn = 90.0 * (draw.random((len(number), 3)) < 0.3)
        return np.cos(2 * np.pi * 0.13 * rows["t_s"] + phase[number])[:, None] * LINE_nT + popcorn

    rows = np.ones(40)
    falls = [HeldOutErrors(np.arange(40), 160.0 * rows, 110.0 * rows, rows > 0)]  # far more left than a square wave has
    level = NoiseFloor(35.0, "declared", None)
    for phases_rad, unsupported in ((0.0, None), (2.0, 0)):
        pool = CandidateSet.of(started(lambda rows, by=phases_rad: beside(rows, by)), 0.85)
        best = max((pool.score(c, pool.null_model()) for c in _lines(pool)), key=lambda w: w.evidence)
        assert first_unsupported(pool, [refined(pool, best.candidate, [])], falls, level) == unsupported


def test_mains_far_above_the_nyquist_frequency_are_told_from_their_images_by_segments_that_start_anew() -> None:
    """A false order may come within a hundredth of the true one's power: the tops are compared, not the steps."""
    right, tried = 0, 0
    for seed in range(60):
        draw = np.random.default_rng(seed)
        step_s, rows = float(np.exp(draw.uniform(np.log(0.3), np.log(3)))), int(draw.integers(60, 150))
        starts_s = np.cumsum(rows * step_s + draw.uniform(60, 180, int(draw.integers(4, 8))))
        t_s = np.round((starts_s[:, None] + step_s * np.arange(rows)).ravel(), 5)
        line_Hz = draw.choice([50.0, 60.0]) * (1 + draw.normal(0, 2e-4))
        image = abs(line_Hz * step_s - round(line_Hz * step_s))  # cycles a row
        if not 1.5 < image * rows < rows / 2 - 2:
            continue
        line = 3 * np.sin(2 * np.pi * line_Hz * t_s[:, None] + draw.uniform(0, 6, 3)) * draw.normal(size=3)
        parts = [slice(k * rows, (k + 1) * rows) for k in range(len(starts_s))]
        found = unfolded_line(t_s, line + draw.normal(size=line.shape), parts)
        right += found is not None and abs(found[0] - line_Hz) < 0.5 / np.ptp(t_s)
        tried += 1
    assert tried > 40
    assert right >= 0.95 * tried


@pytest.mark.parametrize("cycles", [0.3, 0.65, 0.95, 1.4, 2.1, 3.5])
def test_mains_whose_image_has_few_periods_in_a_segment_or_not_one_are_found(cycles: float) -> None:
    draw, step_s, rows = np.random.default_rng(3), 0.75, 84
    starts_s = np.cumsum(rows * step_s + draw.uniform(60, 180, 9))
    t_s = (starts_s[:, None] + step_s * np.arange(rows)).ravel()
    line_Hz = 45 / step_s + cycles / (rows * step_s)
    line = 3 * np.sin(2 * np.pi * line_Hz * t_s)[:, None] * [1.0, -0.5, 0.8]
    parts = [slice(k * rows, (k + 1) * rows) for k in range(len(starts_s))]
    found = unfolded_line(t_s, line + draw.normal(size=line.shape), parts)
    assert found is not None
    assert abs(found[0] - line_Hz) < 0.5 / np.ptp(t_s)


@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (1, 2, 3))])
def test_a_slow_wave_that_begins_anew_in_each_segment_is_no_line(making: ModuleType, tmp_path: Path, seed: int) -> None:
    """Of thousands of frequencies that fold there some have nearly the phases that chance gave six segments."""
    rows, segments = making.recorded()
    draw = np.random.default_rng(seed)
    for segment in segments:
        here = rows["segment"] == segment["id"]
        of_segment = np.linspace(0, 2 * np.pi * 0.7, here.sum())[:, None] + draw.uniform(0, 6, 3)
        rows["dut"][here] += 200 * draw.normal(size=3) * np.sin(of_segment)
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert "periodic" not in [one.effect for one in closed.accepted]
