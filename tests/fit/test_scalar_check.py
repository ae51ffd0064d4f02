from dataclasses import replace

import made_up_runs as lab
import numpy as np
import pytest
from scipy.signal import lfilter

from labcal.fit import fit
from labcal.fit.scalar import centered, scalar_check, twostep
from labcal.fit.scalar.moments import centred
from labcal.geometry import unit

B, D = np.array([0.1, -0.06, 0.12]), np.array([[0.05, 0.03, -0.04], [0.03, 0.1, 0.02], [-0.04, 0.02, -0.03]])
TRUTH = np.concatenate([lab.BIAS, scalar_check.stacked(lab.D)])


def numerical(function, at, step=1e-6):
    return np.column_stack([(function(at + e) - function(at - e)) / (2 * step) for e in step * np.eye(len(at))])


def of_theta(theta):
    return scalar_check.to_c_E(theta[:3], scalar_check.unstacked(theta[3:]))


def test_the_parameters_go_to_c_E_and_back():
    bias, D_back = scalar_check.to_b_D(scalar_check.to_c_E(B, D))
    np.testing.assert_allclose(bias, B, rtol=1e-12)
    np.testing.assert_allclose(D_back, D, rtol=1e-12)


def test_jacobian_is_the_numerical_derivative():
    theta = np.concatenate([B, scalar_check.stacked(D)])
    np.testing.assert_allclose(scalar_check.jacobian(B, D), numerical(of_theta, theta), atol=1e-9)


def test_gradient_of_the_bias_square_is_the_numerical_derivative():
    c_E = scalar_check.to_c_E(B, D)
    square, gradient = scalar_check.bias_square(c_E)
    assert square == pytest.approx(B @ B)
    slope = numerical(lambda x: np.array([scalar_check.bias_square(x)[0]]), c_E)
    np.testing.assert_allclose(gradient, slope[0], atol=1e-9)


def test_covariance_map_agrees_with_samples():
    random = np.random.default_rng(1)
    c_E = scalar_check.to_c_E(B, D)
    root = 1e-5 * random.standard_normal((9, 9))
    found = scalar_check.from_c_E(c_E, root @ root.T)
    draws = [scalar_check.from_c_E(c_E + root @ e, root @ root.T).theta for e in random.standard_normal((4000, 9))]
    ratio = np.diag(np.cov(np.array(draws).T)) / np.diag(found.covariance)
    np.testing.assert_allclose(ratio, 1, atol=0.1)


def test_noise_mean_and_variance_agree_with_samples():
    random = np.random.default_rng(2)
    S = np.diag([1.0, 2.0, 0.5]) * 0.02**2
    field = np.array([0.7, -0.5, 0.6])
    c_E = scalar_check.to_c_E(B, D)
    reading = np.linalg.solve(np.eye(3) + D, field + B) + random.multivariate_normal(np.zeros(3), S, 200_000)
    magnitude = np.full(len(reading), np.linalg.norm(field))
    rows = scalar_check.regressors(reading.T)
    v = np.sum(reading**2, axis=1) - magnitude**2 - c_E @ rows[:9] + B @ B
    assert v.mean() == pytest.approx(scalar_check.noise_mean(c_E, S), abs=5 * v.std() / np.sqrt(len(v)))
    assert v.var() == pytest.approx(scalar_check.noise_variance(rows, magnitude**2, c_E, S).mean(), rel=0.02)


