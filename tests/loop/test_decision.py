"""The rules of the search and of the decision, one by one, on a plain run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from labcal import session
from labcal.fit.ml import estimate
from labcal.fit.observations import AXIS
from labcal.geometry import rotate, rotation_vector
from labcal.loop import close_loop, decide, evidence, working_range
from labcal.loop.bins import binned, rows_in_a_bin
from labcal.loop.close import _as_shipped, prepared
from labcal.loop.correlation import correlation_s, follows_itself
from labcal.loop.decide import earned, forward, refined
from labcal.loop.delays import delays
from labcal.loop.evidence import decided, search_of, weighed
from labcal.loop.floor import Floor
from labcal.loop.holdout import HeldOut, held_out, plan
from labcal.loop.problem import Problem, _by_geometry
from labcal.loop.refit import refit
from labcal.loop.search import Candidate, Search, Weighed, new_to
from labcal.loop.spectrum import Likelihood
from labcal.loop.steps import drops, steps
from labcal.loop.surrogates import p_value
from labcal.model.effects import family, nonlinearity
from labcal.model.effects.hysteresis import dahl
from labcal.model.effects.regressors import low_passed

Started = Callable[..., Problem]
Added = Callable[[dict[str, np.ndarray]], np.ndarray]
LEVEL = Floor(100.0, "declared", None)


@pytest.fixture
def started(making: ModuleType, tmp_path: Path) -> Started:
    """The base fitted to a plain run with something added to its readings."""

    def make(added: Added = lambda rows: np.zeros(3), seconds: float = 45.0) -> Problem:
        rows, segments = making.recorded(seconds=seconds)
        rows["dut"] = rows["dut"] + added(rows)
        return prepared(session.load_run(str(making.written(tmp_path, rows, segments))))[0]

    return make


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
    problem, _, _ = prepared(session.load_run(str(making.written(tmp_path, both, segments))))
    assert (problem.seen.kind == AXIS).all()
    assert np.allclose(problem.affine.K, turned.T / 1.05, atol=1e-3)


def _of_the_offset(search: Search) -> list[Candidate]:
    return [step for step in steps(search, ()) if step.family.id == "offset-step"]


def _search(problem: Problem) -> Search:
    return search_of(problem, 0.85)


def _held(before: float, after: float) -> HeldOut:
    rows = np.ones(40)
    return HeldOut(np.arange(40), before * rows, after * rows)


def test_bins_keep_white_noise_and_never_span_two_segments(started: Started) -> None:
    problem = started(seconds=900.0)
    fewer = binned(problem)
    assert fewer.bins is not None
    assert fewer.bins.count.max() == 2
    assert abs(np.std(fewer.y) / np.std(problem.y) - 1) < 0.03
    first, last = fewer.bins.start, fewer.bins.start + fewer.bins.count - 1
    assert np.array_equal(problem.scene.segment[first], problem.scene.segment[last])
    assert np.isclose(np.sum(fewer.y[:, 0] * np.sqrt(fewer.bins.count)), np.sum(problem.y[:, 0]))


def test_rows_are_not_binned_where_a_fast_line_would_be_lost(started: Started) -> None:
    fast = started(lambda rows: 30 * np.cos(2 * np.pi * 0.9 * rows["t_s"])[:, None] * np.ones(3), seconds=900.0)
    assert rows_in_a_bin(fast) == 1


def test_a_step_is_found_at_its_moment_and_its_drop_is_that_of_a_fit(started: Started) -> None:
    problem = started(lambda rows: 60.0 * (rows["t_s"] > 190.3)[:, None] * np.ones(3))
    search = _search(problem)
    best = _of_the_offset(search)[0]
    assert abs(best.form.at("t_step_s") - 190.3) < 1.0
    row = int(np.searchsorted(problem.scene.t_s, best.form.at("t_step_s")))
    fell = np.sum(search.residual(()) ** 2) - np.sum(search.residual([best]) ** 2)
    assert np.isclose(drops(search, (), best.form)[row], fell, rtol=1e-6)


def test_a_block_that_hides_the_moment_of_a_step_does_not_count_against_it(started: Started) -> None:
    """Only the rows among which the step lies are left out, of before and after alike."""
    search = _search(started(lambda rows: 300.0 * (rows["t_s"] > 200.0)[:, None] * np.array([1.0, -0.7, 0.5])))
    blocks = plan(search.problem, 0.0)
    honest = held_out(search, blocks, lambda part: _of_the_offset(part)[:1])
    hidden = len(search.problem) - len(honest.after_nT)
    assert 0 < hidden <= np.bincount(blocks.block).max() + 2
    assert honest.after < 1.1 * np.sqrt(3) * 20.0 / 1.05  # the readings' own noise
    assert honest.before > 4 * honest.after


def test_what_lies_in_a_held_out_fold_moves_no_choice_and_no_proof(started: Started) -> None:
    """The choice made again without a fold takes its proofs, too, from the other rows alone."""
    problem = started(lambda rows: 150.0 * rows["i_load"][:, None] * np.array([1.0, -0.7, 0.5]))
    blocks = plan(problem, 0.0)
    spoiled = replace(problem, y=np.where((blocks.fold == 0)[:, None], 1e3, problem.y))
    parts = [_search(p).on(blocks.training(problem.scene.t_s, 0)) for p in (problem, spoiled)]
    one, other = (decided(part, LEVEL, blocks.among(part.rows)) for part in parts)
    assert [c.cause for c in one.accepted] == [("offset-current", ("i_load",))] == [c.cause for c in other.accepted]
    assert one.steps[0].after == other.steps[0].after
    assert len(one.steps[0].after_nT) == parts[0].rows.sum()


def test_a_newcomer_that_does_not_stand_takes_nothing_with_it(
    started: Started, monkeypatch: pytest.MonkeyPatch
) -> None:
    def added(rows: dict[str, np.ndarray]) -> np.ndarray:
        return (300.0 * rows["i_load"] + 60.0 * (rows["temp"] - 20))[:, None] * np.array([1.0, -0.7, 0.5])

    search = _search(started(added))
    both = {c.cause for c in forward(search)[0]}
    assert both == {("offset-current", ("i_load",)), ("offset-temperature", ("temp",))}
    monkeypatch.setattr(decide, "reexamined", lambda search, accepted: accepted if len(accepted) == 1 else [])
    assert len(forward(search)[0]) == 1


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
    search = _search(prepared(session.load_run(str(making.written(tmp_path, rows, segments))))[0])
    accepted, _ = forward(search)
    assert [c.family.id for c in accepted] == ["axis-tilt"]
    assert {name.partition("_")[0] for name, _ in accepted[0].form.parameters} == {"cage", "body"}
    assert np.sqrt(np.mean(search.residual(accepted) ** 2)) < 1.1


def _switched(t_s: np.ndarray) -> np.ndarray:
    return (np.mod(t_s, 23.0) < 9.0)[:, None] * np.array([90.0, -60.0, 40.0])


@pytest.mark.parametrize("delay", [2.2, -1.7])
def test_a_load_that_acts_late_or_whose_clock_is_late_is_found_with_its_delay(
    making: ModuleType, tmp_path: Path, delay: float
) -> None:
    rows, segments = making.recorded()
    rows["i_load"] = np.mod(rows["t_s"], 23.0) < 9.0
    rows["dut"] = rows["dut"] + _switched(rows["t_s"] - delay)
    search = _search(prepared(session.load_run(str(making.written(tmp_path, rows, segments))))[0])
    swept = next(c for c in delays(search, ()) if c.family.id == "offset-current")
    sums = [np.sum(search.residual([Candidate(swept.family, swept.form.reshaped(delay_s=d))]) ** 2)
            for d in swept.form.shape[0].grid]  # fmt: skip
    assert swept.form.at("delay_s") == swept.form.shape[0].grid[int(np.argmin(sums))]
    chosen = forward(search, most=1)[0][0]
    assert chosen.cause == ("offset-current", ("i_load",))
    assert chosen.form.at("delay_s") == pytest.approx(delay, abs=0.3)


def test_a_white_residual_does_not_follow_itself_and_a_wandering_one_does(started: Started) -> None:
    assert not follows_itself(_search(started()), ())
    draw = np.random.default_rng(3)

    def wander(rows: dict[str, np.ndarray]) -> np.ndarray:
        steps_taken = draw.normal(0, 20, rows["dut"].shape)
        for row in range(1, len(steps_taken)):
            steps_taken[row] += np.exp(-0.5 / 5.0) * steps_taken[row - 1]
        return steps_taken

    search = _search(started(wander))
    assert follows_itself(search, ())
    assert 2.0 < correlation_s(search, ()) < 10.0


@pytest.mark.parametrize(("after", "earns"), [(195.0, False), (150.0, True)])
def test_a_second_effect_brings_a_quarter_of_the_noises_square_at_least(after: float, earns: bool) -> None:
    assert evidence._adds([_held(1000, 200), _held(200, after)], LEVEL) is earns


@pytest.mark.parametrize(("after", "too_much"), [(110.0, False), (180.0, False), (250.0, True)])
def test_what_leaves_more_than_its_share_is_no_drift(after: float, too_much: bool) -> None:
    assert evidence._remains([_held(1000, after)], LEVEL, evidence.REMAINS) is too_much


@pytest.mark.parametrize(("after", "misfit"), [(130.0, False), (180.0, True)])
def test_a_later_cause_that_leaves_a_third_of_what_it_took_is_misfit_of_the_first(after: float, misfit: bool) -> None:
    assert evidence._remains([_held(250, after)], LEVEL, evidence.REST) is misfit


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
    form = next(f for f in nonlinearity.FAMILY.candidates(problem.run) if f.parameters[0][0] == "body_t1_x")
    found = refit(problem, [form.reshaped(s_nT=level)])
    assert found.beta[0] == pytest.approx(1.05 * np.full(3, t), rel=0.02)  # along the axes of K
    assert np.sqrt(np.mean(found.problem.residual_nT**2)) == pytest.approx(20 / 1.05, rel=0.05)


def test_a_file_that_leaves_more_than_was_foretold_says_so() -> None:
    assert _as_shipped(_held(300.0, 50.0), 80.0).after == pytest.approx(80.0)
    assert _as_shipped(_held(300.0, 50.0), 45.0).after == pytest.approx(50.0)


@pytest.mark.parametrize(("drifts", "name"), [(0.0, "cage-field"), (2.0, "reference-drift")])
def test_a_field_that_stands_is_no_drift_though_a_drift_contains_it(started: Started, drifts: float, name: str) -> None:
    field = np.array([420.0, -260.0, 510.0])

    def missed(rows: dict[str, np.ndarray]) -> float:
        rows["ref"] = rows["ref"] + (1 + drifts * rows["t_s"][:, None] / 500.0) * field
        return 0.0

    search = _search(started(missed))
    weighed_alone = {w.candidate.family.id: w for w in search.rank(search.candidates)}
    assert earned(search, (), weighed_alone["reference-drift"]) is (drifts > 0)
    assert [c.family.id for c in forward(search, most=1)[0]] == [name]


@pytest.mark.parametrize("told", [True, False], ids=["a channel tells", "nothing tells"])
def test_what_comes_with_the_motor_or_at_a_moment_is_the_cages_field_and_no_offset(
    making: ModuleType, tmp_path: Path, told: bool
) -> None:
    rows, segments = making.recorded()
    on = (np.mod(rows["t_s"], 31.0) < 12.0) if told else rows["t_s"] > 190.3
    rows["ref"] = rows["ref"] + on[:, None] * np.array([40.0, -90.0, 60.0])
    rows["motor_on"] = on.astype(float)
    motor = {"motor_on": {"unit": "1", "quantity": "other", "role": "platform"}}
    path = making.written(tmp_path, rows, segments, making.CHANNELS | (motor if told else {}))
    (chosen,) = forward(_search(prepared(session.load_run(str(path)))[0]))[0]
    assert chosen.cause == ("cage-field", ("motor_on",) if told else ())
    assert chosen.form.parameters[0][0] == ("q_x" if told else "step_x")


def test_causes_that_push_each_other_out_come_to_an_end(started: Started, monkeypatch: pytest.MonkeyPatch) -> None:
    every = _search(started())
    few = [c for c in every.candidates if c.family.id in ("cross-field", "offset-drift") and not c.form.shape[1:]]
    monkeypatch.setattr(decide, "reexamined", lambda search, accepted: accepted[-1:])
    monkeypatch.setattr(decide, "_best", lambda search, accepted, ranking, total: ranking[0] if ranking else None)
    assert len(forward(every.among(few))[0]) <= 1


def test_looks_that_are_nought_in_every_row_span_nothing_and_add_nothing() -> None:
    nought = decide.spanning(np.zeros((5, 3, 4)))
    assert nought.shape == (5, 3, 0)
    assert new_to(np.ones((5, 3, 1)), nought).shape == (5, 3, 0)


def test_a_field_that_turns_the_phases_far_leaves_nothing_for_other_names(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded(seconds=30.0)
    for segment in segments:
        del segment["body_from_cage"]
    rows["ref"] = rows["ref"] + np.array([1500.0, -1100.0, 900.0])
    bare = _search(prepared(session.load_run(str(making.written(tmp_path, rows, segments))))[0])
    search = evidence.settled(bare)
    left = []
    for here in (bare, search):
        standing = next(c for c in here.candidates if c.family.id == "cage-field" and c.size == 3)
        left.append(float(np.mean(here.residual([standing]) ** 2)))
    assert left[0] > 1.5
    assert left[1] < 1.1
    assert [c.family.id for c in forward(search)[0]] == ["cage-field"]


def test_where_an_effect_is_settled_the_base_has_not_its_shape(started: Started) -> None:
    strong = started(lambda rows: rows["i_load"][:, None] * np.array([1500.0, -900.0, 600.0]))
    load = next(f for f in family("offset-current").candidates(strong.run) if not f.shape)
    search = _search(refit(strong, [load]).uncorrected())
    found = {w.candidate.family.id: w.weight for w in search.rank(search.candidates)}
    assert found["offset-current"] > 1000
    assert max(found["field-gradient"], found["axis-tilt"]) < 12.0


def test_a_random_walk_is_given_no_name(started: Started) -> None:
    walk = np.random.default_rng(8).normal(0, 25, (540, 3)).cumsum(axis=0)
    search = _search(started(lambda rows: walk))
    assert [c.family.id for c in weighed(search, Floor(36.0, "declared", None)).accepted] == []


def test_a_current_is_named_in_its_simplest_look_and_chance_would_not_do_it(started: Started) -> None:
    problem = started(lambda rows: rows["i_load"][:, None] * np.array([90.0, -60.0, 40.0]))
    loaded = weighed(_search(problem), Floor(36.0, "declared", None))
    assert [(c.cause, len(c.form.parameters), c.form.shape) for c in loaded.accepted] == [
        (("offset-current", ("i_load",)), 3, ())
    ]
    assert p_value(loaded.rankings[0][0], loaded.heaviest) < 1e-6
    assert p_value(loaded.rankings[-1][0], loaded.heaviest) > 0.01


def test_the_tail_of_an_exponential_is_its_own(started: Started) -> None:
    heaviest = np.sort(np.random.default_rng(2).exponential(2.0, 4000))
    candidate = _search(started()).candidates[0]
    far = Weighed(candidate, 0.0, 20.0, 0.0, 1, Likelihood(0.0, 1.0, 0, 1.0))
    assert 0.6 < p_value(far, heaviest) / np.exp(-20.0 / 2.0) < 1.6


def test_the_heat_of_a_load_follows_the_square_of_its_current_slowly(searching: Callable[..., Search]) -> None:
    t = searching({}, {}).problem.scene.t_s
    amps = np.random.default_rng(3).uniform(0, 2, 40)[(t // 17).astype(int)]
    tau_s = 12.0
    lit = np.arange(0, t[-1] + 1, 0.05)
    squared = np.interp(lit, t, amps) ** 2
    heat = np.zeros(len(lit))
    for i in range(1, len(lit)):
        heat[i] = heat[i - 1] + 0.05 / tau_s * (squared[i] - heat[i - 1])
    added = np.outer(np.interp(t, lit, heat), [30.0, -20.0, 10.0])
    (found,) = forward(searching({"i": amps}, {"i": "current"}, added))[0]
    assert found.cause == ("offset-current-squared", ("i",))
    assert found.form.at("tau_s") == pytest.approx(tau_s, rel=0.15)


@pytest.mark.parametrize("tau_s", [None, 14.0])
def test_of_a_load_with_two_levels_the_current_itself_goes_before_its_square(
    searching: Callable[..., Search], tau_s: float | None
) -> None:
    t = searching({}, {}).problem.scene.t_s
    amps = 0.1 + 0.8 * (np.mod(t, 41.0) < 17.0)
    acts = amps if tau_s is None else low_passed(t, np.zeros(len(t), dtype=np.intp), amps, tau_s)
    search = searching({"i": amps}, {"i": "current"}, np.outer(acts, [80.0, -50.0, 30.0]))
    square = next(c for c in search.candidates if c.family.second_order and bool(c.form.shape) == bool(tau_s))
    (first,) = evidence._preferred(search, plan(search.problem, 0.0), [refined(search, square, [])], ())
    assert first.cause == ("offset-current", ("i",))


def test_a_map_is_shipped_as_it_is_without_the_effects_that_are_not(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows, segments = making.recorded(seconds=20.0)
    rows["dut"] = rows["dut"] + np.outer(rows["i_load"], [90.0, -60.0, 30.0])
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    monkeypatch.setattr(working_range, "unsupported", lambda run, accepted, after: frozenset({0}))
    found = close_loop(run)
    assert found.accepted
    assert found.fit().effects == ()
    assert np.allclose(found.affine.k_nT, refit(prepared(run)[0], []).problem.affine.k_nT, atol=0.1)
    assert found.metrics()["after"]["holdout_rms_nT"] > 1.2 * found.after.holdout_rms_nT


def test_a_slow_wave_is_a_drift_and_no_smooth_channels(searching: Callable[..., Search]) -> None:
    t = searching({}, {}).problem.scene.t_s
    turn = 2 * np.pi * (t - t[0]) / np.ptp(t)
    panel = np.clip(np.sin(1.1 * turn + 1), 0, None)
    search = searching({"i": panel}, {"i": "current"}, np.outer(np.sin(0.9 * turn + 0.4), [250.0, -120.0, 60.0]))
    assert [c.cause for c in forward(search)[0]] == [("offset-drift", ())]


def test_a_turn_common_to_all_mountings_is_fixed_at_zero(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded(seconds=60.0)
    for segment in segments:
        del segment["body_from_cage"]
    tilted = np.char.startswith(rows["segment"].astype(str), "x")
    turned = Rotation.from_euler("y", 1.5, degrees=True).as_matrix()
    rows["dut"][tilted] = (rows["dut"][tilted] - 800) @ turned.T + 800
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    form = next(f for f in family("axis-tilt").candidates(run) if f.parameters[0][0].startswith("body_"))
    (found,) = refit(prepared(run)[0], [form]).parameters()
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
    assert {shape.name for form in at_rest for shape in form.shape} <= {"r_nT", "kept", "lon_deg", "lat_deg"}
    assert len(at_rest) < len(family("hysteresis").candidates(run))


def _found(candidate: Candidate, gain: float) -> Weighed:
    return Weighed(candidate, gain, 0.0, 0.0, len(candidate.form.parameters), Likelihood(0.0, 1.0, 0, 1.0))


@pytest.mark.parametrize(("gain", "near"), [(60.0, True), (600.0, False)])
def test_a_weak_effect_of_few_parameters_has_a_rival_of_more_that_does_as_well(
    started: Started, gain: float, near: bool
) -> None:
    """Of a strong one, twelve parameters that fall into place are no accident."""
    candidates = _search(started()).candidates
    warm = next(c for c in candidates if c.family.id == "offset-temperature" and c.size == 3)
    drift = next(c for c in candidates if c.family.id == "offset-drift" and c.size == 15)
    found = evidence._near([_found(warm, gain), _found(drift, gain + 12.0)], warm, ())
    assert (drift in [w.candidate for w in found]) is near


def test_a_loop_more_likely_than_not_is_the_rival_of_its_curve(searching: Callable[..., Search]) -> None:
    rows = searching({}, {}).problem
    s = rows.scene.rig.prediction_nT / 5e4
    curved = searching({}, {}, 150.0 * s**3)
    (curve,) = forward(curved)[0]
    assert curve.family.id == "nonlinearity"
    assert evidence._larger(curved, [curve], curve) == []
    loop = dahl(5e4 * s, 4000.0)
    looped = searching({}, {}, 150.0 * s**3 + 5.0 * loop)
    (rival,) = evidence._larger(looped, [curve], curve)
    assert rival.candidate.family.id == "hysteresis"


def test_the_unknown_start_of_a_slow_response_is_no_drift(searching: Callable[..., Search]) -> None:
    t = searching({}, {}).problem.scene.t_s
    search = searching({"T": 20 + 6 * np.sin(t / 40.0)}, {"T": "temperature"})
    slow = next(c for c in search.candidates if c.family.id == "offset-temperature" and c.form.shape)
    settling = next(c for c in search.candidates if c.family.id == "offset-drift" and len(c.form.shape) == 2)
    for tau_s, new in ((40.0, 0), (150.0, 3)):
        warm, dying = (replace(c, form=c.form.reshaped(tau_s=at)) for c, at in ((slow, 40.0), (settling, tau_s)))
        stage = search.stage([warm], decide._starts(search, warm))
        assert search.weigh(dying, stage).rank == new


def test_a_strong_effect_is_no_lack_of_excitation(making: ModuleType, tmp_path: Path) -> None:
    def known(axes: str, gain: float) -> tuple[float, float]:
        rows, segments = making.recorded(axes=axes)
        rows["dut"] = rows["dut"] * (1 + gain * np.outer(np.sin(rows["t_s"] / 90), [1.0, -0.6, -2.0]))
        found = estimate(session.load_run(str(making.written(tmp_path, rows, segments))), as_scalar=True)
        return found.identified.worst_u_nT, _by_geometry(found).worst_u_nT

    quiet, strong = known("xy", 0.0), known("xy", 0.02)
    assert quiet[1] == pytest.approx(quiet[0], rel=0.05)
    assert strong[1] == pytest.approx(quiet[0], rel=0.05)
    assert strong[0] > 5 * quiet[0]
    assert np.isinf(known("x", 0.0)[1])
