"""The rules of the decision, one by one, on a plain run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import close_loop
from labcal.loop.assemble import ROUNDS_EXHAUSTED, as_shipped
from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.changepoints import changepoints
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.close import prepare
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.findings import working_range
from labcal.loop.noise.coloured import Likelihood
from labcal.loop.policy import POLICY
from labcal.loop.selection import equivalents as rivals
from labcal.loop.selection import heldout_rules, related, stepwise
from labcal.loop.selection.admission import earns_its_extension
from labcal.loop.selection.crossval import HeldOutErrors, block_folds, cross_validate
from labcal.loop.selection.joint_fit import joint_fit
from labcal.loop.selection.proof import select_and_prove
from labcal.loop.selection.select import prefer_computable, select
from labcal.loop.selection.stepwise import stepwise_forward
from labcal.loop.selection.surrogates import p_value
from labcal.model.effects.hysteresis import dahl
from labcal.model.effects.regressors import low_passed

Started = Callable[..., LinearProblem]
LEVEL = NoiseFloor(100.0, "declared", None)


def _of_the_offset(pool: CandidateSet) -> list[Candidate]:
    return [step for step in changepoints(pool, ()) if step.family.id == "offset-step"]


def _search(problem: LinearProblem) -> CandidateSet:
    return CandidateSet.of(problem, 0.85)


def _held(before: float, after: float) -> HeldOutErrors:
    rows = np.ones(40)
    return HeldOutErrors(np.arange(40), before * rows, after * rows, rows > 0)


def test_a_block_that_hides_the_moment_of_a_step_does_not_count_against_it(started: Started) -> None:
    """Only the rows among which the step lies are left out, of before and after alike."""
    pool = _search(started(lambda rows: 300.0 * (rows["t_s"] > 200.0)[:, None] * np.array([1.0, -0.7, 0.5])))
    blocks = block_folds(pool.problem, 0.0)
    cv_error = cross_validate(pool, blocks, lambda part: _of_the_offset(part)[:1])
    hidden = len(pool.problem) - len(cv_error.after_nT)
    assert 0 < hidden <= np.bincount(blocks.block).max() + 2
    assert cv_error.after < 1.1 * np.sqrt(3) * 20.0 / 1.05  # the readings' own noise
    assert cv_error.before > 4 * cv_error.after


def test_what_lies_in_a_held_out_fold_moves_no_choice_and_no_proof(started: Started) -> None:
    """The choice made again without a fold takes its proofs, too, from the other rows alone."""
    problem = started(lambda rows: 150.0 * rows["i_load"][:, None] * np.array([1.0, -0.7, 0.5]))
    blocks = block_folds(problem, 0.0)
    spoiled = replace(problem, y=np.where((blocks.fold == 0)[:, None], 1e3, problem.y))
    parts = [_search(p).on(blocks.training(problem.scene.t_s, 0)) for p in (problem, spoiled)]
    one, other = (select(part, LEVEL, blocks.restricted_to(part.rows)) for part in parts)
    assert [c.cause for c in one.accepted] == [("offset-current", ("i_load",))] == [c.cause for c in other.accepted]
    assert one.contributions[0].after == other.contributions[0].after
    assert len(one.contributions[0].after_nT) == parts[0].rows.sum()


def test_a_newcomer_that_does_not_stand_takes_nothing_with_it(
    started: Started, monkeypatch: pytest.MonkeyPatch
) -> None:
    def added(rows: dict[str, np.ndarray]) -> np.ndarray:
        return (300.0 * rows["i_load"] + 60.0 * (rows["temp"] - 20))[:, None] * np.array([1.0, -0.7, 0.5])

    pool = _search(started(added))
    both = {c.cause for c in stepwise_forward(pool)[0]}
    assert both == {("offset-current", ("i_load",)), ("offset-temperature", ("temp",))}
    monkeypatch.setattr(stepwise, "backward_check", lambda pool, accepted: accepted if len(accepted) == 1 else [])
    assert len(stepwise_forward(pool)[0]) == 1


@pytest.mark.parametrize(("after", "earns"), [(195.0, False), (193.0, True)])
def test_a_second_effect_brings_a_quarter_of_the_noises_square_at_least(after: float, earns: bool) -> None:
    assert heldout_rules.is_more_than_detail([_held(1000, 200), _held(200, after)], LEVEL) is earns


@pytest.mark.parametrize(("after", "too_much"), [(110.0, False), (180.0, False), (210.0, True)])
def test_what_leaves_more_than_its_share_is_no_drift(after: float, too_much: bool) -> None:
    assert heldout_rules.misfit_remains([_held(1000, after)], LEVEL, POLICY.material_share) is too_much


@pytest.mark.parametrize(("after", "misfit"), [(145.0, False), (158.0, True)])
def test_a_later_cause_that_leaves_a_third_of_what_it_took_is_misfit_of_the_first(after: float, misfit: bool) -> None:
    assert heldout_rules.misfit_remains([_held(250, after)], LEVEL, POLICY.max_misfit_of_later) is misfit


@pytest.mark.parametrize(("left", "idle"), [((420.0, 320.0, 240.0), None), ((420.0, 380.0, 350.0), 2)])
def test_the_harmonics_of_one_wave_are_judged_by_what_they_take_together(
    started: Started, left: tuple[float, ...], idle: int | None
) -> None:
    """The third of a square wave's lines takes less than is left after it; all three leave less than a tenth."""
    pool = _search(started())
    line = next(c for c in all_candidates(pool, []) if c.family.id == "periodic")
    falls = [_held(before, after) for before, after in zip((800.0, *left), left, strict=False)]
    assert heldout_rules.first_unsupported(pool, [replace(line) for _ in falls], falls, LEVEL) == idle


