"""95 % intervals hold the truth in 93 to 97 % of seeds pooled, in 91.6 to 97.8 % for each parameter (99.9 % band)."""

from dataclasses import replace

import made_up_runs as lab
import numpy as np
import pytest

from labcal.fit import fit
from labcal.fit.scalar import scalar_check

BATCH = ("centered", "centered-sequential", "twostep", "foster-elkaim", "telemetry", "ekf")
METHODS = (*BATCH, "ukf", "ukf-augmented")
TRUTH = np.concatenate([(np.eye(3) + lab.D).ravel(), lab.BIAS])
FIELDS = {"tumbling": lab.tumbling(11, 400), "axes": lab.circles([0, 1, 2], [2e4, 4e4], angle_to_axis_deg=70, each=80)}
E = np.array([1200.0, -400.0, 300.0])


def run_with_a_current(field, seed, noise):
    current = np.random.default_rng(1).uniform(0, 1, len(field))
    channel = lab.current("i_load", current - np.median(current))
    run = lab.run_of(field + np.outer(channel.values, E), seed, noise=noise, channels=(channel,))
    return replace(run, reference_magnitude=np.linalg.norm(field, axis=1))


def normalised(method, field, seed, noise=25.0):
    """Error over standard uncertainty of the six numbers of K and of k, and of the current's effect for `telemetry`."""
    telemetry = method == "telemetry"
    run = run_with_a_current(field, seed, noise) if telemetry else lab.run_of(field, seed, noise=noise)
    found = fit(run, method, holdout=False)
    assert found.ok, found.why_not
    z = (found.affine.parameters - TRUTH) / np.sqrt(np.diag(found.covariance))
    z = z[[0, 4, 8, 1, 2, 5, 9, 10, 11]]
    of_current = [(p.value - e) / p.u for e, p in zip(E, found.effects[0].parameters, strict=True)] if telemetry else []
    return np.concatenate([z, of_current])


@pytest.mark.slow
@pytest.mark.parametrize("field", FIELDS.values(), ids=FIELDS)
@pytest.mark.parametrize("method", METHODS)
def test_intervals_hold_the_truth_as_often_as_they_say(method, field):
    held = np.array([np.abs(normalised(method, field, seed)) < 1.96 for seed in range(500)])
    print(method, held.mean().round(4), "each", held.mean(axis=0).min(), "to", held.mean(axis=0).max())
    assert 0.93 <= held.mean() <= 0.97
    assert np.all((held.mean(axis=0) >= 0.916) & (held.mean(axis=0) <= 0.978))


@pytest.mark.parametrize("method", METHODS)
def test_errors_are_as_large_as_their_uncertainties(method):
    z = np.array([normalised(method, FIELDS["tumbling"], seed) for seed in range(12)])
    assert np.sqrt(np.mean(z**2)) == pytest.approx(1, abs=4 / np.sqrt(2 * len(z) * 4))  # nine parameters correlate


def test_the_parameters_that_are_tested_are_those_of_the_estimate():
    found = fit(lab.run_of(FIELDS["tumbling"], 0), "twostep", holdout=False)
    np.testing.assert_allclose(found.affine.K - np.eye(3), found.D, atol=1e-15)
    np.testing.assert_allclose(
        scalar_check.stacked(found.D), TRUTH[[0, 4, 8, 1, 2, 5]] - [1, 1, 1, 0, 0, 0], atol=0.003
    )
