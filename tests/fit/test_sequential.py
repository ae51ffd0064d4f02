import made_up_runs as lab
import numpy as np
import pytest

from labcal.fit import fit
from labcal.fit.filters.centered_sequential import State, advance
from labcal.fit.filters.ekf import EKF, slope
from labcal.fit.filters.scalar_step import shared_gradient, terms
from labcal.fit.filters.ukf import UKF, AugmentedUKF
from labcal.fit.scalar import scalar_check, twostep
from labcal.fit.scalar.moments import centred, moments

TRUTH = np.concatenate([lab.BIAS, scalar_check.stacked(lab.D)])
NOISE = 25.0**2 * np.eye(3)
FILTERS = [EKF, UKF, AugmentedUKF]


def test_the_recursion_equals_the_batch_on_the_same_weights():
    run = lab.run_of(lab.tumbling(1), 1)
    B, H = run.reading / 4e4, run.reference_magnitude / 4e4
    S, c_E = NOISE / 4e4**2, scalar_check.to_c_E(lab.BIAS / 4e4, lab.D)
    rows, square = scalar_check.regressors(B.T), H**2 + scalar_check.noise_mean(c_E, S)
    L, z = rows[:9].T, np.sum(B**2, axis=1) - square
    variance = scalar_check.noise_variance(rows, H**2, c_E, S) * np.random.default_rng(3).uniform(0.2, 5, len(B))
    state = State.of(centred(rows[:, :60], square[:60], variance[:60], S))
    for row in range(60, len(B)):
        state, _ = advance(state, L[row], z[row], variance[row])
    batch = State.of(centred(rows, square, variance, S))
    np.testing.assert_allclose(state.c_E, batch.c_E, rtol=1e-9, atol=1e-9 * np.abs(batch.c_E).max())
    largest = np.abs(batch.covariance).max()
    np.testing.assert_allclose(state.covariance, batch.covariance, rtol=1e-9, atol=1e-9 * largest)
    np.testing.assert_allclose(state.L, batch.L, rtol=1e-9)
    assert (state.z, state.variance) == pytest.approx((batch.z, batch.variance), rel=1e-9)


def test_terms_of_one_reading_are_those_of_the_batch_formulas():
    run = lab.run_of(lab.tumbling(2, 5), 2)
    B, H = run.reading / 4e4, run.reference_magnitude / 4e4
    S = np.array([[3.0, 0.5, -0.2], [0.5, 2.0, 0.3], [-0.2, 0.3, 1.0]]) * 1e-6
    c_E = scalar_check.to_c_E(lab.BIAS / 4e4, lab.D)
    at = terms(c_E, B[0], H[0], S, 2e-4)
    square, gradient = scalar_check.bias_square(c_E)
    rows = scalar_check.regressors(B[:1].T)
    L, z = rows[:9, 0], B[0] @ B[0] - H[0] ** 2
    assert at.innovation == pytest.approx(z - L @ c_E + square - scalar_check.noise_mean(c_E, S), abs=1e-14)
    assert at.variance == pytest.approx(scalar_check.noise_variance(rows, H[:1] ** 2, c_E, S, 2e-4)[0], rel=1e-5)
    np.testing.assert_allclose(slope(at), L - gradient, atol=1e-15)
    np.testing.assert_allclose(at.regressor, L, atol=1e-15)
    one = moments(rows, H[:1] ** 2, c_E, S, 2e-4)
    expected = (one.noise_gradient - one.noise_information @ c_E) * one.variance
    np.testing.assert_allclose(shared_gradient(at), expected, atol=1e-18)


def ended(kind, seed, field, noise=25.0):
    run = lab.run_of(field, seed, noise=noise)
    live = kind(noise**2 * np.eye(3))
    for reading, magnitude in zip(run.reading, run.reference_magnitude, strict=True):
        live.update(reading, magnitude)
    return run, live


@pytest.mark.parametrize("kind", FILTERS)
@pytest.mark.parametrize("field", [lab.tumbling(3, 1500), lab.circles([0, 1, 2], [2e4, 4e4])], ids=["tumbling", "axes"])
def test_filters_approach_twostep(kind, field):
    for seed in range(3):
        run, live = ended(kind, seed, field)
        assert live.started
        assert live.diverged() is None
        batch = twostep.estimate(run.reading, run.reference_magnitude, NOISE)
        found = live.estimate()
        u = np.sqrt(np.diag(batch.covariance))
        np.testing.assert_array_less(np.abs(found.theta - batch.theta) / u, 0.7)
        np.testing.assert_allclose(np.sqrt(np.diag(found.covariance)) / u, 1, atol=0.1)


