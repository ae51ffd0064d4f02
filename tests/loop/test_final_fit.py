"""The fit that goes into the file, and what a column of the rig may be made of."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.fit.vector.ml import ml
from labcal.geometry import rotate
from labcal.loop import close_loop
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.data.credible import (
    credible,
    driven_by_field,
    is_beyond_half,
    left_by_the_best_map,
    min_new_share,
    without_wild_rows,
)
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.nuisance import orthonormal
from labcal.loop.policy import POLICY
from labcal.loop.refit import refit
from labcal.loop.selection import final_fit as final
from labcal.loop.selection.joint_fit import JointFit, joint_fit
from labcal.model import EffectRecord, Parameter
from labcal.model.effects import Term

Started = Callable[..., LinearProblem]


def _wander(rows: dict[str, np.ndarray]) -> np.ndarray:
    """What belongs to nothing: a walk of each axis [nT]."""
    return np.cumsum(np.random.default_rng(3).normal(0, 40.0, rows["dut"].shape), axis=0)


def test_no_gradient_takes_off_what_belongs_to_nothing(started: Started) -> None:
    """A stretch of the whole field, which the map undoes but for the residual itself, would take off all of it."""
    problem = started(_wander)
    pool = CandidateSet.of(problem, 0.85)
    raw = problem.y - problem.T @ pool.coefficients(())
    for candidate in (c for c in pool.candidates if c.family.id == "field-gradient"):
        left = pool.residual([candidate])
        assert np.sum(left**2) > 0.4 * np.sum(raw**2)


def test_directions_that_are_hardly_new_are_left_out_and_the_others_stay() -> None:
    draw = np.random.default_rng(1)
    base, other = draw.normal(size=(200, 3, 4)), draw.normal(size=(200, 3, 1))
    nearly = base[:, :, :1] + 1e-2 * draw.normal(size=(200, 3, 1))
    columns = np.concatenate([7.0 * nearly, 0.1 * other], axis=2)
    found = credible(columns, orthonormal(base), 1e-2)
    assert np.linalg.matrix_rank(found.reshape(600, 2), tol=1e-6 * np.abs(columns).max()) == 1
    beta = np.linalg.lstsq(found.reshape(600, 2), other.ravel(), rcond=1e-6)[0]
    assert np.linalg.norm(found @ beta - other[:, :, 0]) < 0.2 * np.linalg.norm(other)
    assert credible(columns, orthonormal(base), 1e-8) is columns


def test_the_share_that_is_new_does_not_depend_on_the_columns_that_a_span_is_given_by() -> None:
    """Two columns that are alike, whose sum is nearly the base's: at unit length it would seem twice as new."""
    draw = np.random.default_rng(2)
    base, far = draw.normal(size=(200, 3, 1)), 0.2 * draw.normal(size=(200, 3, 1))
    nearly = base + np.sqrt(0.007) * draw.normal(size=(200, 3, 1))
    for columns in (np.concatenate([nearly, far], axis=2), np.concatenate([nearly + far, nearly - far], axis=2)):
        found = credible(columns, orthonormal(base), 1e-2).reshape(600, 2)
        assert np.linalg.matrix_rank(found, tol=1e-6 * np.abs(columns).max()) == 1
        left = nearly.ravel() - found @ np.linalg.lstsq(found, nearly.ravel(), rcond=None)[0]
        assert np.linalg.norm(left) > 0.9 * np.linalg.norm(nearly)


@pytest.mark.parametrize(
    ("of_y", "apart_nT", "beyond"),
    [(-0.95, 50.0, True), (-0.52, 50.0, True), (-0.46, 50.0, False), (-0.3, 50.0, False), (-0.95, 6000.0, False)],
)
def test_an_effect_that_undoes_one_direction_of_the_field_is_no_effect(
    of_y: float, apart_nT: float, beyond: bool
) -> None:
    """Of a field of 44 000 nT along z in which y alone changes, by 10 000 nT: a fifth of it as a whole."""
    draw = np.random.default_rng(4)
    reference = np.array([18000.0, -1500.0, -44000.0]) + draw.normal(0, [20.0, 10000.0, 20.0], (200, 3))
    effect = reference[:, 1:2] * np.array([0.1, of_y, 0.0]) + draw.normal(0, 30.0, (200, 3))
    assert is_beyond_half(effect, reference, apart_nT) is beyond


def test_a_drift_of_the_reference_is_part_of_no_field_and_what_stands_in_the_cage_is(started: Started) -> None:
    """As the run's set-points change with time, a drift goes along with one of them by chance."""
    told = {c.family.id: driven_by_field(c.term) for c in CandidateSet.of(started(), 0.85).candidates}
    assert told["reference-drift"] is False
    assert told["cage-field"] is told["field-gradient"] is told["axis-tilt"] is True
    assert told["offset-drift"] is False


