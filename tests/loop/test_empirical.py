"""An effect that nobody has written: built from what the search leaves, proven, shipped where asked for, applied."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from runpy import run_path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.certificate import calibration_bytes, parse_calibration
from labcal.errors import InputError
from labcal.fit import draft_calibration
from labcal.loop import ClosedLoop, close_loop, empirical_term
from labcal.loop.candidates.scorer import Scored
from labcal.loop.close import prepare
from labcal.loop.empirical import proof
from labcal.loop.empirical.build import Shortlist
from labcal.loop.empirical.description import POINTS, of_one
from labcal.loop.empirical.inputs import sets_of_inputs
from labcal.loop.noise.bands import bands_of
from labcal.loop.noise.coloured import NullModel
from labcal.loop.noise.marginal import RATIOS, NullEliminated
from labcal.loop.selection.joint_fit import joint_fit
from labcal.loop.selection.proof import Evidence
from labcal.model import Calibration
from labcal.model.effects import load_shipped
from labcal.record import Channel, Run
from labcal.testing.made_up_runs import MadeUp, made_up_run

ROWS, NOISE_nT = 60, 25.0
ALONG = np.array([200.0, -120.0, 90.0])
BLIND = Path(__file__).parents[1] / "blind" / "empirical_term.py"


def _bent(volts: np.ndarray) -> np.ndarray:
    """An offset (n, 3) that no file has: two saturating steps and a wave between them."""
    return np.asarray(np.sin(6 * (volts - 12))[:, None] * np.tanh((volts - 12.3) / 0.3)[:, None] * ALONG)


def _volts(t_s: np.ndarray, swing: float = 1.0) -> np.ndarray:
    return np.asarray(12 + swing * np.sin(2 * np.pi * t_s / 61))


@pytest.fixture(scope="module")
def made() -> MadeUp:
    plain = made_up_run(rows=ROWS, noise_nT=NOISE_nT)
    volts = Channel("v_bus", "V", "voltage", _volts(plain.run.t_s))
    return made_up_run(rows=ROWS, noise_nT=NOISE_nT, channels=[volts])


@pytest.fixture(scope="module")
def run(made: MadeUp) -> Run:
    return made.with_effect(_bent(made.run.channel("v_bus").values))


@pytest.fixture(scope="module")
def shipped(run: Run) -> ClosedLoop:
    return close_loop(run, empirical=True)


@pytest.fixture(scope="module")
def calibration(run: Run, shipped: ClosedLoop) -> Calibration:
    return draft_calibration(run, shipped.fit(), "0" * 64)


@pytest.mark.slow
def test_of_magnitudes_the_last_fit_carries_the_term(making: ModuleType, tmp_path: Path) -> None:
    """Magnitudes show no turn of the map: what noise takes for one has to stay out of the term's columns."""
    rows, segments = making.recorded()
    tuned = 1 / (1 + ((rows["temp"][:, None] - 21.0) / 0.7) ** 2)
    rows["dut"] = rows["dut"] + tuned * 2 * ALONG
    free = [{"id": segment["id"], "kind": "free"} for segment in segments]
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, free))), empirical=True)
    assert closed.residual_kind == "scalar"
    assert [effect.effect for effect in closed.accepted] == ["empirical"]
    assert closed.after.train_rms_nT < 1.1 * closed.noise_floor_nT < 0.5 * closed.before.train_rms_nT


def test_without_the_flag_the_verdict_stays_and_the_term_is_proposed(run: Run, shipped: ClosedLoop) -> None:
    closed = close_loop(run)
    (term,) = closed.proposed
    stated = closed.to_json()["proposed"][0]
    assert (closed.verdict, closed.accepted) == ("unexplained", ())
    assert (stated["effect"], stated["inputs"], stated["channels"]) == ("empirical", ["channel:v_bus"], ["v_bus"])
    assert {"kind", "knots", "degree", "projection", "coefficients", "covariance"} <= stated["basis"].keys()
    assert term.holdout_rms_after_nT == shipped.accepted[0].holdout_rms_after_nT
    assert closed.fit().effects == ()


