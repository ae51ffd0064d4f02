from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from labcal.fit.vector.identifiability import field_covariance, identify
from labcal.fit.vector.ml import estimate, ml
from labcal.fit.vector.observations import observe
from labcal.fit.vector.solve import LEAST_SQUARES, parameterise, solve
from labcal.fit.vector.system import Noise

ACROSS, HALF = (25e3, 0.0, 0.0), (21650.6, 0.0, 12500.0)
TWICE = tuple(2 * v for v in HALF)
SCALAR_RANKS = [
    ("one axis, one magnitude", "z", [ACROSS], 5),
    ("one axis, two magnitudes", "z", [HALF, TWICE], 8),
    ("two axes, one magnitude", "xz", [ACROSS], 8),
    ("two axes, two magnitudes across", "xz", [ACROSS, (50e3, 0.0, 0.0)], 8),
    ("two axes, two magnitudes at 60 degrees", "xz", [HALF, TWICE], 9),
    ("three axes, one magnitude", "xyz", [ACROSS], 9),
    ("three axes, the field along them", "xyz", [(0.0, 0.0, 25e3)], 3),
]
IDS = [case[0] for case in SCALAR_RANKS]


@pytest.mark.parametrize(("_", "axes", "fields", "rank"), SCALAR_RANKS, ids=IDS)
def test_rank_of_a_scalar_run_at_the_truth(bench, _: str, axes: str, fields: list, rank: int) -> None:
    symmetric = np.array([[1.05, 0.02, -0.01], [0.02, 0.95, 0.03], [-0.01, 0.03, 1.02]])
    run, true, _b = bench(offers="scalar", axes=axes, fields_nT=fields, noise_nT=0.0, K=symmetric)
    seen, parameterisation = observe(run), parameterise("symmetric", 1.0)
    theta = np.r_[true.K.ravel() * seen.scale, true.k_nT]
    found = solve(seen, Noise(1.0), parameterisation, theta, np.zeros(0), LEAST_SQUARES, iterations=0)
    assert identify(seen, Noise(1.0), parameterisation, found).rank == rank


@pytest.mark.parametrize(
    "noise_nT", [pytest.param(0.0, marks=pytest.mark.slow), 25.0, pytest.param(200.0, marks=pytest.mark.slow)]
)
@pytest.mark.parametrize(("_", "axes", "fields", "rank"), SCALAR_RANKS, ids=IDS)
def test_only_a_scalar_run_of_rank_nine_gets_numbers(
    bench, _: str, axes: str, fields: list, rank: int, noise_nT: float
) -> None:
    for rows in (40, 600):
        found = ml(bench(offers="scalar", axes=axes, fields_nT=fields, noise_nT=noise_nT, rows=rows)[0])
        assert found.ok == (rank == 9)
        assert found.ok or "determines" in found.why_not


def test_spinning_about_the_vertical_with_a_little_nodding_is_refused(bench) -> None:
    run, _, _ = bench(offers="scalar", axes="z", fields_nT=[(20e3, 0.0, 43e3)], rows=800, noise_nT=30.0)
    found = ml(run)
    assert not found.ok
    assert "turn the sensor about another body axis" in found.why_not or "add a rotation" in found.why_not


@pytest.mark.parametrize("axes", ["x", "z"])
def test_vectors_about_one_axis_do_not_make_a_map(bench, axes: str) -> None:
    for fields in ([HALF], [HALF, TWICE]):
        assert not ml(bench(axes=axes, fields_nT=fields)[0]).ok


def test_vectors_about_one_axis_and_a_free_phase_leave_the_rotation_open(bench) -> None:
    run, _, _ = bench(axes="z", fields_nT=[HALF, TWICE])
    found = estimate(run, parameterisation="affine")
    assert found.identified.rank < 12


def test_no_reference_leaves_the_scale_open(bench) -> None:
    run, _, _ = bench(offers="scalar")
    unknown = replace(run, reference=replace(run.reference, kind="none"), reference_magnitude=None)
    found = ml(unknown)
    assert not found.ok
    assert "scale" in found.why_not


def test_field_covariance_is_that_of_many_drawn_maps() -> None:
    rng = np.random.default_rng(0)
    A = rng.normal(size=(12, 12))
    reading = rng.normal(size=(2, 3))
    drawn = rng.multivariate_normal(np.zeros(12), A @ A.T, size=200_000)
    b = drawn[:, :9].reshape(-1, 3, 3) @ reading[0] - drawn[:, 9:]
    assert np.allclose(np.cov(b.T), field_covariance(reading, A @ A.T)[0], rtol=0.05, atol=0.3)
