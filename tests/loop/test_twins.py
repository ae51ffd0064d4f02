"""Causes that no run of a kind can tell apart, and the run that can."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.loop.close import prepare
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.design.experiments import experiments
from labcal.loop.findings.confounded import confounded
from labcal.model.effects import Term, family
from labcal.model.effects.iron import BESIDE


@pytest.mark.parametrize("backwards", [pytest.param(False, marks=pytest.mark.slow), True])
def test_a_lag_at_one_rate_is_the_phases_and_turning_backwards_tells_it(
    making: ModuleType, tmp_path: Path, closed_loop: Callable[[Path], tuple[int, dict[str, Any], str]], backwards: bool
) -> None:
    rows, segments = making.recorded()
    rate = np.full(len(rows["t_s"]), np.radians(making.RATE_DEG_PER_S))
    for segment in segments[3:] if backwards else []:
        there = np.flatnonzero(rows["segment"] == segment["id"])
        rate[there] *= -1
        for name in ("dut", "angle"):
            rows[name][there] = rows[name][there[::-1]]
    rows["angle"] += rate * 0.1  # what is read was the field a tenth of a second ago
    for segment in segments:  # one unknown phase for each mounting
        del segment["body_from_cage"]
        segment["mounting"] = segment["id"][0]
    _, result, _ = closed_loop(making.written(tmp_path, rows, segments))
    assert [effect["effect"] for effect in result["accepted"]] == (["lag"] if backwards else [])
    assert result["verdict"] == ("explained" if backwards else "clean")
    alike = {(pair["one"], pair["other"]) for pair in result["twins"]}
    assert (("a lag at a constant rate", "the mounting's phase") in alike) is not backwards


def _said(problem: LinearProblem, *named: str) -> set[tuple[str, str]]:
    return {(pair.one, pair.other) for pair in confounded(problem, map(family, named))}


def test_a_current_that_follows_the_attitude_is_a_twin_of_soft_iron(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    plain = prepare(session.load_run(str(making.written(tmp_path / "plain", rows, segments))))[0]
    rows["i_load"] = rows["dut"][:, 0] / 50_000 + np.random.default_rng(1).normal(0, 0.01, len(rows["t_s"]))
    locked = prepare(session.load_run(str(making.written(tmp_path / "locked", rows, segments))))[0]
    pair = ("what i_load does, which follows the attitude", "soft iron")
    assert pair in _said(locked)
    assert pair not in _said(plain)


def test_every_turned_run_says_what_its_reference_and_fixture_leave_open(started: Callable[..., LinearProblem]) -> None:
    said = _said(started())
    assert ("the reference's scale", "the device's gain") in said
    assert ("magnetism of what turns with the device", "the device's offset") in said
    assert ("a lag at a constant rate", "the mounting's phase") not in said  # the attitudes are declared


def test_a_rival_brings_its_twins_as_an_accepted_cause_does(started: Callable[..., LinearProblem]) -> None:
    assert ("a temperature that only rises", "a drift") in _said(started(), "cage-field", "offset-drift")


def test_a_lean_of_the_platform_is_a_part_of_iron_beside_the_cage(started: Callable[..., LinearProblem]) -> None:
    """Turned in the cage, the field is three of the nine columns of what a tensor of the cage makes of it."""
    problem = started()
    lean = Term(family("axis-tilt").kernel, tuple((f"cage_{a}", "deg") for a in "xyz")).columns(problem.scene)
    iron = Term(family("cage-field").kernel, BESIDE).columns(problem.scene)
    lean, iron = (columns.reshape(-1, columns.shape[2]) for columns in (lean, iron))
    left = lean - iron @ np.linalg.lstsq(iron, lean, rcond=None)[0]
    assert np.abs(left).max() < 1e-9 * np.abs(lean).max()
    assert ("iron beside the cage", "a platform that leans in the cage") in _said(problem, "cage-field")


def test_the_bare_platform_says_nothing_of_the_device_and_is_not_proposed_for_it() -> None:
    bare = next(e for e in experiments() if e.procedure == "platform-signature")
    assert bare.concerns == {"cage-field", "reference-drift", "reference-temperature"}
    assert {name for name, factor in bare.alters if factor == 0} >= {"axis-tilt", "field-gradient", "lag"}
