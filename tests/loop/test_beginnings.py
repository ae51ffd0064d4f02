"""How loops begin: what the segments of a run say of other recordings, and what nobody can know of them."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.fit import draft_calibration
from labcal.loop.beginnings import astray_nT, spread_of, with_beginnings
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.refit import refit
from labcal.loop.selection.admission import earns_its_extension
from labcal.loop.selection.crossval import block_folds, cross_validate, fixed_choice
from labcal.loop.selection.joint_fit import in_sample_rms, joint_fit
from labcal.model import EffectRecord, Parameter
from labcal.model.apply import apply
from labcal.model.effects.hysteresis import FAMILY, candidates, stop
from labcal.model.effects.nonlinearity import FAMILY as CURVES
from labcal.model.readings import Readings
from labcal.record import Run
from labcal.testing.made_up_runs import MadeUp, made_up_run

Array = np.ndarray
A_nT, K_nT, C_nT, NOISE_nT, FINE = 15e3, 8e3, 600.0, 10.0, 40
LOOP_r, LOOP_c = 6000.0, 0.05


def langevin(u: Array) -> Array:
    return 1 / np.tanh(u) - 1 / u


def together(values: Array, segment: Array) -> Array:
    """Rows (n, 3) of segments that are equally long, side by side (rows, segments, 3)."""
    return values.reshape(segment[-1] + 1, -1, 3).swapaxes(0, 1)


def core(field: Array, segment: Array, begin: Array) -> Array:
    """What a core adds (n, 3): small steps of the equation, from M = `begin` (segments, 3) in each first row."""
    rows, M = together(field, segment), begin
    out = np.empty_like(rows)
    for k, s in enumerate(rows):
        step = (s - rows[max(k - 1, 0)]) / FINE
        for part in range(FINE if k else 0):
            lacking = langevin((rows[k - 1] + (part + 0.5) * step) / A_nT) - M
            M = M + np.where(lacking * step > 0, lacking * np.abs(step) / K_nT, 0.0)
        out[k] = C_nT * (M - langevin(s / A_nT))
    return out.swapaxes(0, 1).reshape(field.shape)


def stopped(field: Array, segment: Array, begin: Array) -> Array:
    """What a stop adds (n, 3), from `begin` (segments, 3) within ± r where each segment begins."""
    rows, z = together(field, segment), begin
    out = np.empty_like(rows)
    for k, s in enumerate(rows):
        z = np.clip(z + s - rows[max(k - 1, 0)], -LOOP_r, LOOP_r)
        out[k] = LOOP_c * z
    return out.swapaxes(0, 1).reshape(field.shape)


def firsts(made: MadeUp) -> Array:
    return made.field_nT[np.flatnonzero(np.diff(made.run.segment_index, prepend=-1))]


def of_a_core(made: MadeUp, draw: np.random.Generator, part: float, spread: float) -> Array:
    begin = part * langevin(firsts(made) / A_nT) + spread * draw.uniform(-1, 1, (6, 3))
    return core(made.field_nT, made.run.segment_index, begin)


def of_a_stop(made: MadeUp, draw: np.random.Generator, part: float, spread: float) -> Array:
    demagnetised = np.clip(firsts(made), -LOOP_r, LOOP_r)
    begin = (1 - spread) * part * demagnetised + spread * LOOP_r * draw.uniform(-1, 1, (6, 3))
    return stopped(made.field_nT, made.run.segment_index, begin)


def record(values: dict[str, float]) -> EffectRecord:
    return EffectRecord("hysteresis", (), {}, "sensor", tuple(Parameter(n, v, 0.0, "") for n, v in values.items()))


CORE = record(
    {f"body_{n}_{a}": 1.0 for n in ("c", "t1") for a in "xyz"}
    | {"a_nT": A_nT, "pinning_nT": K_nT, "begins_on": 1.0, "begins": 1.0}
)
STOP = record({f"body_c_{a}": 0.01 for a in "xyz"} | {"r_nT": LOOP_r, "kept": 0.0, "begins": 1.0})
MAKERS = {"core": (CORE, of_a_core), "stop": (STOP, of_a_stop)}


def tried(which: str, part: float, spread: float, seed: int) -> tuple[dict[str, float], float, float]:
    """What a refit says of how the loop begins, and mean squares of error and u on fresh segments in other fields."""
    draw = np.random.default_rng(seed)
    effect, added = MAKERS[which]
    made, other = (made_up_run(noise_nT=NOISE_nT, seed=seed + k) for k in (0, 1000))
    run = made.with_effect(added(made, draw, part, spread))
    fit = refit(run, [effect])
    stated = {p.name: p.value for p in fit.effects[0].parameters}
    metrics = {"before": {}, "after": {"noise_nT": NOISE_nT}}
    fresh = other.with_effect(added(other, draw, part, spread))
    rows = Readings(fresh.reading, fresh.t_s, fresh.segment_index)
    told = apply(draft_calibration(run, fit, "0" * 64, metrics=metrics), rows)
    plain = np.array([not word for word in told.flags])
    return stated, float(np.mean((told.field_nT - other.field_nT)[plain] ** 2)), float(np.mean(told.u_nT[plain] ** 2))


@pytest.mark.parametrize(
    ("which", "spread"),
    [
        pytest.param("core", 0.0, marks=pytest.mark.slow),
        pytest.param("core", 0.3, marks=pytest.mark.slow),
        pytest.param("stop", 0.0, marks=pytest.mark.slow),
    ],
)
def test_u_holds_how_the_run_s_own_segments_began(which: str, spread: float) -> None:
    found = [tried(which, 1.0, spread, seed) for seed in range(8)]
    errors, u = (np.mean([one[k] for one in found]) for k in (1, 2))
    assert 0.8 < np.sqrt(errors / u) < 1.25


def test_a_core_that_always_begins_at_half_of_its_curve_is_known_to() -> None:
    stated, error, _ = tried("core", 0.5, 0.0, 3)
    assert abs(stated["begins_on"] - 0.5) < 0.05
    assert np.sqrt(error) < 1.3 * NOISE_nT


def test_a_run_that_shows_no_beginning_says_that_it_may_be_anywhere() -> None:
    nothing, seen = np.zeros(9), np.full(18, 100.0)
    assert spread_of(nothing, nothing) > 0.8
    assert spread_of(2 * seen, np.zeros(18)) < 0.05
    assert abs(spread_of(2 * seen, np.tile([120.0, -120.0], 9)) - 0.6) < 0.1
    hardly = np.r_[2 * seen, 10.0]  # of which a form's misfit says what it likes
    assert spread_of(hardly, np.r_[np.zeros(18), 25.0]) < 0.05


def test_a_demagnetised_stop_that_begins_a_little_astray_begins_nearly_there() -> None:
    drive = 2e4 * np.sin(np.linspace(1.0, 8.0, 60))[:, None]
    near, there = (stop(drive, 5e3, at_rest=False, astray=astray) for astray in (1e-3, 0.0))
    assert np.abs(near - there).max() < 10.0


def problem_of(run: Run) -> tuple[CandidateSet, Candidate]:
    """A core at the true parameters, as the only candidate."""
    problem, *_ = prepare(run)
    term = next(t for t in candidates(run) if t.of_beginnings and t.parameters[0][0].startswith("body"))
    chosen = Candidate(FAMILY, term.with_values(a_nT=A_nT, pinning_nT=K_nT))
    rows = np.ones(len(problem), dtype=bool)
    with_curves = [chosen, *(Candidate(CURVES, t) for t in CURVES.candidates(run) if not t.shape)]
    return CandidateSet(problem, with_curves, rows, 0.87, rows), chosen


def test_offsets_that_differ_from_segment_to_segment_are_no_loop() -> None:
    made, draw = made_up_run(noise_nT=NOISE_nT), np.random.default_rng(5)
    for effect, is_one in (
        (draw.normal(0, 200.0, (6, 3))[made.run.segment_index], False),
        (of_a_core(made, draw, 1.0, 0.5), True),
    ):
        pool, chosen = problem_of(made.with_effect(effect))
        assert earns_its_extension(pool, (), pool.score(chosen, pool.null_model())) is is_one


def test_how_a_segment_began_is_not_asked_of_a_fit_that_did_not_see_it() -> None:
    made, draw = made_up_run(noise_nT=NOISE_nT), np.random.default_rng(6)
    pool, chosen = problem_of(made.with_effect(of_a_core(made, draw, 1.0, 0.3)))
    held = cross_validate(pool, block_folds(pool.problem, 2.0), fixed_choice([chosen]))
    assert held.after < 1.15 * np.sqrt(3) * NOISE_nT
    assert 0.5 < held.rows.mean() < 1.0


def test_how_far_astray_another_recording_begins_is_what_the_segments_scatter() -> None:
    made, draw = made_up_run(noise_nT=NOISE_nT), np.random.default_rng(7)
    pool, chosen = problem_of(made.with_effect(of_a_core(made, draw, 1.0, 0.3)))
    found = with_beginnings(joint_fit(pool.problem, [chosen.term]))
    scatter = np.sqrt(3) * C_nT * 0.3 / np.sqrt(3)  # of three axes, each anywhere between two ends
    assert abs(astray_nT(found, 0) / scatter - 1) < 0.4


def of_relays(made: MadeUp, draw: np.random.Generator, size_nT: Array) -> Array:
    """What a core of relays adds (n, 3), half of them up where each segment begins."""
    half, middle = LOOP_r * np.exp(0.6 * draw.normal(size=1500)), draw.logistic(0.0, 5e3, 1500)
    rows = together(made.field_nT, made.run.segment_index)
    state, out = draw.choice([-1.0, 1.0], (*rows.shape[1:], 1500)), np.empty_like(rows)
    for k, s in enumerate(rows[:, :, :, None]):
        state = np.where(s > middle + half, 1.0, np.where(s < middle - half, -1.0, state))
        out[k] = size_nT * state.mean(axis=-1)
    return out.swapaxes(0, 1).reshape(made.field_nT.shape)


def test_relays_along_one_axis_alone_are_found_by_a_joint_fit_that_starts_without() -> None:
    made, draw = made_up_run(noise_nT=NOISE_nT), np.random.default_rng(8)
    run = made.with_effect(of_relays(made, draw, np.array([C_nT, 0.0, 0.0])))
    term = next(t for t in candidates(run) if any(s.name == "sd_ln" for s in t.shape) and t.parameters[0][0][0] == "b")
    problem, *_ = prepare(run)
    found = joint_fit(problem, [term.with_values(r_nT=LOOP_r, middles_nT=1e4)])
    assert in_sample_rms(found) < 1.3 * np.sqrt(3) * NOISE_nT < 0.3 * in_sample_rms(joint_fit(problem, []))
    assert abs(found.beta[0][0] - C_nT) < 0.1 * C_nT