def test_what_the_noise_adds_to_the_gradient_and_the_information_agrees_with_samples():
    clean = lab.tumbling(0, 400) / 40_000
    S, c_E = 0.02**2 * np.eye(3), scalar_check.to_c_E(B, D)
    exact = np.linalg.solve(np.eye(3) + D, (clean + B).T).T
    magnitude = np.linalg.norm(clean, axis=1)
    variance = scalar_check.noise_variance(scalar_check.regressors(exact.T), magnitude**2, c_E, S)

    def sums(reading):
        rows = scalar_check.regressors(reading.T)
        return centred(rows, magnitude**2 + scalar_check.noise_mean(c_E, S), variance, S)

    bare = sums(exact)
    gradients, informations = [], []
    for seed in range(600):
        noisy = exact + 0.02 * np.random.default_rng(seed).standard_normal(exact.shape)
        at = sums(noisy)
        square, slope = scalar_check.bias_square(c_E)
        off_centre = (at.z - at.L @ c_E + square) / at.variance * (at.L - slope)
        gradients.append(at.projection - at.information @ c_E + off_centre)
        informations.append(np.diag(at.information - bare.information))
    expected = bare.noise_gradient - bare.noise_information @ c_E
    spread = np.std(gradients, axis=0) / np.sqrt(len(gradients))
    error = np.abs(np.mean(gradients, axis=0) - expected)
    np.testing.assert_array_less(error, 4 * spread + 0.01 * np.abs(expected).max())
    spread = np.std(informations, axis=0) / np.sqrt(len(informations))
    error = np.abs(np.mean(informations, axis=0) - np.diag(bare.noise_information))
    np.testing.assert_array_less(error, 4 * spread + 0.01 * np.diag(bare.noise_information))


@pytest.mark.parametrize("method", ["centered", "twostep"])
def test_bias_and_D_are_recovered_without_noise(method):
    found = fit(lab.run_of(lab.tumbling(3), 0, noise=1e-6), method)
    np.testing.assert_allclose(found.bias_nT, lab.BIAS, atol=1e-4)
    np.testing.assert_allclose(found.D, lab.D, atol=1e-8)
    np.testing.assert_allclose(found.affine.K, np.eye(3) + lab.D, atol=1e-8)


def test_twostep_needs_one_magnitude_only_where_three_axes_are_turned():
    assert fit(lab.run_of(lab.circles([0, 1, 2], [20_000.0]), 0), "twostep").ok


@pytest.mark.parametrize(
    ("axes", "magnitudes", "angle"),
    [
        ([0], [2e4], 90.0),
        ([0], [2e4, 4e4], 90.0),
        ([0, 1], [2e4], 90.0),
        ([0, 1], [2e4, 4e4], 90.0),
        ([0, 1, 2], [2e4], 0.0),
    ],
)
@pytest.mark.parametrize("method", ["centered", "twostep"])
@pytest.mark.parametrize("noise", [0.1, 25.0, 200.0])
def test_what_a_run_does_not_determine_is_refused(method, axes, magnitudes, angle, noise):
    found = fit(lab.run_of(lab.circles(axes, magnitudes, angle_to_axis_deg=angle), 1, noise=noise), method)
    assert not found.ok
    assert "turn the sensor about another body axis" in found.why_not


def test_centered_refuses_a_constant_magnitude():
    found = fit(lab.run_of(lab.circles([0, 1, 2], [2e4]), 1), "centered")
    assert not found.ok
    assert "another magnitude" in found.why_not


@pytest.mark.parametrize("module", [centered, twostep])
def test_the_answer_turns_and_scales_with_the_data(module):
    run = lab.run_of(lab.tumbling(4), 4)
    R = np.linalg.qr(np.random.default_rng(0).standard_normal((3, 3)))[0]
    S = 25.0**2 * np.eye(3)
    plain = module.estimate(run.reading, run.reference_magnitude, S)
    turned = module.estimate(run.reading @ R.T, run.reference_magnitude, S)
    scaled = module.estimate(run.reading * 1e-3, run.reference_magnitude * 1e-3, S * 1e-6)
    np.testing.assert_allclose(turned.bias, R @ plain.bias, rtol=1e-7)
    np.testing.assert_allclose(turned.D, R @ plain.D @ R.T, atol=1e-10)
    np.testing.assert_allclose(scaled.bias, plain.bias * 1e-3, rtol=1e-7)
    np.testing.assert_allclose(scaled.D, plain.D, atol=1e-10)


