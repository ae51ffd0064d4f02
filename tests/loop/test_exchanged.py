"""What came first takes most alone; once the others are there, what is far likelier in its place takes it."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from labcal.loop import close_loop
from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.selection.crossval import block_folds
from labcal.loop.selection.exchanged import exchanged
from labcal.loop.selection.select import prefer_computable
from labcal.store import read_bundle

BLIND = Path(__file__).parents[1] / "blind"


@pytest.fixture
def stepped(searching: Callable[..., CandidateSet]) -> tuple[CandidateSet, Candidate, Candidate, Candidate]:
    """A run with a zero that steps beside a current; the step, a drift with a knee near it, and the current."""
    t = searching({}, {}).problem.scene.t_s
    amps = 0.1 + 0.8 * (np.mod(t, 41.0) < 17.0)
    added = np.outer(amps, [80.0, -50.0, 30.0]) + np.outer(t > 0.5 * t[-1], [300.0, -200.0, 150.0])
    pool = searching({"i": amps}, {"i": "current"}, added)
    current = next(c for c in pool.candidates if c.cause == ("offset-current", ("i",)) and not c.term.shape)
    found = all_candidates(pool, [current])
    steps, drifts = ([c for c in found if c.family.id == name] for name in ("offset-step", "offset-drift"))
    return pool, _best(pool, steps, current), _best(pool, drifts, current), current


def _best(pool: CandidateSet, some: list[Candidate], beside: Candidate) -> Candidate:
    return max(pool.score_each(some, pool.null_model([beside])), key=lambda w: w.evidence).candidate


def test_what_is_far_likelier_beside_the_others_takes_the_place(
    stepped: tuple[CandidateSet, Candidate, Candidate, Candidate],
) -> None:
    pool, step, drift, current = stepped
    blocks, rankings = block_folds(pool.problem, 0.0), [pool.rank([step, drift, current], [])]
    found = exchanged(pool, blocks, [drift, current], rankings, ())
    assert [c.family.id for c in found] == ["offset-step", "offset-current"]
    assert exchanged(pool, blocks, [step, current], rankings, ())[0] is step


def test_what_is_refused_takes_no_place_and_what_stands_alone_keeps_its_own(
    stepped: tuple[CandidateSet, Candidate, Candidate, Candidate],
) -> None:
    pool, step, drift, current = stepped
    blocks, rankings = block_folds(pool.problem, 0.0), [pool.rank([step, drift, current], [])]
    assert exchanged(pool, blocks, [drift, current], rankings, {step.cause}) == [drift, current]
    assert exchanged(pool, blocks, [drift], rankings, ()) == [drift]


def test_alone_too_what_is_far_likelier_goes_before_what_follows_time_or_is_the_rigs(
    stepped: tuple[CandidateSet, Candidate, Candidate, Candidate],
) -> None:
    pool, step, drift, _ = stepped
    blocks = block_folds(pool.problem, 0.0)
    assert [c.family.id for c in prefer_computable(pool, blocks, [drift], ())] == ["offset-step"]
    assert prefer_computable(pool, blocks, [drift], {step.cause}) == [drift]


@pytest.mark.slow
def test_a_zero_that_steps_beside_a_late_clock_is_no_core_that_remembers(tmp_path: Path) -> None:
    """Alone the core takes more than either; with the clock in, a step is 485 nats likelier in its place."""
    subprocess.run([sys.executable, BLIND / "sensor_laws.py", tmp_path, "75", "64213", "25"], check=True)
    closed = close_loop(read_bundle(tmp_path / "b0025" / "bundle"))
    assert [one.effect for one in closed.accepted] == ["offset-step", "lag"]
    assert closed.after.holdout_rms_nT < 1.15 * closed.noise_floor_nT
