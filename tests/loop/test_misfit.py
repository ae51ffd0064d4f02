"""What a form misses is nobody's name: neither a second cause's, nor that of another form in the same channel."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import candidates_of, prepare
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.policy import POLICY
from labcal.loop.selection.admission import evidence_of_its_own
from labcal.loop.selection.select import likelier_forms
from labcal.loop.selection.sets import together
from labcal.loop.selection.stepwise import stepwise_forward
from labcal.record import Channel
from labcal.testing.made_up_runs import made_up_run

Rows = dict[str, np.ndarray]
DIRECTIONS = np.array([1.0, -0.7, 0.5])
STANDING_nT = np.array([90.0, -120.0, 60.0])
IRON = 1e-3 * np.array([[4.0, 2.0, -3.0], [-1.0, -5.0, 2.5], [1.5, -2.0, 1.0]])  # of the field that magnetises it


def _turned(rows: Rows, in_cage: np.ndarray) -> np.ndarray:
    """Fields (n, 3) of the cage as the device sees them."""
    axis = np.eye(3)[["xyz".index(name[0]) for name in rows["segment"]]]
    along = np.sum(in_cage * axis, axis=1, keepdims=True) * axis
    turn = rows["angle"][:, None]
    return np.asarray(along + np.cos(turn) * (in_cage - along) - np.sin(turn) * np.cross(axis, in_cage))


def _load(rows: Rows) -> np.ndarray:
    return np.asarray(200.0 * (np.mod(rows["t_s"], 47.0) < 19.0)[:, None] * DIRECTIONS)


def _best(pool: CandidateSet, effect: str) -> Candidate:
    some = [c for c in all_candidates(pool, []) if c.family.id == effect]
    return refined(pool, pool.rank(some)[0].candidate, [])


@pytest.mark.parametrize("iron", [True, False])
def test_iron_beside_a_standing_field_is_no_gradient_and_no_tilt_and_a_load_beside_it_is_a_load(
    started: Callable[..., LinearProblem], iron: bool
) -> None:
    def added(rows: Rows) -> np.ndarray:
        return np.asarray(_turned(rows, STANDING_nT + iron * rows["ref"] @ IRON.T) + (not iron) * _load(rows))

    pool = CandidateSet.of(started(added), 0.85)
    standing = next(c for c in pool.candidates if c.family.id == "cage-field" and len(c.term.parameters) == 3)
    for effect in ("axis-tilt", "field-gradient") if iron else ("offset-current",):
        second = pool.rank([c for c in pool.candidates if c.family.id == effect], [standing])[0]
        assert second.evidence > 2 * POLICY.min_evidence
        assert (evidence_of_its_own(pool, [standing], second.candidate) >= POLICY.min_evidence) is not iron


@pytest.mark.parametrize(("power", "effect"), [(1, "offset-current"), (2, "offset-current-squared")])
def test_of_a_current_and_its_square_slow_telemetry_leaves_the_right_one(
    searching: Callable[..., CandidateSet], power: int, effect: str
) -> None:
    t = searching({}, {}).problem.scene.t_s
    draw = np.random.default_rng(4)
    ends = np.cumsum(draw.exponential(14.0, 100))
    level = draw.choice([0.1, 0.5, 0.9, 1.6], 101)

    def amps(at_s: Any) -> np.ndarray:
        return np.asarray(level[np.searchsorted(ends, at_s)])

    told = amps(np.floor(t / 4.0) * 4.0)  # held for four seconds: up to four late
    pool = searching({"i": told}, {"i": "current"}, np.outer(amps(t) ** power, 150.0 * DIRECTIONS))
    (found,) = likelier_forms(pool, [_best(pool, "offset-current")], ())
    assert found.family.id == effect


def test_a_member_of_a_set_that_acts_by_its_square_leaves_it(searching: Callable[..., CandidateSet]) -> None:
    t = searching({}, {}).problem.scene.t_s
    draw = np.random.default_rng(8)
    ends = np.cumsum(draw.exponential(14.0, (2, 100)), axis=1)
    one, two = (draw.choice([0.1, 0.5, 0.9, 1.6], 101)[np.searchsorted(some, t)] for some in ends)
    acts = np.outer(one, 150.0 * DIRECTIONS) + np.outer(two**2, 80.0 * DIRECTIONS[::-1])
    pool = searching({"i": one, "j": two}, {"i": "current", "j": "current"}, acts)
    members = [next(c for c in pool.candidates if c.cause == ("offset-current", (name,))) for name in "ij"]
    found = likelier_forms(pool, [together(pool, members, 2)], ())
    assert [c.cause for c in found] == [("offset-current", ("i",)), ("offset-current-squared", ("j",))]


def test_an_offset_beside_a_gain_in_one_temperature_is_found_in_a_field_of_one_size() -> None:
    """The gain bent by the field's square is that offset: it may be missed, and is no reason to miss the offset."""
    made = made_up_run(rows=100, fields_nT=[(30e3, 20e3, 25e3)])
    t_s = made.run.t_s
    warm = Channel("t_board", "degC", "temperature", 24 + 3 * np.sin(t_s / 17.3))
    made = made_up_run(rows=100, fields_nT=[(30e3, 20e3, 25e3)], channels=[warm])
    rise = (warm.values - 24)[:, None]
    run = made.with_effect(rise * (made.field_nT * 2e-3 + np.array([14.0, -21.0, 28.0])))
    problem, _, _ = prepare(run)
    pool = candidates_of(run, problem)
    gain = pool.rank([c for c in pool.candidates if c.family.id == "gain-temperature"])[0].candidate
    offset = pool.rank([c for c in pool.candidates if c.family.id == "offset-temperature"], [gain])[0].candidate
    assert evidence_of_its_own(pool, [gain], offset) >= POLICY.min_evidence


def _bent_in_a_channel(searching: Callable[..., CandidateSet], seed: int) -> CandidateSet:
    """A run whose offset follows a channel, which wanders slowly, from a threshold on alone."""
    t, draw = searching({}, {}).problem.scene.t_s, np.random.default_rng(seed)
    cycles, phases = draw.uniform(0, 4, 30)[:, None], draw.uniform(0, 2 * np.pi, 30)[:, None]
    p = np.sum(np.cos(2 * np.pi * cycles * (t - t[0]) / np.ptp(t) + phases), axis=0)
    p /= p.std()
    return searching({"p": p}, {"p": "voltage"}, np.outer(np.clip(p - 0.2, 0, None), [400.0, -300.0, 200.0]))


@pytest.mark.parametrize("seed", [pytest.param(1, marks=pytest.mark.slow), pytest.param(2, marks=pytest.mark.slow), 3])
def test_what_a_channel_does_from_a_threshold_on_has_no_name_in_time(
    searching: Callable[..., CandidateSet], seed: int
) -> None:
    pool = _bent_in_a_channel(searching, seed)
    assert not [c.label for c in stepwise_forward(pool)[0] if c.family.bound_to_run]


def test_a_drift_stays_one_beside_a_channel_that_only_rises(searching: Callable[..., CandidateSet]) -> None:
    """Any course in time is a function of it, which is paid for."""
    t = searching({}, {}).problem.scene.t_s
    through = (t - t[0]) / np.ptp(t)
    rises = 1 - np.exp(-2 * through) + np.random.default_rng(4).normal(0, 0.002, len(t))
    wave = np.outer(np.sin(2 * np.pi * through), [250.0, -120.0, 60.0])
    pool = searching({"p": rises}, {"p": "voltage"}, wave)
    assert [c.family.id for c in stepwise_forward(pool)[0]] == ["offset-drift"]