@pytest.mark.parametrize(("reached", "told"), [(300.0, 1), (110.0, 2)])
def test_where_the_noise_is_missed_a_name_that_most_others_could_take_is_not_told(
    started: Started, reached: float, told: int
) -> None:
    pool = _search(started())
    accepted = [next(c for c in pool.candidates if c.term.channels == ("i_load",))] * 2
    equivalent = rivals.Equivalent(_found(accepted[0], 50.0), reached)
    standing_in = [(equivalent,) * 2, (equivalent,) * 4]
    assert heldout_rules.n_reportable(pool, _held(2000, reached), LEVEL, accepted, standing_in) == told
    assert heldout_rules.n_reportable(pool, _held(2000, reached), LEVEL, accepted, [(equivalent,) * 3] * 2) == 2


@pytest.mark.parametrize(("channel", "carries"), [("i_load", True), ("temp", False)])
def test_a_temperature_has_to_carry_as_much_as_a_curve_and_a_switched_load_less(
    started: Started, channel: str, carries: bool
) -> None:
    pool = _search(started())
    follows = next(c for c in pool.candidates if c.term.channels == (channel,))
    assert heldout_rules.explains_excess(pool, _held(1000, 600), LEVEL, [follows]) is carries
    assert heldout_rules.explains_excess(pool, _held(1000, 400), LEVEL, [follows])


def test_a_file_that_leaves_more_than_was_foretold_says_so() -> None:
    assert as_shipped(_held(300.0, 50.0), 80.0).after == pytest.approx(80.0)
    assert as_shipped(_held(70.0, 70.0), 80.0, added=False).before == pytest.approx(80.0)
    assert as_shipped(_held(300.0, 50.0), 45.0).after == pytest.approx(50.0)


@pytest.mark.parametrize(("drifts", "name"), [(0.0, "cage-field"), (0.3, "reference-drift"), (2.0, "reference-drift")])
def test_a_field_that_stands_is_no_drift_though_a_drift_contains_it(started: Started, drifts: float, name: str) -> None:
    """All forms of a field of the cage at once would take two thirds of the drift of 0.3: no field is all of them."""
    field = np.array([420.0, -260.0, 510.0])

    def missed(rows: dict[str, np.ndarray]) -> float:
        rows["ref"] = rows["ref"] + (1 + drifts * rows["t_s"][:, None] / 500.0) * field
        return 0.0

    pool = _search(started(missed))
    weighed_alone = {w.candidate.family.id: w for w in pool.rank(pool.candidates)}
    assert earns_its_extension(pool, (), weighed_alone["reference-drift"]) is (drifts > 0)
    assert [c.family.id for c in stepwise_forward(pool, most=1)[0]] == [name]


