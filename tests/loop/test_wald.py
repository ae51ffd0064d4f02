"""An effect that is no larger than its uncertainty, declared errors included, is not named."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.geometry import rotate
from labcal.loop import close, close_loop
from labcal.loop.candidates.library import expand_library
from labcal.loop.close import prepare
from labcal.loop.selection.joint_fit import joint_fit
from labcal.loop.uncertainty import uncertainty_of, wald_p_values


def run_with(making: ModuleType, folder: Path, per_ampere_nT: float) -> Path:
    rows, segments = making.recorded(seconds=30.0)
    rows["dut"] = rows["dut"] + per_ampere_nT * rows["i_load"][:, None] * np.array([1.0, -0.7, 0.5])
    return Path(making.written(folder, rows, segments))


def test_the_chance_of_nought_is_even_where_nothing_is_and_tiny_where_something_is(
    making: ModuleType, tmp_path: Path
) -> None:
    chances = []
    for size in (0.0, 40.0):
        problem, *_ = prepare(session.load_run(str(run_with(making, tmp_path / str(size), size))))
        load = next(c for c in expand_library(problem) if c.label == "offset-current (i_load)")
        chances += wald_p_values(joint_fit(problem, [load.term]))
    assert chances[0] > 0.01
    assert chances[1] < 1e-6


def test_a_scale_of_the_reference_in_a_map_of_its_field_takes_up_no_noise(making: ModuleType, tmp_path: Path) -> None:
    """Beside K there remains of it the scale times the residual itself, which nothing says is that large.

    A map of the cage's field has such a scale where the field has three directions.
    """
    rows, segments = making.recorded(seconds=30.0)
    of_segment = np.repeat(np.arange(len(segments)), len(rows["t_s"]) // len(segments))
    rows["ref"] = np.random.default_rng(3).normal(0, 25000.0, (len(segments), 3))[of_segment]
    axis = np.array([s["axis_body"] for s in segments])[of_segment]
    noise = np.random.default_rng(4).normal(0, making.NOISE_nT, axis.shape)
    rows["dut"] = rotate(axis, -rows["angle"], rows["ref"]) + noise
    for segment in segments:
        del segment["body_from_cage"]
    problem, *_ = prepare(session.load_run(str(making.written(tmp_path, rows, segments, noise_nT=None))))
    maps = [c for c in expand_library(problem) if c.label == "cage-field" and "bx_x" in dict(c.term.parameters)]
    found = joint_fit(problem, [maps[0].term])
    assert wald_p_values(found)[0] > 0.01
    spread = np.sqrt(np.diag(uncertainty_of(found).covariance))[9:12]  # of k, by the least of noise's share
    assert (spread > making.NOISE_nT / 1.05 / np.sqrt(len(noise))).all()


def test_what_declared_errors_explain_as_well_is_given_up(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = session.load_run(str(run_with(making, tmp_path, 200.0)))
    assert [e.effect for e in close_loop(run).accepted] == ["offset-current"]
    monkeypatch.setattr(close, "wald_p_values", lambda fitted: [0.5 for _ in fitted.terms])
    closed = close_loop(replace(run, run_id="again"))
    assert closed.accepted == ()
    refused = next(e for e in closed.rejected if (e.effect, e.channels) == ("offset-current", ("i_load",)))
    assert "no larger than its uncertainty" in refused.why
    assert "50 %" in refused.why