@pytest.mark.parametrize("times", [1, 30])
def test_the_answer_moves_with_the_readings_however_far(times):
    run, S, by = (
        lab.run_of(lab.circles([0, 1, 2], [2e4, 4e4]), 3),
        25.0**2 * np.eye(3),
        times * np.array([3e4, -2e4, 1e4]),
    )
    plain = twostep.estimate(run.reading, run.reference_magnitude, S)
    found = twostep.estimate(run.reading + by, run.reference_magnitude, S)
    moved = np.concatenate([plain.bias + by + plain.D @ by, scalar_check.stacked(plain.D)])
    slope = numerical(lambda x: np.concatenate([x[:3] + scalar_check.unstacked(x[3:]) @ by, x[3:]]), plain.theta)
    covariance = slope @ plain.covariance @ slope.T
    u = np.sqrt(np.diag(covariance))
    np.testing.assert_allclose((found.theta - moved) / u, 0, atol=1e-6)
    np.testing.assert_allclose((found.covariance - covariance) / np.outer(u, u), 0, atol=1e-6)


@pytest.mark.parametrize("times", [10, 30])
def test_twostep_starts_well_beside_a_bias_many_times_the_field(times):
    worst = []
    for seed in range(60):
        random = np.random.default_rng(seed)
        field = unit(random.standard_normal((200, 3))) + random.uniform(0.5, 1.3) * np.array([1.0, 0.5, 0.3])
        field = unit(field) * random.uniform(0.7, 1.3, (200, 1))
        bias = times * unit(random.standard_normal(3))
        reading = np.linalg.solve(np.eye(3) + D, (field + bias).T).T + 0.01 * random.standard_normal((200, 3))
        found = twostep.estimate(reading, np.linalg.norm(field, axis=1), 0.01**2 * np.eye(3))
        error = found.theta - np.concatenate([bias, scalar_check.stacked(D)])
        worst.append(np.sqrt(error @ np.linalg.solve(found.covariance, error)))
    assert max(worst) < 9  # of chi with nine degrees of freedom: chance 1e-13


def test_counts_give_the_map_in_nanotesla_per_count():
    run = lab.run_of(lab.tumbling(5), 5, gain=0.25)
    found = fit(run, "twostep")
    plain = fit(lab.run_of(lab.tumbling(5), 5), "twostep")
    np.testing.assert_allclose(found.affine.K, 0.25 * plain.affine.K, rtol=1e-9)
    np.testing.assert_allclose(found.covariance[:9, :9], plain.covariance[:9, :9] * 0.25**2, rtol=1e-6)
    assert np.linalg.matrix_rank(found.covariance / np.outer(*[np.sqrt(np.diag(found.covariance))] * 2), 1e-9) == 9


def test_without_the_noise_share_the_published_estimate_is_biased_and_ours_is_not():
    field = lab.tumbling(6, 3000, low=20_000, high=26_000)
    error = {True: [], False: []}
    for seed in range(20):
        run = lab.run_of(field, seed, noise=800.0)
        for unbiased in error:
            found = centered.estimate(run.reading, run.reference_magnitude, 800.0**2 * np.eye(3), unbiased=unbiased)
            error[unbiased].append((found.theta - TRUTH) / np.sqrt(np.diag(found.covariance)))
    assert np.abs(np.mean(error[False], axis=0)).max() > 2
    assert np.abs(np.mean(error[True], axis=0)).max() < 4 / np.sqrt(20)


def test_the_covariance_is_widened_for_correlated_residuals():
    field = lab.tumbling(8, 2000)
    drift = 100.0 * lfilter([0.2], [1.0, -0.98], np.random.default_rng(0).standard_normal(2000))
    run = lab.run_of(field, 0)
    wider = replace(run, reference_magnitude=run.reference_magnitude + drift)
    found = fit(wider, "twostep", holdout=False)
    bare = twostep.estimate(wider.reading, wider.reference_magnitude, found.noise_nT**2 * np.eye(3))
    ratio = np.diag(found.covariance)[9:] / np.diag(bare.covariance)[:3]
    assert ratio.min() > 5
