import numpy as np
import pytest
import springmann
from springmann import SENSORS, calibrate, fly, normalised

from labcal.fit.scalar import foster_elkaim
from labcal.fit.scalar.scalar_check import Estimate


@pytest.mark.parametrize("sensor", SENSORS, ids=lambda s: s.name)
def test_each_telemetry_brings_the_rms_down_as_printed(sensor):
    flight = fly(sensor, 0)
    for columns, printed in zip((0, 4, 5), sensor.printed_rms_nT, strict=True):
        _, rms = calibrate(flight, sensor.noise_nT, columns)
        assert rms == pytest.approx(printed, rel=0.1)


@pytest.mark.parametrize("sensor", SENSORS, ids=lambda s: s.name)
def test_parameters_are_recovered_within_their_uncertainties(sensor):
    found, _ = calibrate(fly(sensor, 1), sensor.noise_nT, 5)
    u = np.sqrt(np.diag(found.covariance)[9:]).reshape(-1, 3)
    T, _ = springmann.sensor_matrix(sensor)
    truth = fly(sensor, 1).s @ np.linalg.inv(symmetric_root(T)).T
    np.testing.assert_array_less(np.abs(found.e - truth) / u, 4)
    assert np.abs(normalised(sensor, 1)).max() < 4


def symmetric_root(T):
    """(T Tᵀ)^½: T as magnitudes see it."""
    values, vectors = np.linalg.eigh(T @ T.T)
    return vectors * np.sqrt(values) @ vectors.T


@pytest.mark.slow
@pytest.mark.parametrize("sensor", SENSORS, ids=lambda s: s.name)
def test_errors_are_as_large_as_their_uncertainties_over_thirty_seeds(sensor):
    z = np.array([normalised(sensor, seed) for seed in range(30)])
    assert np.sqrt(np.mean(z**2)) == pytest.approx(1, abs=0.15)


def test_the_simulated_sensor_has_the_printed_parameters():
    T, offset = springmann.sensor_matrix(SENSORS[0])
    K = np.linalg.inv(symmetric_root(T))
    axes = foster_elkaim.parameters(Estimate(K @ offset, K - np.eye(3), lambda: np.eye(9)))
    np.testing.assert_allclose(
        springmann.in_paper_units(axes)[[0, 1, 2, 6, 7, 8]], np.array(SENSORS[0].printed)[[0, 1, 2, 6, 7, 8]]
    )
