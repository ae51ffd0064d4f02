"""The cage by a scalar sensor alone, against the twin: matrix, squareness and ambient field within what is stated."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scalar_lab import SCALAR, sensor

from labcal import session
from labcal.testing import check_procedure
from labcal.twin import open_twin
from labcal.twin.config import TwinTruth

Run = Callable[..., Any]
SHORT = {"n_directions": 24, "dwell_s": 1.0, "verify": 6}


def errors(found: Any, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Found less true of A's upper elements, the ambient field and the currents at zero (12,), and what is stated."""
    data, lab = found.event("scalar-cage").data, open_twin({}, seed)
    Q, A = np.linalg.qr(lab.coil_field.matrix_nT_per_A)
    flip = np.diag(np.sign(np.diag(A)))
    ambient = lab.ambient.slow(np.array(data["t_s"])).mean(axis=0)
    true = np.r_[(flip @ A)[np.triu_indices(3)], flip @ Q.T @ ambient, [TwinTruth().coils.residual_A] * 3]
    matrix = np.array(data["matrix_nT_per_A"])
    told = np.r_[matrix[np.triu_indices(3)], data["ambient_nT"], data["leak_A"]]
    return told - true, np.sqrt(np.diag(data["covariance"]))


def test_matrix_squareness_and_ambient_are_the_twins_within_what_is_stated(ran: Run) -> None:
    found = ran("scalar-cage", sensor(1), 1, SCALAR, **SHORT)
    error, u = errors(found, 1)
    assert np.abs(error / u).max() < 4.5
    assert found.value("verify: rms error with bench.toml's matrix") > 50
    assert found.value("verify: rms error") < 0.7
    assert found.value("components against constant modulus, largest E_n") < 1.6


@pytest.mark.slow
def test_a_verdict_is_as_uncertain_as_the_sensor(ran: Run) -> None:
    given = {"n_directions": 16, "dwell_s": 0.5, "verify": 4, "error_nT": 1000}
    worse = [*SCALAR, ("u_scale_ppm = 1.0", "u_scale_ppm = 1000.0\nu_offset_nT = 200.0")]
    good, bad = ran("scalar-cage", sensor(1), 1, SCALAR, **given), ran("scalar-cage", sensor(1), 1, worse, **given)
    name = "verify: rms error"
    assert bad.measured[name].u == pytest.approx(np.hypot(1e-3 * 50e3, 200.0), rel=0.02)
    assert good.measured[name].u < 1
    said = " ".join(i.text for i in good.items if getattr(i, "kind", "") == "note")
    assert "zero, time" in said
    assert "The supplies' currents." in said


@pytest.mark.slow
def test_errors_over_fifty_labs_in_units_of_their_uncertainty(ran: Run) -> None:
    z, before, after, apart = list[np.ndarray](), list[float](), list[float](), list[float]()
    for seed in range(50):
        found = ran("scalar-cage", sensor(seed), seed, SCALAR, **SHORT)
        error, u = errors(found, seed)
        z.append(error / u)
        before.append(found.value("verify: rms error with bench.toml's matrix"))
        after.append(found.value("verify: rms error"))
        apart.append(found.value("components against constant modulus, largest E_n"))
    within = float(np.mean(np.abs(z) < 2))
    print(f"rms z {np.sqrt(np.mean(np.square(z))):.2f}, within U {within:.3f}, E_n {np.mean(apart):.2f}")
    print(f"rms error {np.sqrt(np.mean(np.square(before))):.1f} -> {np.sqrt(np.mean(np.square(after))):.2f} nT")
    assert 0.8 < np.sqrt(np.mean(np.square(z))) < 1.2
    assert 0.90 < within < 0.99
    assert max(after) < 0.7


def test_a_vector_reference_is_sent_to_cage_calibration(bench_file: Callable[..., Path]) -> None:
    assert "see cage-calibration" in session.run("scalar-cage", bench_file()).status


@pytest.mark.slow
def test_it_leaves_zero_by_every_way_out(bench_file: Callable[..., Path]) -> None:
    given = {"n_directions": "16", "dwell_s": "0.5", "verify": "4"}
    check_procedure("scalar-cage", given, bench=bench_file(sensor(0), *SCALAR), moments=3)