@pytest.mark.slow
def test_an_effect_of_the_rig_beyond_half_of_the_field_is_given_up(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows, segments = making.recorded(seconds=20.0)
    axis = np.array([s["axis_body"] for s in segments])[np.repeat(np.arange(6), len(rows["t_s"]) // 6)]
    rows["dut"] = rows["dut"] + 1.05 * rotate(axis, -rows["angle"], np.array([300.0, -200.0, 250.0]))
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    assert [e.effect for e in close_loop(run).accepted] == ["cage-field"]
    monkeypatch.setattr(final, "is_beyond_half", lambda *_: True)
    closed = close_loop(replace(run, run_id="again"))
    assert not {e.belongs_to for e in closed.accepted} & {"rig"}
    refused = next(e for e in closed.rejected if e.effect == "cage-field")
    assert "more than half of the field" in refused.why


@pytest.mark.parametrize("declared", [True, False])
def test_a_loop_as_wide_as_the_field_is_no_field_that_the_map_could_undo(started: Started, declared: bool) -> None:
    """Driven by the reference it is the reference, and a map that is zero would leave nothing at all."""
    problem = started(lambda rows: np.where(rows["t_s"] % 90 < 20, 2500.0, 0.0)[:, None] * np.array([1.0, 0.4, -0.6]))
    run = problem.run
    problem = prepare(run if declared else replace(run, dut=replace(run.dut, noise_nT=None)))[0]
    loops = (c.term for c in CandidateSet.of(problem, 0.85).candidates if c.family.id == "hysteresis")
    loop = next(term for term in loops if {s.name for s in term.shape} == {"r_nT", "kept", "begins", "less_itself"})
    wide = replace(loop, shape=tuple(replace(s, value=1e6) if s.name == "r_nT" else s for s in loop.shape))
    for made in (problem.all_columns(wide), problem.columns(wide)):
        A = np.concatenate([problem.T, made], axis=2).reshape(problem.y.size, -1)
        left = problem.y.ravel() - A @ np.linalg.lstsq(A, problem.y.ravel(), rcond=1e-10)[0]
        assert np.linalg.norm(left) > 0.3 * np.linalg.norm(problem.y)


@pytest.mark.parametrize("declared", [True, False])
def test_a_stretch_of_what_the_reference_says_is_one_of_the_map_whatever_the_map_leaves(
    started: Started, declared: bool
) -> None:
    """Of the readings themselves it would differ by the residual, stretched: that would take off all of it."""
    run = started(_wander).run
    problem = prepare(run if declared else replace(run, dut=replace(run.dut, noise_nT=None)))[0]
    assert problem.scene.rig is not None
    T = problem.T.reshape(problem.y.size, -1)
    for place in range(9):
        change = np.eye(9)[place].reshape(3, 3)
        stretched, apart = (
            np.einsum("nqj,nj->nq", problem.whiten, field @ change.T).ravel()
            for field in (problem.scene.rig.prediction_nT, problem.residual_nT)
        )
        left = stretched - T @ np.linalg.lstsq(T, stretched, rcond=None)[0]
        assert np.linalg.norm(left) < 0.1 * np.linalg.norm(apart)


def test_the_share_that_has_to_be_new_is_half_a_field() -> None:
    """What is new by less than it, and takes off the residual, is larger than half of the field itself."""
    residual, field = np.full((50, 3), 30.0), np.full((50, 3), 600.0)
    assert np.sqrt(30.0**2 / min_new_share(residual, field)) == pytest.approx(300.0)


def test_how_far_apart_readings_and_reference_are_does_not_hang_on_the_map_that_was_found_beside_an_effect(
    started: Started,
) -> None:
    problem = started(_wander)
    best = left_by_the_best_map(problem.T, problem.whiten, problem.residual_nT)
    far = np.random.default_rng(1).normal(size=problem.T.shape[2]) * 3000 / np.abs(problem.T).max(axis=(0, 1))
    elsewhere = problem.residual_nT + np.linalg.solve(problem.whiten, (problem.T @ far)[:, :, None])[:, :, 0]
    assert np.linalg.norm(elsewhere) > 100 * np.linalg.norm(best)
    assert left_by_the_best_map(problem.T, problem.whiten, elsewhere) == pytest.approx(best, abs=1e-6)
    about = replace(problem, residual_nT=elsewhere, y=(problem.whiten @ elsewhere[:, :, None])[:, :, 0])
    rig = next(c.term for c in CandidateSet.of(problem, 0.85).candidates if c.family.id == "field-gradient")
    assert about.credible_share(rig) == pytest.approx(problem.credible_share(rig), rel=0.2)  # wild rows are others


def test_a_wild_row_does_not_decide_what_is_credible() -> None:
    residual = np.full((101, 3), 20.0)
    residual[50] = 1e6
    assert np.linalg.norm(without_wild_rows(residual)[50]) == pytest.approx(200.0 * np.sqrt(3))


def test_an_effect_that_the_last_fit_does_not_arrive_with_is_given_up(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows, segments = making.recorded(seconds=20.0)
    rows["dut"] = rows["dut"] + 300.0 * rows["i_load"][:, None] * np.array([1.0, -0.7, 0.5])
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    assert [effect.effect for effect in close_loop(run).accepted] == ["offset-current"]
    monkeypatch.setattr(final, "joint_fit", lambda problem, terms, rows: joint_fit(problem, [], rows))
    closed = close_loop(run)
    assert closed.accepted == ()
    assert closed.verdict == "unexplained"
    said = next(e.why for e in closed.rejected if e.effect == "offset-current")
    assert "fitted in full, map and effects together leave" in said


@pytest.mark.slow
def test_what_the_last_fit_gives_up_leaves_its_place_to_another_cause(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same load on a second meter, less sure: it is looked at again once no fit arrives with the first."""
    rows, segments = making.recorded(seconds=20.0)
    rows["other"] = rows["i_load"] + np.random.default_rng(4).normal(0, 0.05, len(rows["t_s"]))
    rows["dut"] = rows["dut"] + 300.0 * rows["i_load"][:, None] * np.array([1.0, -0.7, 0.5])
    channels = making.CHANNELS | {"other": making.CHANNELS["i_load"]}
    run = session.load_run(str(making.written(tmp_path, rows, segments, channels)))
    assert [effect.channels for effect in close_loop(run).accepted] == [("i_load",)]

    def arriving(problem: LinearProblem, terms: Sequence[Term], used: np.ndarray) -> JointFit:
        return joint_fit(problem, [] if any("i_load" in term.channels for term in terms) else terms, used)

    monkeypatch.setattr(final, "joint_fit", arriving)
    closed = close_loop(run)
    assert [(effect.effect, effect.channels) for effect in closed.accepted] == [("offset-current", ("other",))]
    said = next(e.why for e in closed.rejected if (e.effect, e.channels) == ("offset-current", ("i_load",)))
    assert "fitted in full, map and effects together leave" in said


@pytest.mark.slow
def test_of_two_effects_the_one_is_given_up_that_no_fit_arrives_with(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The stronger and first one, not whichever came last."""
    rows, segments = making.recorded()
    rows["dut"] = rows["dut"] + 600.0 * rows["i_load"][:, None] * np.array([1.0, -0.7, 0.5])
    rows["dut"] = rows["dut"] + 60.0 * (rows["temp"][:, None] - 20.0) * np.array([0.4, 1.0, -0.6])
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    assert [effect.channels for effect in close_loop(run).accepted] == [("i_load",), ("temp",)]

    def arriving(problem: LinearProblem, terms: Sequence[Term], used: np.ndarray) -> JointFit:
        return joint_fit(problem, [] if any("i_load" in term.channels for term in terms) else terms, used)

    monkeypatch.setattr(final, "joint_fit", arriving)
    said = {e.channels: e.why for e in close_loop(run).rejected if "fitted in full" in e.why}
    assert ("i_load",) in said
    assert ("temp",) not in said


def test_with_nothing_accepted_the_map_is_that_of_the_fit(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    rows["dut"] = rows["dut"] + _wander(rows)
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    closed, plain = close_loop(run), ml(run)
    assert closed.accepted == ()
    assert closed.verdict == "unexplained"
    assert plain.affine is not None
    assert np.allclose(closed.affine.k_nT, plain.affine.k_nT, atol=0.5)
    assert np.allclose(closed.affine.K, plain.affine.K, rtol=0, atol=1e-5)


@pytest.mark.parametrize(
    "name", [pytest.param("final-fit-1", marks=pytest.mark.slow), pytest.param("final-fit-2", marks=pytest.mark.slow)]
)
def test_after_is_what_the_accepted_effects_reach(shared: Path, name: str) -> None:
    """Two runs whose gradient took off what it took to first order only."""
    folder = shared / "data" / "defects" / name
    if not folder.exists():
        pytest.skip("needs the runs that show a defect")
    closed = close_loop(session.load_run(str(folder)))
    assert "field-gradient" not in [effect.effect for effect in closed.accepted]
    for effect in closed.accepted[-1:]:
        assert effect.holdout_rms_after_nT is not None
        assert closed.after.train_rms_nT <= POLICY.equivalent_rms * effect.holdout_rms_after_nT


def test_a_refit_states_the_units_of_its_effects_itself(making: ModuleType, tmp_path: Path) -> None:
    """Another version's file is compared with it: a unit that only came back as it was stated would show nothing."""
    rows, segments = making.recorded()
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    stated = tuple(Parameter(f"c_{axis}", 0.0, 0.0, "nT/mA") for axis in "xyz")
    again = refit(run, [EffectRecord("offset-current", ("i_load",), {"i_load": 0.0}, "sensor", stated)])
    assert [p.unit for p in again.effects[0].parameters] == ["nT/A"] * 3
