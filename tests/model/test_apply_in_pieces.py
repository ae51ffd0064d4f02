"""A recording applied some rows at a time gives what it gives in one: to the last sign that is written."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.model.apply import apply, apply_in_pieces
from labcal.model.readings import Readings
from labcal.record import Dut

ROWS = 400
CURRENT = ("offset-current", ("i",), {"i": 0.2}, {"c_x": 50.0, "c_y": -3.0, "c_z": 10.0})
WARMTH = ("gain-temperature", ("temp",), {"temp": 20.0}, {"g_x": 1e-4, "g_y": 2e-4, "g_z": -1e-4})
DRIFT = ("offset-drift", (), {}, {"c1_x": 0.4, "c1_y": 0.2, "c1_z": -0.1, "t_ref_s": 10.0})
MODES = ("offset-mode", (), {}, {"c_x quiet": 20.0, "c_y quiet": 2.0, "c_z quiet": -5.0})
LAG = ("lag", (), {}, {"lag_s": 0.05, "secant_s": 0.05})
LOOP = ("hysteresis", (), {}, {"c_x": 0.02, "c_y": 0.03, "c_z": 0.01, "r_nT": 4000.0})
LATE = ("offset-current", ("i",), {"i": 0.2}, {"c_x": 50.0, "c_y": -3.0, "c_z": 10.0, "tau_s": 3.0})


def calibration(*effects: tuple) -> Calibration:
    return Calibration(
        run_id="r",
        simulated=True,
        dut=Dut(serial="S"),
        affine=AffineMap(np.diag([1.1, 0.9, 1.0]), np.array([100.0, -200.0, 300.0])),
        covariance=np.diag([1e-8] * 9 + [4.0] * 3),
        frame_known=True,
        validity=Validity((25e3, 33e3), temperature_C=(15.0, 25.0), modes=("nominal", "quiet")),
        span_s=(0.0, 30.0),
        run_sha256="0" * 64,
        effects=tuple(
            EffectRecord(
                name, channels, reference, "sensor", tuple(Parameter(k, v, abs(v) / 10, "") for k, v in values.items()),
                holdout_rms_before_nT=30.0, holdout_rms_after_nT=12.0,
            )
            for name, channels, reference, values in effects
        ),
        metrics={"before": {}, "after": {"noise_nT": 10.0, "holdout_rms_nT": 25.0}},
    )  # fmt: skip


def recording(seed: int) -> Readings:
    """Turns in three segments, with outliers, a rail, gaps of readings and channels, and rows of an unknown mode."""
    rng = np.random.default_rng(seed)
    turn = np.linspace(0, 9, ROWS)
    reading = 30e3 * np.column_stack([np.cos(turn), np.sin(turn), 0.3 * np.cos(2 * turn)]) + rng.normal(
        0, 10, (ROWS, 3)
    )
    reading[rng.random(ROWS) < 0.02] += [4e3, 0, 0]
    reading[:, 0] = np.minimum(reading[:, 0], 29.8e3)
    reading[rng.random(ROWS) < 0.02, 1] = np.nan
    load = np.where(np.sin(7 * turn) > 0, 0.4, 0.1)
    load[rng.random(ROWS) < 0.05] = np.nan
    load[120:170] = np.nan
    temperature = 20 + 7 * np.sin(turn / 3) + rng.normal(0, 0.01, ROWS)
    modes = np.array(["nominal", "quiet", "loud", ""])[rng.integers(0, 4, ROWS)]
    segment = np.searchsorted(np.sort(rng.integers(0, ROWS, 3)), np.arange(ROWS), side="right")
    return Readings(reading, np.linspace(0, 40, ROWS), segment, modes, {"i": load, "temp": temperature})


def written(field_nT: np.ndarray, u_nT: np.ndarray) -> list[str]:
    return [f"{x:.3f} {y:.3f} {z:.3f} {u:.3f}" for (x, y, z), u in zip(field_nT, u_nT, strict=True)]


@pytest.mark.parametrize(
    "effects",
    [(), (CURRENT, WARMTH), (DRIFT, MODES, CURRENT), (LAG,), (LOOP, CURRENT), (LATE, LAG)],
    ids=["map", "channels", "time-and-mode", "lag", "loop", "late"],
)
@settings(max_examples=12)
@given(most=st.integers(5, ROWS + 10), seed=st.integers(0, 3))
def test_pieces_of_any_size_give_what_the_whole_gives(effects: tuple, most: int, seed: int) -> None:
    cal, readings = calibration(*effects), recording(seed)
    whole, pieces = apply(cal, readings), list(apply_in_pieces(cal, readings, most))
    field, u = (np.concatenate([getattr(p, name) for p in pieces]) for name in ("field_nT", "u_nT"))
    assert written(field, u) == written(whole.field_nT, whole.u_nT)
    assert tuple(flag for piece in pieces for flag in piece.flags) == whole.flags


def test_the_recordings_have_what_rows_take_from_the_whole() -> None:
    flags = [flag for seed in range(4) for flag in apply(calibration(CURRENT), recording(seed)).flags]
    found = set(" ".join(flags).split())
    assert {"outlier", "saturated", "field", "mode"} <= found


def test_what_does_not_remember_is_done_in_pieces_and_what_does_from_segment_to_segment() -> None:
    readings = recording(1)
    changes = 1 + np.flatnonzero(np.diff(readings.segment))
    assert [len(p.u_nT) for p in apply_in_pieces(calibration(CURRENT), readings, 150)] == [150, 150, 100]
    found = np.cumsum([len(p.u_nT) for p in apply_in_pieces(calibration(LAG), readings, 150)])
    assert set(found[:-1]) <= set(changes)
    assert len(found) > 1
    assert [len(p.u_nT) for p in apply_in_pieces(calibration(LATE), readings, 150)] == [ROWS]
