"""A clock that is off and runs at another rate: found as a lag that grows, and taken off on its own clock only."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.certificate.flight.content import content_of
from labcal.fit import draft_calibration
from labcal.geometry import rotate
from labcal.loop import close_loop
from labcal.model.apply import apply, apply_in_pieces
from labcal.model.readings import Readings, readings_of


def _by_a_wrong_clock(making: ModuleType, folder: Path, lag_s: float, ppm: float) -> tuple[Path, np.ndarray]:
    """A run whose readings stamped t belong to the field at t − lag, and the field at t (n, 3) in B."""
    rows, segments = making.recorded()
    draw, t = np.random.default_rng(3), rows["t_s"]
    truth, middle = np.zeros_like(rows["dut"]), (t[0] + t[-1]) / 2
    for segment in segments:
        here, axis = rows["segment"] == segment["id"], np.array(segment["axis_body"])

        def angle(at_s: np.ndarray, start: float = float(t[here][0])) -> np.ndarray:
            return np.radians(6 * (at_s - start)) + 0.4 * (1 - np.cos((at_s - start) / 4))

        early = t[here] - (lag_s + 1e-6 * ppm * (t[here] - middle))
        rows["angle"][here] = angle(t[here])
        truth[here] = rotate(axis, -angle(t[here]), rows["ref"][here])
        rows["dut"][here] = 1.05 * rotate(axis, -angle(early), rows["ref"][here]) + 800
    rows["dut"] = rows["dut"] + draw.normal(0, making.NOISE_nT, truth.shape)
    return making.written(folder, rows, segments), truth


@pytest.mark.parametrize(("lag_s", "ppm"), [(0.0, 150.0), pytest.param(-0.4, 2000.0, marks=pytest.mark.slow)])
def test_a_clock_that_drifts_is_a_lag_that_grows(making: ModuleType, tmp_path: Path, lag_s: float, ppm: float) -> None:
    bundle, truth = _by_a_wrong_clock(making, tmp_path / "run", lag_s, ppm)
    run = session.load_run(str(bundle))
    closed = close_loop(run)
    assert ([e.effect for e in closed.accepted], closed.verdict) == (["lag"], "explained")
    found = {p.name: p for p in closed.accepted[0].parameters}
    assert abs(found["lag_s"].value - lag_s) < 4 * found["lag_s"].u
    assert abs(found["drift_ppm"].value - ppm) < 4 * found["drift_ppm"].u
    assert found["drift_ppm"].u < 5

    calibration = draft_calibration(run, closed.fit(), "")
    readings = readings_of(run)
    applied = apply(calibration, readings)
    inside = np.array([flag == "" for flag in applied.flags])
    wrong = np.linalg.norm(applied.field_nT[inside] - truth[inside], axis=1)
    assert np.sqrt(np.mean(wrong**2)) < 1.1 * np.sqrt(3) * making.NOISE_nT / 1.05
    assert inside.mean() > 0.97
    parts = list(apply_in_pieces(calibration, readings, 50))
    assert np.allclose(np.concatenate([part.field_nT for part in parts]), applied.field_nT, atol=1e-6)

    later = Readings(readings.reading, readings.t_s + 1e5, readings.segment, readings.mode, readings.channels)
    assert all("time" in flag for flag in apply(calibration, later).flags)
    assert [e.effect for e in content_of(calibration, b"", "").left_out] == ["lag"]


@pytest.mark.slow
def test_a_clock_that_is_merely_off_does_not_drift(making: ModuleType, tmp_path: Path) -> None:
    bundle, _ = _by_a_wrong_clock(making, tmp_path / "run", 0.25, 0.0)
    (lag,) = close_loop(session.load_run(str(bundle))).accepted
    assert [p.name for p in lag.parameters] == ["lag_s", "secant_s"]
