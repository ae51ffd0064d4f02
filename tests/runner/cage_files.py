"""An approved cage calibration of the example's lab, and a bench file that names it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from labcal.bench.coils.cage_file import CageCalibration, Place

MATRIX = ((49942.0, -221.0, 169.0), (-301.0, 49951.0, 101.0), (-179.0, 151.0, 49944.0))


def with_the_file(bench: Path) -> Path:
    """The bench file with the cage calibration beside it in place of its matrix."""
    text = bench.read_text(encoding="utf-8")
    start, end = text.index("matrix_nT_per_A"), text.index("settle_s")
    bench.write_text(text[:start] + 'calibration = "cage.json"\n' + text[end:], encoding="utf-8")
    return bench


def a_calibration(matrix: np.ndarray, offset: np.ndarray, u: float = 2.0) -> CageCalibration:
    """As approved: the bench's own matrix at the DUT, and `matrix`, `offset` beyond the reference's place."""
    covariance = (u**2 * np.eye(12)).tolist()
    at_dut = Place(matrix_nT_per_A=MATRIX, offset_nT=(0.0, 0.0, 0.0), covariance=covariance)
    carry = Place(matrix_nT_per_A=matrix.tolist(), offset_nT=offset.tolist(), covariance=covariance)
    return CageCalibration(
        run_id="C", simulated=True, measured_utc="2026-11-21T07:00:00Z", operator="J. Doe", approved_by="R. Roe",
        dut=at_dut, carry=carry, reference_position_m=(0.0, 0.0, 0.3),
    )  # fmt: skip
