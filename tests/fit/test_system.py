from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from labcal.fit.declared import contributions
from labcal.fit.vector.ml import estimate, ml
from labcal.fit.vector.observations import observe
from labcal.fit.vector.solve import LEAST_SQUARES, ROBUST, Loss, parameterise, solve
from labcal.fit.vector.system import Noise, evaluate, normal
from labcal.model import AffineMap
from labcal.uncertainty import covariance_of


def half_cost(seen, noise, y: np.ndarray) -> float:
    return 0.5 * float(evaluate(seen, noise, y[:12], y[12:]).cost.sum())


UNEVEN = np.array([[1.4, 0.3, -0.5], [0.3, 0.7, 0.2], [-0.5, 0.2, 1.9]])


@pytest.mark.parametrize("shape", [None, UNEVEN], ids=["white", "uneven"])
@pytest.mark.parametrize(
    ("offers", "reading_noise", "close"), [("vector", 25.0, 1e-5), ("axis", 1.0, 2e-3), ("scalar", 1.0, 2e-3)]
)
def test_the_normal_equations_are_the_derivative_of_the_cost(
    bench, offers: str, reading_noise: float, close: float, shape
) -> None:
    run, true, _ = bench(offers=offers, rows=20, noise_nT=reading_noise)
    seen, noise = observe(run), Noise(reading_noise, 8.0 if offers == "vector" else 0.0, shape=shape)
    y = np.r_[true.K.ravel() * seen.scale, true.k_nT, np.full(len(seen.phase_names), 0.3)]
    at = evaluate(seen, noise, y[:12], y[12:])
    _, gradient = normal(seen, at, np.ones(len(seen)))
    steps = np.r_[np.full(12, 1e-2), np.full(len(y) - 12, 1e-6)]
    numeric = [
        (half_cost(seen, noise, y + h * e) - half_cost(seen, noise, y - h * e)) / (2 * h)
        for h, e in zip(steps, np.eye(len(y)), strict=True)
    ]
    scale = np.abs(gradient[:12]).max()
    assert np.allclose(gradient[:12], numeric[:12], atol=close * scale)
    assert np.allclose(gradient[12:], numeric[12:], rtol=1e-4)


def test_effects_are_subtracted_from_the_field(bench) -> None:
    run, true, _ = bench(rows=20)
    seen = observe(run)
    theta, phase = np.r_[true.K.ravel() * seen.scale, true.k_nT], np.zeros(6)
    effect = np.arange(3.0 * len(seen)).reshape(-1, 3)
    without, with_it = (evaluate(seen, Noise(25.0), theta, phase, e).residual for e in (0.0, effect))
    assert np.allclose(without - with_it, effect)


def test_angle_noise_weighs_only_along_the_turn(bench) -> None:
    run, true, _ = bench(rows=20, axes="z")
    seen = observe(run)
    theta, phase = np.r_[true.K.ravel() * seen.scale, true.k_nT], np.zeros(len(seen.phase_names))
    at = evaluate(seen, Noise(25.0, 0.0, 0.01), theta, phase)
    plain = evaluate(seen, Noise(25.0), theta, phase)
    t = at.tangent
    lateral = np.einsum("na,nab,nb->n", t, np.linalg.inv(at.information) - np.linalg.inv(plain.information), t)
    assert np.allclose(lateral, 0.01**2 * np.sum(t**2, axis=1) ** 2)
    along = np.linalg.inv(at.information)[:, 2, 2] - np.linalg.inv(plain.information)[:, 2, 2]
    assert np.allclose(along, 0.0, atol=1e-6)


def test_restricted_maps_find_their_own_parameters(bench) -> None:
    gain, _, _ = bench(K=1.04 * np.eye(3))
    found = estimate(gain, parameterisation="gain-offset").affine
    assert np.allclose(found.K, found.K[0, 0] * np.eye(3))
    assert found.K[0, 0] == pytest.approx(1.04, abs=2e-4)
    offset, true, _ = bench(K=np.eye(3), axes="z")
    found = estimate(offset, parameterisation="offset").affine
    assert np.array_equal(found.K, np.eye(3))
    assert np.allclose(found.k_nT, true.k_nT, atol=20.0)


def test_the_loss_is_the_integral_of_its_weight() -> None:
    d = np.linspace(1e-3, 30, 4001)
    kind = np.full(len(d), 3, dtype=np.int8)
    for loss in (ROBUST, Loss(0.5, 2.0), Loss(1.0, np.inf), LEAST_SQUARES):
        weight, value = loss.weights_and_losses(d**2, kind)
        assert np.allclose(np.gradient(value, d)[1:-1], (weight * d)[1:-1], atol=0.05)


def test_the_robust_weight_costs_almost_no_efficiency() -> None:
    d = np.abs(np.random.default_rng(0).normal(size=400_000))
    weight, _ = ROBUST.weights_and_losses(d**2, np.ones(len(d), dtype=np.int8))
    psi, step = weight * d, 1e-4
    slope = (ROBUST.weights_and_losses((d + step) ** 2, np.ones(len(d), dtype=np.int8))[0] * (d + step) - psi) / step
    assert np.mean(slope) ** 2 / np.mean(psi**2) == pytest.approx(0.997, abs=5e-4)


def test_a_start_far_off_still_ends_at_the_minimum(bench) -> None:
    run, true, _ = bench(rows=30)
    seen, noise = observe(run), Noise(25.0)
    best = ml(run)
    far = np.r_[(0.7 * np.eye(3)).ravel() * seen.scale, 9e3 * np.ones(3)]
    found = solve(seen, noise, parameterise("affine", 1.0), far, best.phase_rad + 0.5, LEAST_SQUARES)
    assert found.converged
    assert np.allclose(found.theta[9:], true.k_nT, atol=40.0)


def test_declared_mounting_widens_by_a_common_turn(bench) -> None:
    run, true, _ = bench(rows=20)
    u_deg = 0.2
    segments = tuple(replace(s, u_axis_body_deg=u_deg) for s in run.segments)
    wide = covariance_of(contributions(replace(run, segments=segments), true, frame_known=True), 12)
    rng = np.random.default_rng(0)
    turns = Rotation.from_rotvec(np.radians(u_deg) * rng.normal(size=(20_000, 3))).as_matrix()
    drawn = np.concatenate([(turns @ true.K).reshape(-1, 9), turns @ true.k_nT], axis=1)
    size = np.sqrt(np.diag(wide))
    assert np.allclose(np.cov(drawn.T) / np.outer(size, size), wide / np.outer(size, size), atol=0.05)
    assert not covariance_of(contributions(replace(run, segments=segments), true, frame_known=False), 12).any()


def test_a_declared_scale_of_the_reference_is_in_proportion(bench) -> None:
    true = AffineMap(np.diag([1.0, 2.0, 3.0]), np.array([10.0, 20.0, 30.0]))
    run, _, _ = bench(rows=20)
    run = replace(run, reference=replace(run.reference, u_scale_ppm=1000.0))
    wide = covariance_of(contributions(run, true, frame_known=True), 12)
    assert np.allclose(np.sqrt(np.diag(wide)), 1e-3 * true.parameters)
