from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import sqrtm

from labcal.fit import fit
from labcal.fit.vector.ml import estimate, ml
from labcal.record import Run
from labcal.store.bundle import read_bundle

MEASURED = ["av-mageval", "px4-battery-current", *(f"practice/p0{i}/bundle" for i in range(1, 10))]


def normalised(found, truth) -> float:
    """Squared error over its expectation: near one where estimate and covariance are right."""
    error = found.affine.parameters - truth
    return float(error @ np.linalg.pinv(found.covariance, hermitian=True, rcond=1e-12) @ error)


def symmetric(affine) -> np.ndarray:
    """The map with the same magnitudes and a symmetric K."""
    K = np.real(sqrtm(affine.K.T @ affine.K))
    return np.concatenate([K.ravel(), K @ np.linalg.solve(affine.K, affine.k_nT)])


@pytest.mark.parametrize(
    ("offers", "free"),
    [
        pytest.param("vector", 12, marks=pytest.mark.slow),
        ("axis", 12),
        pytest.param("scalar", 9, marks=pytest.mark.slow),
    ],
)
def test_the_error_is_as_large_as_the_covariance_says(bench, offers: str, free: int) -> None:
    seeds, errors = 20, []
    for seed in range(seeds):
        run, true, _ = bench(offers=offers, seed=seed, rows=60)
        found = ml(run)
        assert found.frame_known == (offers != "scalar")
        errors.append(normalised(found, true.parameters if found.frame_known else symmetric(true)))
    band = 3.3 * np.sqrt(2 / (free * seeds))  # 99.9 % of chi-squared
    assert 1 - band < np.mean(errors) / free < 1 + band


def test_a_scalar_run_gives_the_symmetric_map_and_rank_nine(bench) -> None:
    found = ml(bench(offers="scalar")[0])
    assert not found.frame_known
    assert np.allclose(found.affine.K, found.affine.K.T, atol=1e-12)
    assert np.linalg.matrix_rank(found.covariance, rtol=1e-10) == 9


def test_without_declared_noise_it_is_estimated(bench) -> None:
    run, _, _ = bench(declared=False, noise_nT=40.0)
    assert ml(run).noise_nT == pytest.approx(40.0, rel=0.06)


def test_a_sensor_with_two_axes_swapped_and_one_reversed_is_fitted(bench) -> None:
    swapped = np.array([[0.02, 1.03, 0.0], [0.97, 0.03, 0.01], [0.0, 0.02, -1.05]])
    run, true, _ = bench(K=swapped)
    assert np.allclose(ml(run).affine.parameters, true.parameters, atol=20.0)
    assert np.allclose(ml(run).affine.K, swapped, atol=1e-3)


def test_counts_scale_the_matrix_and_leave_the_offset(bench) -> None:
    run, _, _ = bench()
    counts = replace(run, reading=run.reading / 13.0, dut=replace(run.dut, nominal_nT_per_unit=13.0, unit="count"))
    a, b = ml(run), ml(counts)
    assert np.allclose(b.affine.K, 13.0 * a.affine.K, rtol=1e-7)
    assert np.allclose(b.affine.k_nT, a.affine.k_nT, rtol=1e-6)
    assert np.allclose(np.diag(b.covariance)[9:], np.diag(a.covariance)[9:], rtol=1e-5)


def test_rotating_the_readings_turns_the_matrix_back(bench) -> None:
    run, _, _ = bench()
    R = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    turned = replace(run, reading=run.reading @ R.T)
    a, b = ml(run), ml(turned)
    assert np.allclose(b.affine.K @ R, a.affine.K, rtol=1e-6, atol=1e-8)
    assert np.allclose(b.affine.k_nT, a.affine.k_nT, rtol=1e-6)


@pytest.mark.parametrize("offers", ["vector", "axis"])
def test_noise_white_in_the_field_makes_the_answer_follow_any_linear_map_of_the_readings(bench, offers: str) -> None:
    run, _, _ = bench(offers=offers, noise_nT=300.0)
    A = np.array([[0.749, 0.354, 0.677], [-0.242, 1.122, -0.209], [-0.395, -1.043, 2.433]])
    a, b = (ml(r, white_in="field") for r in (run, replace(run, reading=run.reading @ A.T)))
    assert np.allclose(b.affine.K @ A, a.affine.K, atol=1e-5)
    assert np.allclose(b.affine.k_nT, a.affine.k_nT, atol=0.2)
    assert np.allclose(np.diag(b.covariance)[9:], np.diag(a.covariance)[9:], rtol=1e-3)
    assert b.noise_nT == pytest.approx(a.noise_nT, rel=1e-3)