def test_with_the_flag_it_ships_and_the_summary_says_that_it_has_no_name(shipped: ClosedLoop) -> None:
    assert shipped.verdict == "explained"
    assert [e.effect for e in shipped.accepted] == ["empirical"]
    assert "no name" in shipped.summary
    assert shipped.after.holdout_rms_nT < 1.15 * shipped.noise_floor_nT < 0.5 * shipped.before.holdout_rms_nT


def test_fresh_rows_inside_the_domain_lose_the_effect_and_state_their_error(
    made: MadeUp, calibration: Calibration
) -> None:
    back = parse_calibration(calibration_bytes(calibration), "calibration")
    draws = [made_up_run(rows=ROWS, noise_nT=NOISE_nT, seed=seed, channels=made.run.channels) for seed in (1, 2, 3)]
    z = []
    for fresh in draws:
        volts = _volts(fresh.run.t_s + 20, 0.98)
        recorded = replace(fresh.with_effect(_bent(volts)), channels=(Channel("v_bus", "V", "voltage", volts),))
        applied = back.apply(recorded)
        assert not any("domain" in flag for flag in applied.flags)
        z.append((applied.field_nT - fresh.field_nT) / applied.u_nT[:, None])
    assert 0.85 < float(np.sqrt(np.mean(np.square(z)))) < 1.15


def test_outside_its_domain_it_is_left_out_flagged_and_the_prior_is_told(
    run: Run, made: MadeUp, calibration: Calibration
) -> None:
    basis = calibration.effects[0].basis
    assert basis is not None
    volts = _volts(run.t_s, 1.3)
    out = (volts < run.channel("v_bus").values.min()) | (volts > run.channel("v_bus").values.max())
    applied = calibration.apply(replace(run, channels=(Channel("v_bus", "V", "voltage", volts),)))
    assert [("domain" in flag) for flag in applied.flags] == out.tolist()
    assert np.allclose(applied.field_nT[out], calibration.affine.apply(run.reading[out]))
    assert np.all(applied.u_nT[out] > basis.prior_nT)
    assert np.all(applied.u_nT[~out] < 2 * NOISE_nT)


def test_the_columns_are_orthogonal_to_the_map_and_fresh_rows_get_the_same(
    run: Run, shipped: ClosedLoop, calibration: Calibration
) -> None:
    fitted = load_shipped(calibration.effects[0])
    scene = _scene(run, shipped)
    added = fitted.predict(scene)
    onto = np.column_stack([np.ones(len(run)), scene.field_nT / 1e4])
    share = np.linalg.lstsq(onto, added, rcond=None)[0]
    assert np.linalg.norm(onto @ share) < 0.02 * np.linalg.norm(added)


def _scene(run: Run, shipped: ClosedLoop) -> Any:
    from labcal.model.effects import Scene

    field = shipped.affine.apply(run.reading)
    return Scene(run.t_s, run.segment_index, field, {c.name: c.values for c in run.channels})


def test_a_basis_that_does_not_belong_to_its_parameters_is_refused(calibration: Calibration) -> None:
    record = calibration.effects[0]
    broken = replace(record, parameters=(replace(record.parameters[0], value=1e3), *record.parameters[1:]))
    with pytest.raises(InputError, match="not whole"):
        load_shipped(broken)
    with pytest.raises(InputError, match="not whole"):
        load_shipped(replace(record, domain=()))


def test_the_marginal_likelihood_is_that_of_the_dense_covariance() -> None:
    draw = np.random.default_rng(4)
    n, bands = 40, bands_of(40)
    base, X, y = draw.normal(size=(n, 1, 2)), draw.normal(size=(n, 1, 3)), draw.normal(size=(n, 1, 1))
    null = NullModel.of(base.copy(), y.copy(), bands, 1e-6)
    found = NullEliminated.of(null, X, range(len(bands.spectra))).best()
    S = np.repeat(bands.spectra[found.spectrum], np.diff(bands.edges))
    white = 1 / np.sqrt(S)[:, None]
    A, Z, r = white * base[:, 0], white * X[:, 0], white * y[:, 0]
    off = np.eye(n) - A @ np.linalg.pinv(A)
    C = np.eye(3) + found.ratio * Z.T @ off @ Z
    rss = float(np.squeeze(r.T @ off @ r - found.ratio * r.T @ off @ Z @ np.linalg.solve(C, Z.T @ off @ r)))
    v = rss / n
    log = -0.5 * (n * np.log(v) + n + np.log(S).sum() + np.linalg.slogdet(C)[1])
    assert found.ratio in RATIOS
    assert found.log == pytest.approx(log, rel=1e-6)


