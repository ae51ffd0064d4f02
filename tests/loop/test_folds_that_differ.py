"""A right choice is not taken apart by a fold that finds less, nor by effects that show only side by side."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal.loop import close_loop
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.selection import heldout_rules, proof, select
from labcal.loop.selection.crossval import NEVER, HeldOutErrors, block_folds
from labcal.record import Channel, Run
from labcal.store import read_bundle
from labcal.testing.made_up_runs import made_up_run

Started = Callable[..., LinearProblem]
EACH_nT = np.array([150.0, -90.0, 60.0])


def _warmed() -> Run:
    """A run in which the device is warmed and cools a few times."""
    rows = 100
    t_s = made_up_run(rows=rows).run.t_s
    board = Channel("t_board", "degC", "temperature", 24 + 3 * np.sin(t_s / 17.3))
    made = made_up_run(rows=rows, channels=[board])
    return made.with_effect((board.values - 24)[:, None] * EACH_nT)


@pytest.mark.parametrize(("empty", "named"), [(2, ["offset-temperature"]), pytest.param(3, [], marks=pytest.mark.slow)])
def test_names_that_most_folds_choose_stand(monkeypatch: pytest.MonkeyPatch, empty: int, named: list[str]) -> None:
    whole, known = proof.nested_selection, list[object]()

    def some_choose_nothing(*stated: Any) -> Callable[[CandidateSet], Sequence[Candidate]]:
        choose = whole(*stated)

        def chosen(part: CandidateSet) -> Sequence[Candidate]:
            if part not in known:
                known.append(part)
            return () if known.index(part) < empty else choose(part)

        return chosen

    monkeypatch.setattr(proof, "nested_selection", some_choose_nothing)
    monkeypatch.setattr(heldout_rules, "stands_beside_discrepancy", lambda *given: False)
    assert [e.effect for e in close_loop(_warmed()).accepted] == named


def test_of_effects_that_hide_each_other_each_brings_what_it_brings_beside_all(
    started: Started, monkeypatch: pytest.MonkeyPatch
) -> None:
    pool = CandidateSet.of(started(), 0.85)
    three, rows = pool.candidates[:3], np.ones(40)

    def held_out(pool: CandidateSet, blocks: object, choose: Any, before: Sequence[Candidate]) -> HeldOutErrors:
        left = [10.0 if len(some) == len(three) else 100.0 for some in (before, choose(pool))]
        return HeldOutErrors(np.arange(40), left[0] * rows, left[1] * rows, rows > 0)

    monkeypatch.setattr(select, "cross_validate", held_out)
    blocks = block_folds(pool.problem, 0.0)
    steps = [select.contribution(pool, blocks, three, place) for place in range(3)]
    assert [(step.before, step.after) for step in steps] == [(100.0, 10.0)] * 3


def test_a_gain_that_hardly_changes_is_not_the_readings_own_residual(started: Started) -> None:
    """Neither in a device whose noise is stated, nor in one whose readings stand as they are."""
    problem = started(lambda rows: 900.0 * np.sin(rows["t_s"] / 1.7)[:, None] * np.array([1.0, 0.4, -0.6]))
    run = problem.run
    undeclared = replace(run, dut=replace(run.dut, noise_nT=None))
    for one in (problem, prepare(undeclared)[0]):
        field = one.scene.along_axes_nT @ one.scene.axes.T
        as_gain = np.einsum("nqj,nj->nq", one.whiten, field).reshape(-1, 1)
        base = one.T.reshape(len(as_gain), -1)
        left = as_gain - base @ np.linalg.lstsq(base, as_gain, rcond=None)[0]
        assert np.linalg.norm(left) < 1e-6 * np.linalg.norm(as_gain)


def test_the_simplest_form_that_is_no_worse_is_not_far_worse_than_the_next(tmp_path: Path) -> None:
    """A slow gain, whose curve is a detail of four fifths of the rows: without the curve it is still slow."""
    program = Path(__file__).parents[1] / "blind" / "spacecraft.py"
    subprocess.run([sys.executable, program, tmp_path, "20", "41129", "19"], check=True)
    problem, level, _ = prepare(read_bundle(tmp_path / "b0019" / "bundle"))
    pool = CandidateSet.of(problem, 0.85)
    pool = pool.among(tuple(c for c in pool.candidates if c.cause == ("gain-temperature", ("t_sensor",))))
    blocks = select.select(pool, level, most=1).blocks
    for fold in np.unique(blocks.fold[blocks.fold != NEVER]).tolist():
        part = pool.on(blocks.training(problem.scene.t_s, fold))
        (chosen,) = select.select(part, level, blocks.restricted_to(part.rows), most=1).accepted
        assert "tau_s" in [shape.name for shape in chosen.term.shape], fold