@pytest.mark.parametrize(
    "told", [pytest.param(True, marks=pytest.mark.slow), False], ids=["a channel tells", "nothing tells"]
)
def test_what_comes_with_the_motor_or_at_a_moment_is_the_cages_field_and_no_offset(
    making: ModuleType, tmp_path: Path, told: bool
) -> None:
    rows, segments = making.recorded()
    on = (np.mod(rows["t_s"], 31.0) < 12.0) if told else rows["t_s"] > 190.3
    rows["ref"] = rows["ref"] + on[:, None] * np.array([40.0, -90.0, 60.0])
    rows["motor_on"] = on.astype(float)
    motor = {"motor_on": {"unit": "1", "quantity": "other", "role": "platform"}}
    path = making.written(tmp_path, rows, segments, making.CHANNELS | (motor if told else {}))
    (chosen,) = stepwise_forward(_search(prepare(session.load_run(str(path)))[0]))[0]
    assert chosen.cause == ("cage-field", ("motor_on",) if told else ())
    assert chosen.term.parameters[0][0] == ("q_x" if told else "step_x")


def test_causes_that_push_each_other_out_come_to_an_end(started: Started, monkeypatch: pytest.MonkeyPatch) -> None:
    every = _search(started())
    few = [c for c in every.candidates if c.family.id in ("cross-field", "offset-drift") and not c.term.shape[1:]]
    monkeypatch.setattr(stepwise, "backward_check", lambda pool, accepted: accepted[-1:])
    monkeypatch.setattr(stepwise, "best_admissible", lambda pool, accepted, ranking: ranking[0] if ranking else None)
    assert len(stepwise_forward(every.restricted_to(few))[0]) <= 1


