from dataclasses import replace

import made_up_runs as lab
import numpy as np
import pytest
from scipy.optimize import least_squares

from labcal.fit import fit
from labcal.fit.scalar import foster_elkaim, scalar_check, twostep
from labcal.fit.scalar.scalar_check import Estimate

NOISE = 25.0**2 * np.eye(3)


def sensor_matrix(p):
    """T of (5) to (7), written out."""
    a, b, c, rho, phi, lam = p
    return np.array(
        [
            [a, 0, 0],
            [b * np.sin(rho), b * np.cos(rho), 0],
            [c * np.sin(lam), c * np.sin(phi) * np.cos(lam), c * np.cos(phi) * np.cos(lam)],
        ]
    )


def test_the_parameters_are_those_of_the_sensor_model():
    p, o = np.array([0.95, 1.04, 1.1, -0.03, 0.05, 0.02]), np.array([300.0, -200.0, 900.0])
    T = sensor_matrix(p)
    values, vectors = np.linalg.eigh(np.linalg.inv(T @ T.T))
    K = vectors * np.sqrt(values) @ vectors.T
    found = foster_elkaim.parameters(Estimate(K @ o, K - np.eye(3), lambda: np.eye(9)))
    np.testing.assert_allclose([found.a, found.b, found.c, found.rho, found.phi, found.lam], p, rtol=1e-9)
    np.testing.assert_allclose([found.x0, found.y0, found.z0], o, rtol=1e-9)


def test_parameter_uncertainty_agrees_with_samples():
    run = lab.run_of(lab.tumbling(1), 1)
    found = twostep.estimate(run.reading, run.reference_magnitude, NOISE)
    draws = np.random.default_rng(0).multivariate_normal(found.theta, found.covariance, 2000)
    values = [foster_elkaim.parameters(Estimate(d[:3], scalar_check.unstacked(d[3:]), found.spread)) for d in draws]
    u = foster_elkaim.parameter_uncertainty(found)
    for name in ("a", "b", "c", "x0", "y0", "z0", "rho", "phi", "lam"):
        assert np.std([getattr(v, name) for v in values]) == pytest.approx(getattr(u, name), rel=0.08), name


def test_linear_form_equals_twostep_in_a_constant_field():
    field = lab.circles([0, 1, 2], [3e4], angle_to_axis_deg=70)
    for seed in range(3):
        run = lab.run_of(field, seed)
        run = replace(run, reading=0.8 * run.reading)  # gains well above one
        linear, batch = fit(run, "foster-elkaim"), fit(run, "twostep")
        u = np.sqrt(np.diag(batch.covariance))
        np.testing.assert_allclose((linear.affine.parameters - batch.affine.parameters) / u, 0, atol=0.05)
        np.testing.assert_allclose(np.sqrt(np.diag(linear.covariance)) / u, 1, atol=0.02)


def test_nonlinear_form_equals_least_squares_over_the_papers_own_parameters():
    run = lab.run_of(lab.tumbling(2), 2)
    weight = 1 / (2 * run.reference_magnitude * 25.0)

    def residual(p):
        K = np.linalg.inv(sensor_matrix(p[:6]))
        field = (run.reading - 1e4 * p[6:]) @ K.T
        return (np.sum(field**2, axis=1) - run.reference_magnitude**2) * weight

    found = least_squares(residual, [1, 1, 1, 0, 0, 0, 0, 0, 0], x_scale="jac").x
    ours = foster_elkaim.varying(run.reading, run.reference_magnitude, NOISE)
    p, u = foster_elkaim.parameters(ours), foster_elkaim.parameter_uncertainty(ours)
    for name, value in zip(("a", "b", "c", "rho", "phi", "lam"), found, strict=False):
        assert getattr(p, name) == pytest.approx(value, abs=0.15 * getattr(u, name)), name
    np.testing.assert_allclose([p.x0, p.y0, p.z0], 1e4 * found[6:], atol=0.15 * u.x0)


@pytest.mark.parametrize("angle", [0.0, 90.0])
def test_what_the_magnitudes_do_not_determine_is_refused(angle):
    found = fit(lab.run_of(lab.circles([0, 1], [2e4], angle_to_axis_deg=angle), 1), "foster-elkaim")
    assert not found.ok
    assert "turn the sensor about another body axis" in found.why_not