@pytest.mark.parametrize("offers", ["vector", "axis", "scalar"])
def test_where_the_noise_is_white_hardly_matters_when_it_is_small(bench, offers: str) -> None:
    run, _, _ = bench(offers=offers, noise_nT=1.0, rows=300)
    a, b = ml(run), ml(run, white_in="field")
    size = np.sqrt(np.diag(a.covariance))
    assert np.all(np.abs(b.affine.parameters - a.affine.parameters) < 0.3 * size)
    assert np.allclose(np.sqrt(np.diag(b.covariance)), size, rtol=0.1)  # K is within 8 % of a rotation


def test_the_error_is_as_large_as_the_covariance_says_where_the_field_is_noisy(bench) -> None:
    S, seeds, errors = np.array([[0.749, 0.354, 0.677], [-0.242, 1.122, -0.209], [-0.395, -1.043, 2.433]]), 20, []
    for seed in range(seeds):
        run, true, b = bench(offers="vector", K=np.linalg.inv(S), noise_nT=0.0, seed=seed, rows=60)
        noise = 2000.0 * np.random.default_rng([seed, 1]).normal(size=b.shape)
        noisy = replace(run, reading=(b + true.k_nT + noise) @ S.T)
        found = ml(noisy, white_in="field")
        assert found.noise_nT == pytest.approx(2000.0, rel=0.15)
        errors.append(normalised(found, true.parameters))
    band = 3.3 * np.sqrt(2 / (12 * seeds))
    assert 1 - band < np.mean(errors) / 12 < 1 + band


def test_ten_wild_rows_in_a_thousand_do_not_move_the_answer(bench) -> None:
    clean, true, _ = bench(rows=170)
    spoilt = clean.reading.copy()
    spoilt[50::100] += 30e3
    wild = replace(clean, reading=spoilt)
    errors = [
        ml(r, robust=robust).affine.k_nT - true.k_nT for r, robust in ((clean, True), (wild, True), (wild, False))
    ]
    lengths = np.linalg.norm(errors, axis=1)
    assert lengths[1] < lengths[0] + 3.0
    assert lengths[2] > 100.0


def test_rows_with_empty_cells_are_left_out(bench) -> None:
    run, true, _ = bench()
    reading, angle = run.reading.copy(), run.angle_deg.copy()
    reading[3] = np.nan
    angle[7] = np.nan
    found = fit(replace(run, reading=reading, angle_deg=angle))
    assert found.ok
    assert np.isfinite(found.rms_scalar_nT)
    assert normalised(found, true.parameters) < 30


def test_a_constant_magnitude_does_not_shrink_the_map(bench) -> None:
    run, true, _ = bench(offers="scalar", fields_nT=((20e3, 0.0, 20e3),), rows=300)
    found = ml(run)
    assert found.ok
    assert normalised(found, symmetric(true)) < 28


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow if n % 3 else ()) for n, name in enumerate(MEASURED)]
)
def test_every_measured_run_gets_an_answer_or_a_reason(shared: Path, name: str) -> None:
    found = fit(read_bundle(shared / "data" / name))
    assert found.ok or "determines" in found.why_not
    assert found.ok == (name != "px4-battery-current")


def test_least_squares_leaves_what_is_known_of_the_measured_sensor(shared: Path) -> None:
    run: Run = read_bundle(shared / "data" / "av-mageval")
    lengths = [
        np.sqrt(np.mean(np.sum((b - run.reference_vector) ** 2, axis=1)))
        for b in (
            run.reading,
            estimate(run, robust=False).affine.apply(run.reading),
            ml(run).affine.apply(run.reading),
        )
    ]
    assert lengths[0] == pytest.approx(4310, rel=0.001)
    assert lengths[1] == pytest.approx(965, rel=0.01)
    assert lengths[2] < 1000


@pytest.mark.parametrize("offers", ["vector", "axis", "scalar"])
def test_hopeless_runs_get_a_reason(bench, offers: str) -> None:
    run, _, _ = bench(offers=offers, rows=20)
    dead = run.reading.copy()
    dead[:, 2] = 7.0
    wild = np.random.default_rng(0).normal(size=run.reading.shape) * 3e4
    hopeless = [run.select(np.arange(n)) for n in (1, 2, 3, 5, 13)]
    hopeless += [replace(run, reading=r) for r in (dead, wild, np.full_like(dead, np.nan), np.zeros_like(dead))]
    for case in hopeless:
        found = fit(case)
        assert not found.ok
        assert len(found.why_not) > 20
    assert "dut_z never changes" in fit(hopeless[5]).why_not
    assert "numbers; the map needs" in fit(hopeless[0]).why_not