@pytest.mark.parametrize("whole_loop", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_rounds_of_selection_that_are_exhausted_are_an_outcome_and_said(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, whole_loop: bool
) -> None:
    """Of a load and a step no round finds what held-out data support, for nothing is called supported."""
    rows, segments = making.recorded(seconds=20.0)
    rows["dut"] = rows["dut"] + np.outer(rows["i_load"] + (rows["t_s"] > 150), [150.0, -100.0, 80.0])
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    assert not whole_loop or ROUNDS_EXHAUSTED not in close_loop(run).remarks
    monkeypatch.setattr(
        "labcal.loop.selection.select.first_unsupported", lambda pool, accepted, *_: 0 if accepted else None
    )
    monkeypatch.setattr("labcal.loop.selection.select.MAX_ROUNDS", 2)
    assert select(_search(prepare(run)[0]), LEVEL).ending == "rounds exhausted"
    assert not whole_loop or ROUNDS_EXHAUSTED in close_loop(run).remarks


def test_a_random_walk_is_given_no_name(started: Started) -> None:
    walk = np.random.default_rng(8).normal(0, 25, (540, 3)).cumsum(axis=0)
    pool = _search(started(lambda rows: walk))
    assert [c.family.id for c in select_and_prove(pool, NoiseFloor(36.0, "declared", None)).accepted] == []


def test_a_current_is_named_in_its_simplest_look_and_chance_would_not_do_it(started: Started) -> None:
    problem = started(lambda rows: rows["i_load"][:, None] * np.array([90.0, -60.0, 40.0]))
    loaded = select_and_prove(_search(problem), NoiseFloor(36.0, "declared", None))
    assert [(c.cause, len(c.term.parameters), c.term.shape) for c in loaded.accepted] == [
        (("offset-current", ("i_load",)), 3, ())
    ]
    assert p_value(loaded.rankings[0][0], loaded.null_distribution) < 1e-6
    assert p_value(loaded.rankings[-1][0], loaded.null_distribution) > 0.01


def test_the_tail_of_an_exponential_is_its_own(started: Started) -> None:
    null_distribution = np.sort(np.random.default_rng(2).exponential(2.0, 4000))
    candidate = _search(started()).candidates[0]
    far = Scored(candidate, 0.0, 20.0, 0.0, 1, Likelihood(0.0, 1.0, 0, 1.0))
    assert 0.6 < p_value(far, null_distribution) / np.exp(-20.0 / 2.0) < 1.6


def test_the_heat_of_a_load_follows_the_square_of_its_current_slowly(searching: Callable[..., CandidateSet]) -> None:
    t = searching({}, {}).problem.scene.t_s
    amps = np.random.default_rng(3).uniform(0, 2, 40)[(t // 17).astype(int)]
    tau_s = 17.0
    lit = np.arange(0, t[-1] + 1, 0.05)
    squared = np.interp(lit, t, amps) ** 2
    heat = np.zeros(len(lit))
    for i in range(1, len(lit)):
        heat[i] = heat[i - 1] + 0.05 / tau_s * (squared[i] - heat[i - 1])
    added = np.outer(np.interp(t, lit, heat), [30.0, -20.0, 10.0])
    (found,) = stepwise_forward(searching({"i": amps}, {"i": "current"}, added))[0]
    assert found.cause == ("offset-current-squared", ("i",))
    assert found.term.at("tau_s") == pytest.approx(tau_s, rel=0.15)


def test_the_choice_ends_where_white_noise_is_left_and_goes_on_where_it_is_not(
    searching: Callable[..., CandidateSet], monkeypatch: pytest.MonkeyPatch
) -> None:
    t = searching({}, {}).problem.scene.t_s
    amps = 0.8 * (np.mod(t, 47.0) < 19.0)
    asked: list[Candidate] = []
    beside = related.related_columns
    monkeypatch.setattr(
        stepwise,
        "related_columns",
        lambda pool, accepted, **how: asked.extend(accepted) or beside(pool, accepted, **how),
    )
    walk = np.cumsum(np.random.default_rng(0).normal(0, 4.0, (len(t), 3)), axis=0)
    for added, goes_on in ((0.0, False), (walk, True)):
        asked.clear()
        found = stepwise_forward(
            searching({"i": amps}, {"i": "current"}, np.outer(amps, [300.0, -200.0, 100.0]) + added)
        )[0]
        assert [c.term.channels for c in found] == [("i",)]
        assert bool(asked) is goes_on


def test_a_current_recorded_late_does_not_push_its_square_out(searching: Callable[..., CandidateSet]) -> None:
    t = searching({}, {}).problem.scene.t_s
    knots = np.arange(-10.0, t[-1] + 20.0, 9.0)
    level = np.random.default_rng(0).normal(0, 1, len(knots))
    now, late = (np.abs(np.interp(t - by_s, knots, level)) for by_s in (0.0, 0.5))
    added = np.outer(now**2, [300.0, -200.0, 100.0])
    found = stepwise_forward(searching({"i": late}, {"i": "current"}, added))[0]
    assert [c.cause for c in found] == [("offset-current-squared", ("i",))]


@pytest.mark.parametrize("tau_s", [None, pytest.param(14.0, marks=pytest.mark.slow)])
def test_of_a_load_with_two_levels_the_current_itself_goes_before_its_square(
    searching: Callable[..., CandidateSet], tau_s: float | None
) -> None:
    t = searching({}, {}).problem.scene.t_s
    amps = 0.1 + 0.8 * (np.mod(t, 41.0) < 17.0)
    acts = amps if tau_s is None else low_passed(t, np.zeros(len(t), dtype=np.intp), amps, tau_s)
    pool = searching({"i": amps}, {"i": "current"}, np.outer(acts, [80.0, -50.0, 30.0]))
    square = next(c for c in pool.candidates if c.family.second_order and bool(c.term.shape) == bool(tau_s))
    (first,) = prefer_computable(pool, block_folds(pool.problem, 0.0), [refined(pool, square, [])], ())
    assert first.cause == ("offset-current", ("i",))


def _switched_load(searching: Callable[..., CandidateSet], wave_nT: float) -> tuple[CandidateSet, Candidate, Candidate]:
    """A current of nearly two levels that acts with 5.5 s, beside a fast wave; its best look, and its square's."""
    t = searching({}, {}).problem.scene.t_s
    amps = 0.1 + 0.8 * (np.mod(t, 41.0) < 17.0) + np.random.default_rng(6).normal(0, 0.15, len(t))
    acts = low_passed(t, np.zeros(len(t), dtype=np.intp), amps, 5.5)
    added = np.outer(acts, [400.0, -250.0, 150.0]) + wave_nT * np.cos(2.1 * t)[:, None]
    pool = searching({"i": amps}, {"i": "current"}, added)
    trials = [c for c in pool.candidates if c.term.channels and [s.name for s in c.term.shape] == ["tau_s"]]
    null = pool.null_model()
    best = [max((pool.score(c, null) for c in trials if c.family.second_order is of), key=lambda w: w.evidence)
            for of in (False, True)]  # fmt: skip
    current, square = (refined(pool, w.candidate, []) for w in best)
    return pool, current, square


def test_a_square_is_held_against_its_current_at_that_ones_own_time_constant(
    searching: Callable[..., CandidateSet],
) -> None:
    pool, _, square = _switched_load(searching, 0.0)
    current = next(w for w in rivals.equally_likely(pool, [square], square) if not w.candidate.family.second_order)
    assert current.candidate.term.at("tau_s") == pytest.approx(5.5, rel=0.05)


def test_a_current_that_leads_clearly_has_no_rival_in_its_square_whatever_is_left(
    searching: Callable[..., CandidateSet],
) -> None:
    pool, current, square = _switched_load(searching, 30.0)
    assert "offset-current" in {w.candidate.family.id for w in rivals.equally_likely(pool, [square], square)}
    assert "offset-current-squared" not in {
        w.candidate.family.id for w in rivals.equally_likely(pool, [current], current)
    }


@pytest.mark.parametrize(("levels_A", "same"), [((0.0, 0.8), True), ((0.1, 0.9), True), ((0.0, 0.3, 0.8), False)])
def test_a_load_that_is_on_or_off_has_no_square_of_its_own(
    searching: Callable[..., CandidateSet], levels_A: tuple[float, ...], same: bool
) -> None:
    t = searching({}, {}).problem.scene.t_s
    draw = np.random.default_rng(17)
    amps = np.asarray(levels_A)[(t // 13.0).astype(int) % len(levels_A)] + draw.normal(0, 0.01, len(t))
    pool = searching({"i": amps}, {"i": "current"}, np.outer(amps, [300.0, -200.0, 150.0]))
    one, other = (
        max((c for c in pool.candidates if c.family.id == of and not c.term.shape), key=lambda c: c.size)
        for of in ("offset-current", "offset-current-squared")
    )
    assert rivals.is_the_same_here(pool, [], one, other) is same
    assert not rivals.is_the_same_here(pool, [], one, next(c for c in pool.candidates if c.family.id == "lag"))


def test_the_square_of_a_current_that_stands_takes_no_other_ones_place(searching: Callable[..., CandidateSet]) -> None:
    pool, current, _ = _switched_load(searching, 0.0)
    idle = next(c for c in pool.candidates if c.family.id == "offset-drift")
    near = rivals.equally_likely(pool, [current, idle], idle)
    assert len(near) > 1
    assert all(w.candidate.cause != (one, ("i",)) for w in near for one in ("offset-current", "offset-current-squared"))


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
    assert np.allclose(found.affine.k_nT, joint_fit(prepare(run)[0], []).problem.affine.k_nT, atol=0.1)
    assert found.metrics()["after"]["holdout_rms_nT"] > 1.2 * found.after.holdout_rms_nT


def test_a_slow_wave_is_a_drift_and_no_smooth_channels(searching: Callable[..., CandidateSet]) -> None:
    t = searching({}, {}).problem.scene.t_s
    turn = 2 * np.pi * (t - t[0]) / np.ptp(t)
    panel = np.clip(np.sin(1.1 * turn + 1), 0, None)
    pool = searching({"i": panel}, {"i": "current"}, np.outer(np.sin(0.9 * turn + 0.4), [250.0, -120.0, 60.0]))
    assert [c.cause for c in stepwise_forward(pool)[0]] == [("offset-drift", ())]


def _found(candidate: Candidate, gain: float) -> Scored:
    return Scored(candidate, gain, 0.0, 0.0, len(candidate.term.parameters), Likelihood(0.0, 1.0, 0, 1.0))


@pytest.mark.parametrize(("gain", "near"), [(60.0, True), (600.0, False)])
def test_a_weak_effect_of_few_parameters_has_a_rival_of_more_that_does_as_well(
    started: Started, gain: float, near: bool
) -> None:
    """Of a strong one, twelve parameters that fall into place are no accident."""
    candidates = _search(started()).candidates
    warm = next(c for c in candidates if c.family.id == "offset-temperature" and c.size == 3)
    drift = next(c for c in candidates if c.family.id == "offset-drift" and c.size == 15)
    found = rivals.within_reach([_found(warm, gain), _found(drift, gain + 12.0)], warm, ())
    assert (drift in [w.candidate for w in found]) is near


def test_a_loop_more_likely_than_not_is_the_rival_of_its_curve(searching: Callable[..., CandidateSet]) -> None:
    rows = searching({}, {}).problem
    s = rows.scene.rig.prediction_nT / 5e4
    curved = searching({}, {}, 150.0 * s**3)
    (curve,) = stepwise_forward(curved)[0]
    assert curve.family.id == "nonlinearity"
    assert rivals.plausible_extensions(curved, [curve], curve) == []
    loop = dahl(5e4 * s, 4000.0)
    looped = searching({}, {}, 150.0 * s**3 + 5.0 * loop)
    (rival,) = rivals.plausible_extensions(looped, [curve], curve)
    assert rival.candidate.family.id == "hysteresis"
