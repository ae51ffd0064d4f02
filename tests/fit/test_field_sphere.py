"""K and k of a sensor at rest in many fields, against fields and sensors that are made up here."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.fit.field_sphere import SphereFit, fit_sphere
from labcal.fit.vector.ml import ml
from labcal.record import Dut, Reference, Run, Segment
from labcal.uncertainty import DeclaredError
from procedures.field_sphere import played

TRUE_K = np.array([[1.06, 0.04, -0.03], [-0.02, 0.94, 0.05], [0.03, -0.06, 1.02]])
TRUE_k = np.array([2100.0, -3400.0, 1500.0])
MAGNITUDES = (20e3, 50e3)
DRIFT = np.array([0.02, -0.03, 0.01])


def visits(seed: int, noise_nT: float = 4.0, drift: np.ndarray = DRIFT) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Readings, fields and times of a sphere: k grows by `drift` each second, counted from the middle."""
    rng, b = np.random.default_rng(seed), played(24, MAGNITUDES)
    t = 4.5 * np.arange(len(b))
    k = TRUE_k + drift * (t - t.mean())[:, None]
    return np.linalg.solve(TRUE_K, (b + k).T).T + rng.normal(0, noise_nT, b.shape), b, t


def errors(fit: SphereFit) -> np.ndarray:
    return np.asarray(fit.affine.parameters - np.r_[TRUE_K.ravel(), TRUE_k])


def test_without_noise_it_is_the_truth_drift_included() -> None:
    fit = fit_sphere(*visits(0, noise_nT=0.0))
    assert np.abs(errors(fit)[:9]).max() < 1e-12
    assert np.abs(errors(fit)[9:]).max() < 1e-7
    assert fit.drift_nT_per_s == pytest.approx(DRIFT, abs=1e-9)


def test_errors_over_sixty_runs_are_as_large_as_their_uncertainty() -> None:
    fits = [fit_sphere(*visits(seed)) for seed in range(60)]
    z = np.array([errors(fit) / fit.u for fit in fits])
    assert 0.9 < np.sqrt(np.mean(z**2)) < 1.1
    drift = np.array([(fit.drift_nT_per_s - DRIFT) / fit.u_drift_nT_per_s for fit in fits])
    assert 0.8 < np.sqrt(np.mean(drift**2)) < 1.2
    whole = [errors(fit) @ np.linalg.solve(fit.covariance_a, errors(fit)) for fit in fits]
    assert np.mean(whole) == pytest.approx(12, abs=3)  # chi squared of twelve, a few freedoms short of infinity


def test_maximum_likelihood_of_the_same_means_gives_the_same_map() -> None:
    m, b, t = visits(3, drift=np.zeros(3))
    run = Run(
        run_id="means", started_utc="2026-01-01T00:00:00Z", simulated=True, operator="", dut=Dut("S"),
        reference=Reference("vector", noise_nT=0.01),
        segments=(Segment("sphere", "static", body_from_cage=((1, 0, 0), (0, 1, 0), (0, 0, 1))),),
        t_s=t, segment_index=np.zeros(len(t), dtype=np.intp), reading=m, reference_vector=b,
    )  # fmt: skip
    theirs, ours = ml(run, robust=False), fit_sphere(m, b, t)
    assert theirs.affine is not None
    assert (
        np.abs((theirs.affine.parameters - ours.affine.parameters) / ours.u).max() < 0.3
    )  # one of them has a drift beside it


def test_what_drifts_through_the_run_looks_like_no_field() -> None:
    """Of a straight drift, and of a bent one, the fields and their products explain less than a fiftieth."""
    b = played(48, (20e3, 35e3, 50e3)) / 50e3
    t = np.linspace(-1, 1, len(b))
    columns = np.column_stack([np.ones(len(b)), b])
    for course in (t, t**2 - np.mean(t**2)):
        left = course - columns @ np.linalg.lstsq(columns, course, rcond=None)[0]
        assert 1 - np.sum(left**2) / np.sum(course**2) < 0.02


def test_every_direction_is_played_at_every_magnitude_and_zero_is_visited() -> None:
    fields = played(48, (20e3, 35e3, 50e3))
    size = np.linalg.norm(fields, axis=1)
    assert len(fields[size > 0]) == 144
    assert len(np.unique(fields[size > 0].round(6), axis=0)) == 144
    zeros = np.flatnonzero(size == 0)
    assert (zeros[0], zeros[-1]) == (0, len(fields) - 1)
    assert np.diff(zeros).max() <= 13


def test_what_is_declared_of_the_reference_moves_the_map_as_its_errors_would() -> None:
    """By differences: the fields as another reference would have told them."""
    m, b, t = visits(1)
    plain, turned = fit_sphere(m, b, t), np.radians(0.2)
    z = np.array([[1, -turned, 0], [turned, 1, 0], [0, 0, 1]])
    others = {"scale": b * (1 + 4e-4), "zero y": b + [0, 30.0, 0], "turn about z": b @ z.T}
    stated = [(DeclaredError(name, 1.0, "nT", lambda run: run), there) for name, there in others.items()]
    wide = fit_sphere(m, b, t, stated)
    assert [c.source for c in wide.contributions] == list(others)
    for part, there in zip(wide.contributions, others.values(), strict=True):
        moved = fit_sphere(m, there, t).affine.parameters - plain.affine.parameters
        assert np.abs(moved).max() > 1e-4
        assert part.shift == pytest.approx(moved, rel=1e-6, abs=1e-9)


@pytest.mark.parametrize(
    ("fields", "says"),
    [(np.eye(3), "too few"), (np.random.default_rng(1).normal(size=(40, 3)) * [1, 1, 0], "lie in a plane")],
)
def test_fields_that_do_not_determine_the_map_are_refused(fields: np.ndarray, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        fit_sphere(fields, fields, np.arange(len(fields), dtype=float))