@pytest.mark.parametrize(
    ("kind", "seed"),
    [
        ("white", 2026),
        *(pytest.param(*case, marks=pytest.mark.slow) for case in (("random walk", 2027), ("telegraph", 2028))),
    ],
)
def test_nothing_is_built_on_noise(kind: str, seed: int) -> None:
    assert run_path(str(BLIND))["noise_trial"](kind, seed)["built"] == []


@pytest.mark.parametrize(
    ("shape", "seed"),
    [
        pytest.param("resonant in the rate", 2028, marks=pytest.mark.slow),
        pytest.param("two channels' product", 2031, marks=pytest.mark.slow),
        pytest.param("temperature times field", 2035, marks=pytest.mark.slow),
    ],
)
def test_shapes_of_two_inputs_and_of_motion_are_carried_to_fresh_rows(shape: str, seed: int) -> None:
    assert run_path(str(BLIND))["shape_trial"](shape, seed)["gone"] > 0.7


@pytest.mark.parametrize(
    ("kind", "shape"),
    [
        ("straight", lambda x: 3 * x),
        ("quadratic", lambda x: (x - 0.2) ** 2),
        ("saturating", lambda x: np.tanh(2.2 * x)),
        ("resonant", lambda x: 1 / (1 + ((x - 0.1) / 0.2) ** 2)),
        ("a step", lambda x: np.tanh(x / 0.03)),
        ("wavy", lambda x: np.sin(9 * x)),
    ],
)
def test_a_curve_is_told_in_words(kind: str, shape: Callable[[np.ndarray], np.ndarray]) -> None:
    assert of_one(shape(np.linspace(-1, 1, POINTS)))[0] == kind


def test_the_proposal_says_what_it_looks_like_and_what_to_measure(run: Run, shipped: ClosedLoop) -> None:
    proposed = shipped.next_experiment
    assert proposed is not None
    assert "wavy" in shipped.accepted[0].why
    assert "v_bus up and down" in proposed.do


def test_where_held_out_blocks_refuse_inputs_the_next_are_tried(
    run: Run, shipped: ClosedLoop, monkeypatch: pytest.MonkeyPatch
) -> None:
    tried, proven = list[tuple[str, ...]](), proof.proven_with

    def noted(found: Evidence, scored: Scored, inputs: Shortlist) -> Evidence | None:
        tried.append(scored.candidate.term.inputs)
        return proven(found, scored, inputs)

    monkeypatch.setattr(proof, "improves", lambda own: False)
    monkeypatch.setattr(proof, "proven_with", noted)
    assert close_loop(run, empirical=True).accepted == ()
    assert tried[0] == shipped.accepted[0].inputs
    assert len(set(tried)) == len(tried) > 1


def test_a_term_that_its_joint_fit_does_not_carry_is_neither_shipped_nor_proposed(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(empirical_term, "nearest_fit", lambda problem, found: joint_fit(problem, []))
    closed = close_loop(run, empirical=True)
    assert (closed.verdict, closed.accepted, closed.proposed) == ("unexplained", (), ())


def test_of_many_channels_those_whose_products_go_with_the_residual_stand_in_pairs() -> None:
    t_s = made_up_run(rows=ROWS).run.t_s
    draws = np.random.default_rng(3).uniform(20, 90, size=12)
    channels = [Channel(f"c{i}", "V", "voltage", 12 + np.sin(t_s / q)) for i, q in enumerate(draws)]
    product = (channels[9].values - 12) * (channels[11].values - 12)
    run = made_up_run(rows=ROWS, noise_nT=NOISE_nT, channels=channels).with_effect(product[:, None] * ALONG)
    sets = sets_of_inputs(prepare(run)[0])  # beside the field and its rate, which are inputs too
    assert ("channel:c9", "channel:c11") in sets
    assert len({name for one in sets if len(one) == 2 for name in one if "channel:" in name}) == 8
