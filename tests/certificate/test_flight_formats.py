"""Calibrations as JSON, MATLAB file and parameters of autopilots, by the command."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat

from labcal.certificate.calibration_file import calibration_bytes
from labcal.cli import execute as labcal
from labcal.model import AffineMap, Calibration

S = np.array([[1.05, 0.02, -0.01], [0.02, 0.96, 0.03], [-0.01, 0.03, 1.01]])
m = np.random.default_rng(1).uniform(-400, 400, (20, 3))  # counts of 100 nT: milligauss


@pytest.fixture
def plain(calibration: Calibration) -> Calibration:
    """A symmetric map without effects."""
    affine = AffineMap(100 * S, np.array([1200.0, -800.0, 300.0]))
    dut = replace(calibration.dut, nominal_nT_per_unit=100.0)
    return replace(calibration, affine=affine, dut=dut, effects=(), covariance_of=calibration.covariance_of[:12])


def written(calibration: Calibration, folder: Path) -> Path:
    path = folder / "cal.json"
    path.write_bytes(calibration_bytes(calibration))
    return path


def parameters(file: Path, apart: str, name: int, value: int) -> dict[str, float]:
    rows = [line.split(apart) for line in file.read_text().splitlines() if not line.startswith("#")]
    return {row[name]: float(row[value]) for row in rows}


def matrix(p: dict[str, float], diagonal: str, off: str) -> np.ndarray:
    d, (xy, xz, yz) = [p[diagonal.format(a)] for a in "XYZ"], [p[off.format(a)] for a in "XYZ"]
    return np.array([[d[0], xy, xz], [xy, d[1], yz], [xz, yz, d[2]]])


def test_px4_s_formula_in_gauss_gives_the_field(plain: Calibration, tmp_path: Path) -> None:
    assert labcal(["export", str(written(plain, tmp_path)), "--format", "px4", "--out", str(tmp_path / "out")]) == 0
    p = parameters(tmp_path / "out" / "labcal_px4.params", "\t", 2, 3)
    o = np.array([p[f"CAL_MAG0_{a}OFF"] for a in "XYZ"])
    gauss = (m * 1e-3 - o) @ matrix(p, "CAL_MAG0_{}SCALE", "CAL_MAG0_{}ODIAG").T
    np.testing.assert_allclose(gauss * 1e5, plain.affine.apply(m), atol=1e-3)


def test_ardupilot_s_formula_in_milligauss_gives_the_field(plain: Calibration, tmp_path: Path) -> None:
    assert (
        labcal(["export", str(written(plain, tmp_path)), "--format", "ardupilot", "--out", str(tmp_path / "out")]) == 0
    )
    p = parameters(tmp_path / "out" / "labcal_ardupilot.param", ",", 0, 1)
    o = np.array([p[f"COMPASS_OFS_{a}"] for a in "XYZ"])
    milligauss = (m + o) @ matrix(p, "COMPASS_DIA_{}", "COMPASS_ODI_{}").T
    np.testing.assert_allclose(milligauss * 1e2, plain.affine.apply(m), atol=1e-2)


@pytest.mark.parametrize("format_", ["px4", "ardupilot"])
def test_what_an_autopilot_cannot_hold_is_refused_by_name(
    format_: str, plain: Calibration, calibration: Calibration, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    turned = replace(plain, affine=AffineMap(plain.affine.K @ [[1, -0.02, 0], [0.02, 1, 0], [0, 0, 1]], np.zeros(3)))
    for made, says in ((calibration, "effects[0]: offset-current of i_eps"), (turned, "turns the axes by 1.1")):
        assert labcal(["export", str(written(made, tmp_path)), "--format", format_, "--out", str(tmp_path / "o")]) == 2
        assert says in capsys.readouterr().err
    assert not (tmp_path / "o").exists()


def test_json_and_mat_hold_what_c_holds(calibration: Calibration, tmp_path: Path) -> None:
    path = str(written(calibration, tmp_path))
    for format_ in ("json", "mat"):
        assert labcal(["export", path, "--format", format_, "--out", str(tmp_path)]) == 0
    told = json.loads((tmp_path / "labcal_calibration.json").read_text())
    there = loadmat(tmp_path / "labcal_calibration.mat", simplify_cells=True)["calibration"]
    np.testing.assert_array_equal(there["K"], calibration.affine.K)
    assert there["calibration_sha256"] == told["calibration_sha256"]
    assert there["covariance"].shape == (15, 15)
    assert told["effects"][0]["parameters"][0] == {"name": "c_x", "value": 112.5, "u": 0.4, "unit": "nT/A"}
    assert told["status"].startswith("UNSIGNED")


def test_an_export_says_what_is_wrong_with_the_request(
    calibration: Calibration, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, out = str(written(calibration, tmp_path)), str(tmp_path / "out")
    for more, says in (
        (["--format", "hdf5"], "is a calibration, and hdf5 is no format of one"),
        (["--format", "json", "--require-signature"], "is unsigned"),
    ):
        assert labcal(["export", path, *more, "--out", out]) == 2
        assert says in capsys.readouterr().err
    assert labcal(["export", "some-run", "--format", "c", "--out", out]) == 2
    assert "is a run, and c is no format of one" in capsys.readouterr().err
    assert labcal(["export", path, "--format", "json", "--out", path]) == 2
    assert not Path(out).exists()
