"""What to measure next follows from what each experiment would record, not from a table of names."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.loop.candidates.library import Candidate, expand_library
from labcal.loop.close import prepare
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.design.discrimination import CLEAR, rank_experiments
from labcal.loop.design.experiments import experiments
from labcal.model.effects import families, family
from labcal.runner import procedures


@pytest.fixture
def problem(making: ModuleType, tmp_path: Path) -> LinearProblem:
    return prepare(session.load_run(str(making.written(tmp_path, *making.recorded()))))[0]


def _candidate(problem: LinearProblem, name: str, number: int = 0) -> Candidate:
    found = family(name)
    return Candidate(found, found.candidates(problem.run)[number])


def _sigmas(problem: LinearProblem, one: Candidate, other: Candidate, size: list[float]) -> dict[str, float]:
    return {s.experiment.do: s.sigma for s in rank_experiments(problem, one, other, np.array(size))}


def test_a_temperature_and_a_drift_are_told_apart_by_warming_and_not_by_turning_back(problem: LinearProblem) -> None:
    """The run's own temperature is a slow sine; on a parabola through it warming adds most."""
    sigma = _sigmas(problem, _candidate(problem, "offset-temperature"), _candidate(problem, "offset-drift"), [5, -4, 2])
    assert max(sigma, key=sigma.__getitem__) == "warm the device and let it cool in two fields"


def test_a_current_and_its_square_are_told_apart_by_switching_loads_in_three_levels(
    making: ModuleType, tmp_path: Path
) -> None:
    rows, segments = making.recorded()
    rows["i_load"] = (np.mod(rows["t_s"], 47.0) < 19.0) * 0.8
    problem = prepare(session.load_run(str(making.written(tmp_path, rows, segments))))[0]
    one, other = (_candidate(problem, f"offset-current{end}") for end in ("", "-squared"))
    sigma = _sigmas(problem, one, other, [40.0, 0.0, 0.0])
    assert max(sigma, key=sigma.__getitem__) == "switch every load on and off at one attitude"
    assert sigma["repeat the run unchanged"] < CLEAR  # two levels again: a line and a parabola through both


REVERSED, OTHER_RATES = "turn once forwards and once backwards", "turn at half and at twice the rate"
TWO_FIELDS, LOADS = "turn in two more coil fields", "switch every load on and off at one attitude"


@pytest.mark.parametrize(
    ("one", "other", "declared"),
    [
        ("cage-field", "reference-drift", {"turn the reference by 180°"}),
        ("dut-dipole-at-reference", "field-gradient", {TWO_FIELDS}),
        ("offset-temperature", "offset-drift", {"warm the device and let it cool"}),
        ("lag", "axis-tilt", {REVERSED, OTHER_RATES}),
        ("lag", "hysteresis", {REVERSED, OTHER_RATES}),
        ("cage-field", "field-gradient", {TWO_FIELDS, "step the field up and down"}),
        ("offset-current", "cage-field", {LOADS}),
    ],
)
def test_twins_of_one_field_are_sent_to_the_experiment_that_is_declared_for_them(
    making: ModuleType, tmp_path: Path, one: str, other: str, declared: set[str]
) -> None:
    """Turned at one rate in one field, the current locked to the attitude, starting phases unknown, warming only."""
    rows, segments = making.recorded()
    rows["temp"], rows["i_load"] = 20 + rows["t_s"] / 100, 0.4 + 0.4 * np.cos(rows["angle"])
    segments = [{k: v for k, v in s.items() if k != "body_from_cage"} for s in segments[3:]]
    kept = np.isin(rows["segment"], [s["id"] for s in segments])
    run = session.load_run(str(making.written(tmp_path, {k: v[kept] for k, v in rows.items()}, segments)))
    problem = prepare(replace(run, reference=replace(run.reference, position_m=(0.1, 0.0, 0.2))))[0]
    candidates = expand_library(problem)
    chosen, rival = (next(c for c in candidates if c.family.id == name) for name in (one, other))
    columns = chosen.term.columns(problem.scene)
    size = 100.0 / np.maximum(np.sqrt(np.mean(np.sum(columns**2, axis=1), axis=0)), 1e-12)  # nT each
    best = rank_experiments(problem, chosen, rival, size)[:3]
    assert best[0].sigma > CLEAR
    assert any(s.experiment.do.startswith(tuple(declared)) and s.sigma > CLEAR for s in best)


def test_an_effect_is_never_far_from_itself(problem: LinearProblem) -> None:
    tilt = _candidate(problem, "axis-tilt")
    sigma = _sigmas(problem, tilt, tilt, [0.1] * len(tilt.term.parameters))
    assert max(sigma.values()) < 0.1


def test_a_larger_effect_is_told_apart_in_proportion(problem: LinearProblem) -> None:
    one, other = _candidate(problem, "lag"), _candidate(problem, "axis-tilt")
    small, large = (_sigmas(problem, one, other, [size]) for size in (0.01, 0.03))
    assert large["turn once forwards and once backwards in one mounting"] == pytest.approx(
        3 * small["turn once forwards and once backwards in one mounting"], rel=1e-6
    )


def test_every_procedure_proposed_is_one_of_the_lab_s() -> None:
    named = {e.procedure for e in experiments()} - {None}
    assert named <= set(procedures())


def test_every_family_that_another_one_names_is_there() -> None:
    assert {name for f in families() for name in (*f.extends, *f.related)} <= {f.id for f in families()}


def test_an_ambiguous_run_says_which_experiment_and_how_far_apart(
    making: ModuleType, tmp_path: Path, closed_loop: Callable[[Path], tuple[int, dict[str, Any], str]]
) -> None:
    rows, segments = making.recorded()
    rows["temp"] = 20 + rows["t_s"] / 100
    rows["dut"] += (rows["temp"] - 22)[:, None] * [40.0, -30.0, 20.0]
    code, result, _ = closed_loop(making.written(tmp_path, rows, segments))
    assert (code, result["verdict"]) == (1, "ambiguous")
    proposed = result["next_experiment"]
    assert proposed["procedure"] in procedures()
    assert proposed["ranking"][0]["sigma"] >= proposed["ranking"][1]["sigma"] > 0
    assert "standard deviations apart" in proposed["why"]
    assert {pair["other"] for pair in result["twins"]} >= {"a drift"}
