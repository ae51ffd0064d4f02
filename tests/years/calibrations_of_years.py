"""Calibrations as the years bring them: one sensor or many, whose figures are stated."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from hashlib import sha256
from pathlib import Path

import numpy as np

from labcal.certificate import calibration_bytes, read_calibration
from labcal.model import AffineMap, Calibration, EffectRecord
from labcal.model.records import Parameter

GOLDEN = Path(__file__).parents[1] / "golden" / "calibration-2.json"
FIRST = datetime(2016, 3, 1, 8, tzinfo=UTC)


def calibrated(
    serial: str = "EM-1",
    *,
    day: float = 0.0,
    offset_nT: tuple[float, float, float] = (10.0, 20.0, 30.0),
    u_nT: float = 1.0,
    model: str = "EM",
    slope: tuple[float, float] | None = None,
) -> Calibration:
    """Measured `day` days after the first; `slope` (value, u) is that of an offset-temperature [nT/degC], if found."""
    golden = read_calibration(GOLDEN)
    effects = (_temperature(*slope),) if slope is not None else ()
    return replace(
        golden,
        run_id=f"{serial}-{day:g}",
        run_sha256=sha256(f"{serial} {day}".encode()).hexdigest(),
        dut=replace(golden.dut, serial=serial, model=model, unit="nT", nominal_nT_per_unit=1.0),
        affine=AffineMap(np.eye(3), np.array(offset_nT)),
        covariance=np.diag([1e-10] * 9 + [u_nT**2] * 3),
        covariance_of=golden.covariance_of[:12],
        effects=effects,
        findings=(),
        k_at={},
        budget=(),
        simulated=False,
        issued_utc=(FIRST + timedelta(days=day)).isoformat(timespec="milliseconds").replace("+00:00", "Z"),
    )


def kept(folder: Path, *calibrations: Calibration) -> list[Path]:
    """Each as a file."""
    paths = []
    for one in calibrations:
        path = folder / f"{one.run_id}.json"
        path.write_bytes(calibration_bytes(one))
        paths.append(path)
    return paths


def three_batches(folder: Path) -> Path:
    """Three batches of ten sensors; batch C drifts with temperature by 3.1 nT/K, and B-4 has an offset of its own."""
    draw, made = np.random.default_rng(1), []
    for batch, slope in (("A", 0.2), ("B", 0.1), ("C", 3.1)):
        for i in range(10):
            x = 900.0 if (batch, i) == ("B", 4) else draw.normal(0, 10)
            found = slope + draw.normal(0, 0.5)
            effect = (found, 0.3) if abs(found) > 0.6 else None
            made.append(calibrated(f"{batch}-{i}", offset_nT=(x, *draw.normal(0, 10, 2)), slope=effect))
    folder.mkdir()
    kept(folder, *made)
    return folder


def _temperature(value: float, u: float) -> EffectRecord:
    parameters = tuple(Parameter(f"c_{axis}", value, u, "nT/degC") for axis in "xyz")
    return EffectRecord("offset-temperature", ("temp_dut",), {"temp_dut": 20.0}, "sensor", parameters)
