"""A correction is only as good as the excitation that pins it down."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop.candidates.library import Candidate
from labcal.loop.close import prepare
from labcal.loop.findings.working_range import findings, range_uncertainty, unsupported
from labcal.loop.selection.joint_fit import JointFit, joint_fit
from labcal.model.effects import Family, Scene, Term, family
from labcal.model.effects.regressors import on_each_axis, per_axis
from labcal.record import Run


def _warmed(making: ModuleType, folder: Path, warm: np.ndarray) -> tuple[Run, Candidate, JointFit]:
    """A sensor whose gains follow `warm` [degC] by 1e-3, its base and gain-temperature fitted."""
    rows, segments = making.recorded()
    rows["temp"] = 20 + warm
    rows["dut"] += 1e-3 * warm[:, None] * (rows["dut"] - 800)
    run = session.load_run(str(making.written(folder, rows, segments)))
    gains = Candidate(family("gain-temperature"), family("gain-temperature").candidates(run)[0])
    return run, gains, joint_fit(prepare(run)[0], [gains.term])


def test_a_gain_that_was_warmed_in_all_attitudes_is_supported(making: ModuleType, tmp_path: Path) -> None:
    t = making.recorded()[0]["t_s"]
    run, gains, after = _warmed(making, tmp_path, 10 * np.sin(t / 20))
    of = range_uncertainty(run, after, 0)
    assert of is not None
    assert of.supported
    assert of.rms_nT == pytest.approx(1e-3 * 10 * 50000, rel=0.1)  # 10 degC either way, in 50 µT
    assert unsupported(run, [gains], after) == frozenset()
    assert not [f for f in findings(run, [gains], after) if f.kind == "working-range"]


def follows_the_rate(term: Term, scene: Scene) -> np.ndarray:
    T, t_s = term.drive(scene), scene.t_s
    return on_each_axis(np.diff(T, prepend=T[0]) / np.diff(t_s, prepend=t_s[0] - 1.0))


def test_one_that_follows_a_change_and_is_nothing_where_all_stands_still_is_not_held_back(
    making: ModuleType, tmp_path: Path
) -> None:
    rows, segments = making.recorded()
    rows["temp"] = 20 + 3 * np.sin(rows["t_s"] / 15)
    rows["dut"][1:] += 2000 * (np.diff(rows["temp"]) / np.diff(rows["t_s"]))[:, None]
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    term = Term(follows_the_rate, per_axis("c", "nT s/degC"), ("temp",), {"temp": 20.0})
    rate = Candidate(Family("rate", "sensor", follows_the_rate, lambda run: [term]), term)
    after = joint_fit(prepare(run)[0], [term])
    assert after.beta[0] == pytest.approx(2000 / 1.05, rel=0.02)
    assert unsupported(run, [rate], after) == frozenset()
    assert not [f for f in findings(run, [rate], after) if f.kind == "working-range"]


def test_one_that_was_warm_for_a_moment_alone_is_not_and_says_what_is_missing(
    making: ModuleType, tmp_path: Path
) -> None:
    t = making.recorded()[0]["t_s"]
    run, gains, after = _warmed(making, tmp_path, 0.02 * ((t > 20) & (t < 23)))
    assert unsupported(run, [gains], after) == frozenset({0})
    said = " ".join(f.says for f in findings(run, [gains], after))
    assert "not pinned down" in said