def test_the_two_unscented_filters_agree():
    field = lab.tumbling(4, 800)
    plain, augmented = (ended(kind, 4, field)[1].estimate() for kind in (UKF, AugmentedUKF))
    u = np.sqrt(np.diag(plain.covariance))
    np.testing.assert_allclose((plain.theta - augmented.theta) / u, 0, atol=0.05)


def test_the_sequential_centred_estimate_ends_at_the_batch():
    run = lab.run_of(lab.tumbling(5), 5)
    batch, live = fit(run, "centered"), fit(run, "centered-sequential")
    u = np.sqrt(np.diag(batch.covariance))
    np.testing.assert_array_less(np.abs(batch.bias_nT - live.bias_nT) / u[9:], 0.2)
    np.testing.assert_array_less(np.abs(batch.affine.K - live.affine.K).ravel() / u[:9], 0.2)


@pytest.mark.parametrize("kind", FILTERS)
def test_normalised_error_squared_is_near_nine(kind):
    field, squares = lab.tumbling(6, 400), []
    for seed in range(16):
        found = ended(kind, seed, field)[1].estimate()
        error = found.theta - TRUTH
        squares.append(error @ np.linalg.solve(found.covariance, error))
    assert np.mean(squares) == pytest.approx(9, abs=4 * np.sqrt(18 / 16))


@pytest.mark.parametrize("method", ["ekf", "ukf", "ukf-augmented"])
def test_a_filter_whose_sensor_changes_says_that_it_has_diverged(method):
    field = lab.tumbling(7, 1200)
    run = lab.run_of(field, 7, bias=np.where(np.arange(1200)[:, None] < 700, lab.BIAS, lab.BIAS + 600.0))
    found = fit(run, method)
    assert not found.ok
    assert "diverged" in found.why_not
    assert fit(lab.run_of(field, 7), method).ok


def test_a_filter_whose_numbers_break_down_says_that_it_has_diverged():
    class Broken(EKF):
        @staticmethod
        def step(*_):
            raise ValueError("math domain error")

    _, live = ended(Broken, 7, lab.tumbling(7, 400))
    assert live.started
    assert "diverged" in live.diverged()


@pytest.mark.parametrize("method", ["ekf", "ukf", "ukf-augmented", "centered-sequential"])
def test_what_a_run_does_not_determine_is_refused(method):
    found = fit(lab.run_of(lab.circles([0, 1], [2e4]), 1), method)
    assert not found.ok
    assert "turn the sensor about another body axis" in found.why_not


@pytest.mark.parametrize("kind", FILTERS)
def test_the_filter_turns_and_scales_with_the_data(kind):
    run = lab.run_of(lab.tumbling(8, 400), 8)
    R = np.linalg.qr(np.random.default_rng(0).standard_normal((3, 3)))[0]
    plain, turned, scaled = kind(NOISE), kind(NOISE), kind(NOISE * 1e-6)
    for reading, magnitude in zip(run.reading, run.reference_magnitude, strict=True):
        plain.update(reading, magnitude)
        turned.update(R @ reading, magnitude)
        scaled.update(reading * 1e-3, magnitude * 1e-3)
    u = np.sqrt(np.diag(plain.estimate().covariance))[:3].min()
    np.testing.assert_allclose(turned.estimate().bias, R @ plain.estimate().bias, atol=0.02 * u)
    np.testing.assert_allclose(scaled.estimate().bias * 1e3, plain.estimate().bias, atol=1e-6 * u)


def test_the_noise_that_readings_share_with_their_magnitude_leaves_no_bias():
    field, errors = lab.tumbling(9, 1000, low=20_000, high=26_000), []
    for seed in range(12):
        found = ended(EKF, seed, field, noise=1400.0)[1].estimate()
        errors.append((found.theta - TRUTH) / np.sqrt(np.diag(found.covariance)))
    assert np.abs(np.mean(errors, axis=0)).max() < 4 / np.sqrt(12)
