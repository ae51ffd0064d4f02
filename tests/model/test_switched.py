"""A load that was switched between two samples of its telemetry: what is not known of it is in the uncertainty."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.model.apply import apply
from labcal.model.readings import Applied, Readings
from labcal.record import Dut

NOISE_nT = 2.0
C_nT_A = np.array([300.0, -200.0, 100.0])
EVERY = 8  # rows from sample to sample


def calibration(delay_s: float | None = None) -> Calibration:
    late = () if delay_s is None else (Parameter("delay_s", delay_s, 0.0, "s"),)
    along = (Parameter(f"c_{axis}", c, 0.0, "nT/A") for axis, c in zip("xyz", C_nT_A, strict=True))
    load = EffectRecord("offset-current", ("i_heater",), {"i_heater": 0.0}, "sensor", (*along, *late))
    return Calibration(
        run_id="r", simulated=True, dut=Dut(serial="S"), affine=AffineMap(np.eye(3), np.zeros(3)),
        covariance=np.zeros((12, 12)), frame_known=True, validity=Validity((20e3, 40e3)), span_s=(0.0, 1e6),
        run_sha256="0" * 64, effects=(load,), metrics={"before": {}, "after": {"noise_nT": NOISE_nT}},
    )  # fmt: skip


def switched(late_rows: int = 0) -> tuple[np.ndarray, Applied]:
    """Errors (n, 3) and what `apply` says, of a load switched at moments that its telemetry did not see."""
    rng, n = np.random.default_rng(5), 40_000
    moments = np.cumsum(rng.integers(6 * EVERY, 12 * EVERY, n // EVERY))
    load = np.searchsorted(moments, np.arange(n), side="right") % 2 * 0.8
    seen = np.interp(np.arange(n), np.arange(0, n, EVERY), load[::EVERY])
    acts = np.concatenate([np.full(late_rows, load[0]), load[: n - late_rows]])
    field = np.array([30e3, 0.0, 0.0]) + rng.normal(0, NOISE_nT, (n, 3))
    found = apply(
        calibration(None if not late_rows else float(late_rows)),
        Readings(field + np.outer(acts, C_nT_A), np.arange(float(n)), np.zeros(n), channels={"i_heater": seen}),
    )
    return found.field_nT - [30e3, 0.0, 0.0], found


@pytest.mark.parametrize("late_rows", [0, 5])
def test_the_error_on_the_way_from_level_to_level_is_as_large_as_its_uncertainty(late_rows: int) -> None:
    error, found = switched(late_rows)
    unsure = found.u_nT > 1.001 * NOISE_nT
    assert 0.05 < np.mean(unsure) < 0.2
    part = np.sqrt(np.mean(error[unsure] ** 2, axis=1)) / found.u_nT[unsure]
    assert np.sqrt(np.mean(part**2)) == pytest.approx(1.0, abs=0.1)
    assert np.sqrt(np.mean(error[~unsure] ** 2)) == pytest.approx(NOISE_nT, rel=0.05)


def test_a_load_that_is_seen_to_switch_and_one_that_never_rests_are_known() -> None:
    n = np.arange(400)
    for seen in ((n // 40 % 2).astype(float), np.sin(n / 30)):
        reading = np.array([30e3, 0.0, 0.0]) + np.outer(seen, C_nT_A)
        found = apply(calibration(), Readings(reading, n * 1.0, np.zeros(400), channels={"i_heater": seen}))
        assert found.u_nT == pytest.approx(NOISE_nT)


@pytest.mark.parametrize("rows_of_a_segment", [40_000, 37])
def test_so_it_is_where_one_sample_saw_a_pulse_and_where_a_segment_ends_on_the_way(rows_of_a_segment: int) -> None:
    """Drawn there and back again, the load seems to end where it began: it was away all the same."""
    rng, n = np.random.default_rng(7), 40_000
    moments = np.cumsum(np.where(rng.random(n // EVERY) < 0.5, rng.integers(EVERY, 2 * EVERY, n // EVERY), 8 * EVERY))
    load = np.searchsorted(moments, np.arange(n), side="right") % 2 * 0.8
    seen = np.interp(np.arange(n), np.arange(0, n, EVERY), load[::EVERY])
    field = np.array([30e3, 0.0, 0.0]) + rng.normal(0, NOISE_nT, (n, 3))
    readings = Readings(
        field + np.outer(load, C_nT_A), np.arange(float(n)), np.arange(n) // rows_of_a_segment,
        channels={"i_heater": seen},
    )  # fmt: skip
    found = apply(calibration(), readings)
    error = found.field_nT - [30e3, 0.0, 0.0]
    between = (seen > 0.01) & (seen < 0.79)
    part = np.sqrt(np.mean(error[between] ** 2, axis=1)) / found.u_nT[between]
    assert np.sqrt(np.mean(part**2)) == pytest.approx(1.0, abs=0.15)
