"""What the search looks at, and the map and rows it looks from, one by one, on a plain run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from labcal import session
from labcal.fit.vector.ml import estimate
from labcal.fit.vector.observations import AXIS
from labcal.geometry import rotate, rotation_vector
from labcal.loop import close_loop
from labcal.loop.candidates.changepoints import changepoints, explained_by_step
from labcal.loop.candidates.delay_scan import delay_scan
from labcal.loop.candidates.library import Candidate, Span
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.data.base_model import determined_by_geometry
from labcal.loop.data.decimate import decimate, rows_per_bin
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.autocorrelation import correlation_time_s, serially_correlated
from labcal.loop.noise.nuisance import orthogonal_complement, orthonormal, principal_span
from labcal.loop.selection.crossval import block_folds, cross_validate, fixed_choice, residual_lengths
from labcal.loop.selection.joint_fit import joint_fit
from labcal.loop.selection.misfit import likeliest
from labcal.loop.selection.proof import against_own_base, relinearised
from labcal.loop.selection.related import initial_state_columns
from labcal.loop.selection.stepwise import stepwise_forward
from labcal.model.effects import family, nonlinearity

Started = Callable[..., LinearProblem]


def _of_the_offset(pool: CandidateSet) -> list[Candidate]:
    return [step for step in changepoints(pool, ()) if step.family.id == "offset-step"]


def _search(problem: LinearProblem) -> CandidateSet:
    return CandidateSet.of(problem, 0.85)


def test_without_angles_and_with_attitudes_at_rest_the_frame_is_known(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    for segment in segments:
        del segment["body_from_cage"]
    rows["angle"] = np.full(len(rows["t_s"]), np.nan)
    attitude = Rotation.from_euler("xyz", [40, 10, 70], degrees=True).as_matrix()
    segments.append({"id": "rest", "kind": "static", "body_from_cage": attitude.tolist()})
    rest = {name: column[-60:].copy() for name, column in rows.items()}
    rest["t_s"] += 120.0
    rest["segment"] = np.full(60, "rest")
    rest["dut"] = 1.05 * rest["ref"] @ attitude.T + 800
    turned = Rotation.from_euler("xyz", [2, -1, 3], degrees=True).as_matrix()
    both = {name: np.concatenate([rows[name], rest[name]]) for name in rows}
    both["dut"] = both["dut"] @ turned.T
    problem, _, _ = prepare(session.load_run(str(making.written(tmp_path, both, segments))))
    assert (problem.observations.kind == AXIS).all()
    assert np.allclose(problem.affine.K, turned.T / 1.05, atol=1e-3)


def test_bins_keep_white_noise_and_never_span_two_segments(started: Started) -> None:
    problem = started(seconds=900.0)
    fewer = decimate(problem)
    assert fewer.bins is not None
    assert fewer.bins.count.max() == 2
    assert abs(np.std(fewer.y) / np.std(problem.y) - 1) < 0.03
    first, last = fewer.bins.start, fewer.bins.start + fewer.bins.count - 1
    assert np.array_equal(problem.scene.segment[first], problem.scene.segment[last])
    assert np.isclose(np.sum(fewer.y[:, 0] * np.sqrt(fewer.bins.count)), np.sum(problem.y[:, 0]))


def test_rows_are_not_binned_where_a_fast_line_would_be_lost(started: Started) -> None:
    fast = started(lambda rows: 30 * np.cos(2 * np.pi * 0.9 * rows["t_s"])[:, None] * np.ones(3), seconds=900.0)
    assert rows_per_bin(fast) == 1


def test_a_step_is_found_at_its_moment_and_its_drop_is_that_of_a_fit(started: Started) -> None:
    problem = started(lambda rows: 60.0 * (rows["t_s"] > 190.3)[:, None] * np.ones(3))
    pool = _search(problem)
    best = _of_the_offset(pool)[0]
    assert abs(best.term.at("t_step_s") - 190.3) < 1.0
    row = int(np.searchsorted(problem.scene.t_s, best.term.at("t_step_s")))
    fell = np.sum(pool.residual(()) ** 2) - np.sum(pool.residual([best]) ** 2)
    assert np.isclose(explained_by_step(pool, (), best.term)[row], fell, rtol=1e-6)


def test_a_step_may_be_taken_twice_at_two_moments(started: Started) -> None:
    def added(rows: dict[str, np.ndarray]) -> np.ndarray:
        t = rows["t_s"]
        return 60.0 * (t > 190.3)[:, None] * np.ones(3) + 90.0 * (t > 330.2)[:, None] * np.array([1.0, -1.0, 0.0])

    accepted, _ = stepwise_forward(_search(started(added)), 2)
    assert [c.family.id for c in accepted] == ["offset-step", "offset-step"]


def _levelled_on_a_tilted_platform(rows: dict[str, np.ndarray], segments: list[dict[str, Any]]) -> None:
    """Each body axis mounted along the cage's z at angle 0, in ± one field; the platform turns 0.4° off z."""
    platform = rotation_vector(np.radians([0.3, -0.25, 0.0])) @ [0.0, 0.0, 1.0]
    draw = np.random.default_rng(1)
    for number, segment in enumerate(segments):
        here = rows["segment"] == segment["id"]
        mounted = np.roll(np.eye(3), number % 3 - 2, axis=0)
        rows["ref"][here] = (1 if number < 3 else -1) * np.array([38300.0, 0.0, 32150.0])
        seen = rotate(platform, -rows["angle"][here], rows["ref"][here]) @ mounted.T
        rows["dut"][here] = 1.05 * seen + 800 + draw.normal(0, 20, seen.shape)
        stated = {"axis_body": mounted[:, 2].tolist(), "axis_cage": [0, 0, 1], "body_from_cage": mounted.tolist()}
        segment.update(stated)


