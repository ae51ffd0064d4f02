"""Readings at the end of a device's range are flagged; rounded ones that turn or rest there are not."""

from __future__ import annotations

import tracemalloc

import numpy as np

from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.model.apply import apply
from labcal.model.plausibility import saturated, saturation_limits
from labcal.model.readings import Readings
from labcal.record import Dut

K, k = np.array([[1.1, 0.1, 0.0], [0.0, 0.9, -0.1], [0.05, 0.0, 1.0]]), np.array([100.0, -200.0, 300.0])
TURN = np.linspace(0, 6, 400)
FIELD = 30e3 * np.column_stack([np.cos(TURN), np.sin(TURN), 0.3 * np.cos(2 * TURN)])


def readings() -> Readings:
    """The noiseless readings of the field."""
    return Readings(np.linalg.solve(K, (FIELD + k).T).T)


def calibration(*findings: EffectRecord) -> Calibration:
    """The map alone, with what its run found in the data."""
    return Calibration(
        "r", True, Dut(serial="S"), AffineMap(K, k), None, True, Validity((20e3, 40e3)), (0.0, 1000.0), "0" * 64,
        metrics={"before": {}, "after": {"noise_nT": 10.0}}, findings=findings,
    )  # fmt: skip


def test_a_plateau_at_the_end_of_the_range_is_saturated() -> None:
    clipped = readings().reading.copy()
    clipped[:, 0] = np.minimum(clipped[:, 0], 24e3)
    found = apply(calibration(), Readings(clipped))
    expected = np.flatnonzero(clipped[:, 0] == 24e3)
    assert [i for i, flag in enumerate(found.flags) if "saturated" in flag] == expected.tolist()


def test_a_rounded_reading_that_turns_at_its_largest_value_is_not_saturated() -> None:
    """Steps of 50 nT: a slow turn stands on the last of them for ten rows, and one that is cut off for more."""
    t = np.linspace(0, 6, 600)
    turning = np.column_stack([40e3 * np.sin(t), 20e3 * np.cos(t), 15e3 * np.cos(2 * t)])
    rounded = 50 * np.round(turning / 50)
    assert ((rounded == rounded.max(axis=0)).sum(axis=0) >= 3).any()
    assert not any("saturated" in flag for flag in apply(calibration(), Readings(rounded)).flags)
    rounded[:, 0] = np.minimum(rounded[:, 0], 38e3)
    flags = apply(calibration(), Readings(rounded)).flags
    assert [i for i, flag in enumerate(flags) if "saturated" in flag] == np.flatnonzero(rounded[:, 0] == 38e3).tolist()


def test_a_device_at_rest_whose_rounded_reading_stands_still_is_not_saturated() -> None:
    """Five attitudes; along x the noise is below the step, along y and z it moves by 1e-3 of the field."""
    rng = np.random.default_rng(4)
    at_rest = np.repeat(30e3 * np.vstack([np.eye(3), -np.eye(3)]), 40, axis=0)
    at_rest[:, 1:] += rng.normal(0, 30.0, (len(at_rest), 2))
    flags = apply(calibration(), Readings(50 * np.round(at_rest / 50))).flags
    assert not any("saturated" in flag for flag in flags)


def test_the_runs_own_saturation_limit_is_used() -> None:
    limit = EffectRecord("saturation", (), {}, "data", (Parameter("upper_y", 20e3, 0.0, "nT"),))
    measured = readings()
    found = apply(calibration(limit), measured)
    expected = np.flatnonzero(measured.reading[:, 1] >= 20e3)
    assert [i for i, flag in enumerate(found.flags) if "saturated" in flag] == expected.tolist()


def test_rails_of_a_run_become_limits_that_flag_single_readings() -> None:
    clipped = readings().reading.copy()
    clipped[:, 0] = np.minimum(clipped[:, 0], 24e3)
    finding = saturation_limits(clipped, "nT")
    assert [(p.name, p.value) for p in finding.parameters] == [("upper_x", 24e3)]
    assert saturation_limits(readings().reading, "nT") is None
    found = apply(calibration(finding), Readings(np.array([[24e3, 0.0, 0.0], [0.0, 0.0, 24e3]])))
    assert ["saturated" in flag for flag in found.flags] == [True, False]


def test_it_takes_the_memory_of_a_column_at_a_time() -> None:
    """Ten million rows are read in under 1 GB; with copies of all columns at once it was 1.2."""
    n = 200_000
    reading = np.random.default_rng(0).uniform(-4e4, 4e4, (n, 3))
    tracemalloc.start()
    try:
        saturated(calibration(), reading)
        assert tracemalloc.get_traced_memory()[1] < 35 * n
    finally:
        tracemalloc.stop()