def test_an_axis_tilted_under_a_levelled_device_is_one_cause(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    _levelled_on_a_tilted_platform(rows, segments)
    pool = _search(prepare(session.load_run(str(making.written(tmp_path, rows, segments))))[0])
    accepted, _ = stepwise_forward(pool)
    assert [c.family.id for c in accepted] == ["axis-tilt"]
    assert {name for name, _ in accepted[0].term.parameters} == {"spindle_x", "spindle_y"}
    assert np.sqrt(np.mean(pool.residual(accepted) ** 2)) < 1.1


def _switched(t_s: np.ndarray) -> np.ndarray:
    return (np.mod(t_s, 23.0) < 9.0)[:, None] * np.array([90.0, -60.0, 40.0])


@pytest.mark.parametrize("delay", [2.2, -1.7])
def test_a_load_that_acts_late_or_whose_clock_is_late_is_found_with_its_delay(
    making: ModuleType, tmp_path: Path, delay: float
) -> None:
    rows, segments = making.recorded()
    rows["i_load"] = np.mod(rows["t_s"], 23.0) < 9.0
    rows["dut"] = rows["dut"] + _switched(rows["t_s"] - delay)
    pool = _search(prepare(session.load_run(str(making.written(tmp_path, rows, segments))))[0])
    swept = next(c for c in delay_scan(pool, ()) if c.family.id == "offset-current")
    sums = [np.sum(pool.residual([Candidate(swept.family, swept.term.with_values(delay_s=d))]) ** 2)
            for d in swept.term.shape[0].grid]  # fmt: skip
    assert swept.term.at("delay_s") == swept.term.shape[0].grid[int(np.argmin(sums))]
    chosen = stepwise_forward(pool, most=1)[0][0]
    assert chosen.cause == ("offset-current", ("i_load",))
    assert chosen.term.at("delay_s") == pytest.approx(delay, abs=0.3)


def _wander(size_nT: float) -> Callable[[dict[str, np.ndarray]], np.ndarray]:
    def added(rows: dict[str, np.ndarray]) -> np.ndarray:
        steps_taken = np.random.default_rng(3).normal(0, size_nT, rows["dut"].shape)
        for row in range(1, len(steps_taken)):
            steps_taken[row] += np.exp(-0.5 / 5.0) * steps_taken[row - 1]
        return steps_taken

    return added


@pytest.mark.parametrize("size_nT", [0.0, 4.0])
def test_a_residual_that_is_all_but_white_does_not_follow_itself(started: Started, size_nT: float) -> None:
    """A wander of a tenth of the noise's square is certain, and less than a verdict passes over."""
    problem = started(_wander(size_nT))
    assert not serially_correlated(_search(problem).residual(()), problem.scene.segment)


def test_a_wandering_residual_follows_itself(started: Started) -> None:
    problem = started(_wander(20.0))
    left = _search(problem).residual(())
    assert serially_correlated(left, problem.scene.segment)
    assert 2.0 < correlation_time_s(problem.scene.t_s, left) < 10.0


def test_map_and_a_strong_bend_are_found_together(started: Started) -> None:
    t, level = 14000.0, 40000.0

    def bent(rows: dict[str, np.ndarray]) -> np.ndarray:
        noise = np.random.default_rng(5).normal(0, 20, rows["dut"].shape)  # as `recorded` drew it
        b = (rows["dut"] - noise - 800) / 1.05
        a = b.copy()
        for _ in range(100):
            a = b + t * (np.tanh(a / level) - a / level)
        return 1.05 * (a - b)

    problem = started(bent)
    term = next(f for f in nonlinearity.FAMILY.candidates(problem.run) if f.parameters[0][0] == "body_t1_x")
    found = joint_fit(problem, [term.with_values(s_nT=level)])
    assert found.beta[0] == pytest.approx(1.05 * np.full(3, t), rel=0.02)  # along the axes of K
    assert np.sqrt(np.mean(found.problem.residual_nT**2)) == pytest.approx(20 / 1.05, rel=0.05)


def test_looks_that_are_nought_in_every_row_span_nothing_and_add_nothing() -> None:
    nought = principal_span(np.zeros((5, 3, 4)))
    assert nought.shape == principal_span(np.zeros((5, 3, 0))).shape == (5, 3, 0)
    assert orthogonal_complement(np.ones((5, 3, 1)), nought).shape == (5, 3, 0)
    some = np.random.default_rng(1).normal(size=(5, 3, 2))
    part = np.concatenate([some[:, :, 1:], np.zeros((5, 3, 1))], axis=2)
    standing = orthonormal(np.concatenate([some[:, :, :1], np.zeros((5, 3, 1))], axis=2))
    assert standing.shape == orthogonal_complement(standing, part).shape == (5, 3, 1)
    assert np.sum(standing * orthogonal_complement(standing, part)) == pytest.approx(0.0, abs=1e-12)


def test_a_form_that_is_in_the_base_whole_has_nothing_to_miss() -> None:
    model: Any = SimpleNamespace(null=SimpleNamespace(log=3.0))
    assert likeliest(model, [Span(np.zeros((5, 3, 0)))]) == 3.0


def test_a_field_that_turns_the_phases_far_leaves_nothing_for_other_names(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded(seconds=30.0)
    for segment in segments:
        del segment["body_from_cage"]
    rows["ref"] = rows["ref"] + np.array([1500.0, -1100.0, 900.0])
    bare = _search(prepare(session.load_run(str(making.written(tmp_path, rows, segments))))[0])
    pool = relinearised(bare)
    left = []
    for here in (bare, pool):
        standing = next(c for c in here.candidates if c.family.id == "cage-field" and c.size == 3)
        left.append(float(np.mean(here.residual([standing]) ** 2)))
    assert left[0] > 1.5
    assert left[1] < 1.1
    assert [c.family.id for c in stepwise_forward(pool)[0]] == ["cage-field"]


def test_before_stands_the_bases_own_held_out_error_on_the_rows_that_were_not_set_aside(started: Started) -> None:
    bare = _search(started(seconds=30.0))
    moved = replace(bare.problem, y=0.9 * bare.problem.y)  # as the base seems about another map
    pool = _search(moved).without_rows(np.arange(len(moved)) % 50 == 7)
    blocks = block_folds(pool.problem, 0.0)
    told = against_own_base(bare, pool, blocks, cross_validate(pool, blocks, fixed_choice(())))
    seen, problem = blocks.training(bare.problem.scene.t_s, 0) & pool.valid, bare.problem
    x = np.linalg.lstsq(problem.T[seen].reshape(3 * seen.sum(), -1), problem.y[seen].ravel(), rcond=None)[0]
    left = residual_lengths(problem, problem.y - problem.T @ x, np.ones(len(problem), dtype=bool))
    asked = (blocks.fold == 0) & pool.valid
    assert np.allclose(told.before_nT[asked[told.rows]], left[asked], rtol=1e-6)
    assert len(told.before_nT) == len(told.after_nT) == pool.valid.sum()


def test_where_an_effect_is_settled_the_base_has_not_its_shape(started: Started) -> None:
    strong = started(lambda rows: rows["i_load"][:, None] * np.array([1500.0, -900.0, 600.0]))
    load = next(f for f in family("offset-current").candidates(strong.run) if not f.shape)
    pool = _search(joint_fit(strong, [load]).uncorrected())
    found = {w.candidate.family.id: w.evidence for w in pool.rank(pool.candidates)}
    assert found["offset-current"] > 1000
    assert max(found["field-gradient"], found["axis-tilt"]) < 12.0


def test_a_turn_common_to_all_mountings_is_fixed_at_zero(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded(seconds=60.0)
    for segment in segments:
        del segment["body_from_cage"]
    tilted = np.char.startswith(rows["segment"].astype(str), "x")
    turned = Rotation.from_euler("y", 1.5, degrees=True).as_matrix()
    rows["dut"][tilted] = (rows["dut"][tilted] - 800) @ turned.T + 800
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    term = next(f for f in family("axis-tilt").candidates(run) if f.parameters[0][0].startswith("body_"))
    (found,) = joint_fit(prepare(run)[0], [term]).parameters()
    about_y = [p for p in found if p.name.endswith("y")]
    assert np.ptp([p.value for p in about_y]) == pytest.approx(1.5, abs=0.02)
    assert max(p.value for p in about_y) == pytest.approx(0.75, abs=0.1)  # half, but for the lengths of the columns
    assert max(p.u for p in found) < 0.02


def test_at_rest_no_loop_is_looked_for(making: ModuleType, tmp_path: Path) -> None:
    """It would be driven by the reference's own noise, and take that off the residual."""
    rows, segments = making.recorded(seconds=10.0)
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    still = np.stack([run.reading[run.rows(k)[0]] for k in run.segment_index])
    draw = np.random.default_rng(4).normal(0, 20, still.shape)
    at_rest = family("hysteresis").candidates(replace(run, reading=still + draw))
    assert {shape.name for term in at_rest for shape in term.shape} <= {"r_nT", "kept", "lon_deg", "lat_deg"}
    assert len(at_rest) < len(family("hysteresis").candidates(run))


def test_the_unknown_start_of_a_slow_response_is_no_drift(searching: Callable[..., CandidateSet]) -> None:
    t = searching({}, {}).problem.scene.t_s
    pool = searching({"T": 20 + 6 * np.sin(t / 40.0)}, {"T": "temperature"})
    slow = next(c for c in pool.candidates if c.family.id == "offset-temperature" and c.term.shape)
    settling = next(
        c for c in pool.candidates if c.family.id == "offset-drift" and any(s.name == "tau_s" for s in c.term.shape)
    )
    for tau_s, new in ((40.0, 0), (150.0, 3)):
        warm, dying = (replace(c, term=c.term.with_values(tau_s=at)) for c, at in ((slow, 40.0), (settling, tau_s)))
        null_model = pool.null_model([warm], initial_state_columns(pool, warm))
        assert pool.score(dying, null_model).rank == new


def test_a_strong_effect_is_no_lack_of_excitation(making: ModuleType, tmp_path: Path) -> None:
    def known(axes: str, gain: float) -> tuple[float, float]:
        rows, segments = making.recorded(axes=axes)
        rows["dut"] = rows["dut"] * (1 + gain * np.outer(np.sin(rows["t_s"] / 90), [1.0, -0.6, -2.0]))
        found = estimate(session.load_run(str(making.written(tmp_path, rows, segments))), as_scalar=True)
        return found.identified.worst_u_nT, determined_by_geometry(found).worst_u_nT

    quiet, strong = known("xy", 0.0), known("xy", 0.02)
    assert quiet[1] == pytest.approx(quiet[0], rel=0.05)
    assert strong[1] == pytest.approx(quiet[0], rel=0.05)
    assert strong[0] > 5 * quiet[0]
    assert np.isinf(known("x", 0.0)[1])


@pytest.mark.slow
def test_the_name_of_a_field_that_turns_the_phases_far_is_the_small_one(making: ModuleType, tmp_path: Path) -> None:
    """The series of finite coil pairs holds what the phases are turned by as well, with 35 parameters for 3."""
    rows, segments = making.recorded(seconds=30.0)
    for segment in segments:
        del segment["body_from_cage"]
    rows["ref"] = rows["ref"] + np.array([1500.0, -1100.0, 900.0])
    found = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert [one.effect for one in found.accepted] == ["cage-field"]
    assert len(found.accepted[0].parameters) == 3
