"""Calibrations of other programs as drafts: their own formula gives the same field, and u is not known."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from labcal.certificate import read_calibration
from labcal.certificate.flight import read_foreign
from labcal.errors import InputError
from labcal.session.foreign_calibration import import_calibration

A = np.array([[1.02, 0.03, -0.01], [0.05, 0.97, 0.02], [-0.02, 0.01, 1.01]])  # not symmetric: it shows rows or columns
b = np.array([12.5, -8.25, 3.0])
READINGS = np.random.default_rng(2).uniform(-60, 60, (50, 3))
MAGNETO = """Combined bias (b):
  12.5 -8.25 3.0
Correction for combined scale factors, misalignments and soft iron (A^-1):
  1.02 0.03 -0.01
  0.05 0.97 0.02
  -0.02 0.01 1.01
unit: mG
serial: M-7
"""


def test_magcal_corrects_rows(tmp_path: Path) -> None:
    savemat(tmp_path / "cal.mat", {"A": A, "b": b[None], "expmfs": 48.5, "serial": "FM-1"})
    draft = read_calibration(import_calibration(tmp_path / "cal.mat", "magcal"))
    found = draft.apply(READINGS)
    np.testing.assert_allclose(found.field_nT, 1e3 * (READINGS - b) @ A, rtol=1e-12, atol=1e-6)
    assert (draft.dut.serial, draft.dut.nominal_nT_per_unit) == ("FM-1", 1000.0)
    assert draft.validity.field_nT == (48500.0, 48500.0)
    assert np.isnan(found.u_nT).all()
    assert "nothing of its uncertainty is known" in draft.not_covered[0]


def test_magneto_corrects_columns_and_its_own_words_are_read(tmp_path: Path) -> None:
    (tmp_path / "magneto.txt").write_text(MAGNETO)
    draft = read_calibration(import_calibration(tmp_path / "magneto.txt", "magneto", tmp_path / "draft.json"))
    np.testing.assert_allclose(draft.apply(READINGS).field_nT, 1e2 * (READINGS - b) @ A.T, rtol=1e-12, atol=1e-6)
    assert draft.dut.serial == "M-7"


@pytest.mark.parametrize(
    ("unit", "field", "nT"), [("nT", 48500, 1), ("uT", 48.5, 1e3), ("mG", 485, 1e2), ("G", 0.485, 1e5)]
)
def test_the_earth_s_field_tells_the_unit(unit: str, field: float, nT: float, tmp_path: Path) -> None:
    text = f"A = [1 0 0; 0 1 0; 0 0 1]; % nothing\nb = [1, 2, 3]\nexpmfs = {field}\n"
    (tmp_path / "a.txt").write_text(text)
    draft = read_foreign(tmp_path / "a.txt", "magcal")
    assert draft.affine.K[0, 0] == nT
    assert f"in {unit}" in draft.not_covered[2]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (b"", "A is missing"),
        (b"1 2 3\n", "before any name"),
        (b"A = 1 2 3\nb = 1 2 3", "A has 3 numbers"),
        (b"A = 1 0 0 0 1 0 0 0 1\nA = 1", "twice"),
        (b"A = 1 0 0 0 1 0 0 0 1\nb = 1 2 3\nwhat = 3", "not known here"),
        (b"A = 1 0 0 0 1 0 0 0 1\nb = 1 2 3\nunit = oersted", "is none of"),
        (b"A = 1 0 0 0 1 0 0 0 1\nb = 1 2 3\nexpmfs = 3", "the Earth's in none"),
        (b"A = 1 0 0 0 1 0 0 0 1e999\nb = 1 2 3", "finite"),
        (b"A = 1e308 0 0 0 1e308 0 0 0 1\nb = 1 2 3", "beyond 1e"),
        (b"\xff\xfe\x00", "neither text"),
        (b"MATLAB 5.0 MAT-file" + bytes(200), "no MATLAB file"),
    ],
)
def test_what_is_no_calibration_is_a_sentence(text: bytes, says: str, tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_bytes(text)
    with pytest.raises(InputError, match=says):
        read_foreign(tmp_path / "a.txt", "magcal")


def test_complex_numbers_are_no_calibration(tmp_path: Path) -> None:
    savemat(tmp_path / "cal.mat", {"A": A + 0.1j, "b": b})
    with pytest.raises(InputError, match="complex"):
        read_foreign(tmp_path / "cal.mat", "magcal")


def test_a_matrix_that_maps_two_readings_to_one_field_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("A = 0 0 0 0 1 0 0 0 1\nb = 1 2 3\n")
    with pytest.raises(InputError, match=r"a\.txt: K: is not invertible"):
        import_calibration(tmp_path / "a.txt", "magneto")
    assert not (tmp_path / "a.calibration.json").exists()


S = np.array([[1.02, 0.03, -0.01], [0.03, 0.97, 0.02], [-0.01, 0.02, 1.01]])
PX4 = """# Vehicle-Id Component-Id Name Value Type
1	1	BAT1_V_DIV	10.1	9
1	1	CAL_MAG0_ID	197388	6
1	1	CAL_MAG0_ROT	4	6
1	1	CAL_MAG0_XCOMP	0.0	9
1	1	CAL_MAG0_XODIAG	0.03	9
1	1	CAL_MAG0_XOFF	0.125	9
1	1	CAL_MAG0_XSCALE	1.02	9
1	1	CAL_MAG0_YODIAG	-0.01	9
1	1	CAL_MAG0_YOFF	-0.0825	9
1	1	CAL_MAG0_YSCALE	0.97	9
1	1	CAL_MAG0_ZODIAG	0.02	9
1	1	CAL_MAG0_ZOFF	0.03	9
1	1	CAL_MAG0_ZSCALE	1.01	9
1	1	CAL_MAG1_XOFF	9	9
"""
ARDUPILOT = """COMPASS_DIA_X,1.02
COMPASS_DIA_Y,0.97
COMPASS_DIA_Z,1.01
COMPASS_MOT_X,0.4
COMPASS_ODI_X 0.03
COMPASS_ODI_Y -0.01
COMPASS_ODI_Z 0.02
COMPASS_OFS2_X,9
COMPASS_OFS_X,-125 # milligauss
COMPASS_OFS_Y,82.5
COMPASS_OFS_Z,-30
COMPASS_SCALE,1.1
"""


@pytest.mark.parametrize(
    ("kind", "text", "scale", "left"),
    [
        ("px4", PX4, 1.0, ["not taken: CAL_MAG0_ROT = 4: the sensor's turn on the board"]),
        ("ardupilot", ARDUPILOT, 1.1, ["not taken: COMPASS_MOT_X = 0.4: what follows throttle or current"]),
    ],
)
def test_an_autopilot_s_parameters_give_what_it_corrects_by(
    kind: str, text: str, scale: float, left: list[str], tmp_path: Path
) -> None:
    (tmp_path / "all.params").write_text(text)
    draft = read_calibration(import_calibration(tmp_path / "all.params", kind, tmp_path / "draft.json"))
    gauss = READINGS / 100
    field = 1e5 * scale * (gauss - [0.125, -0.0825, 0.03]) @ S.T
    given = gauss if kind == "px4" else 1000 * gauss
    np.testing.assert_allclose(draft.apply(given).field_nT, field, rtol=1e-12, atol=1e-6)
    assert [one for one in draft.not_covered if one.startswith("not taken")] == left
    assert f"unit of {kind}'s parameters" in draft.not_covered[2]


def test_what_an_autopilot_leaves_unsaid_is_one_or_nought(tmp_path: Path) -> None:
    plain = "".join(f"COMPASS_OFS_{a},{v}\nCOMPASS_DIA_{a},0\n" for a, v in zip("XYZ", (1, 2, 3), strict=True))
    (tmp_path / "a.param").write_text(plain)
    found = read_foreign(tmp_path / "a.param", "ardupilot").affine
    np.testing.assert_allclose(found.K, 100 * np.eye(3))
    np.testing.assert_allclose(found.k_nT, [-100, -200, -300])


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "CAL_MAG0_XOFF is missing"),
        (PX4.replace("CAL_MAG0_ZOFF	0.03	9", "CAL_MAG0_ZOFF"), "CAL_MAG0_ZOFF has no number"),
        (PX4.replace("-0.0825", "nan"), "CAL_MAG0_YOFF is not finite"),
        (PX4 + PX4, "line 18: states CAL_MAG0_ID twice"),
    ],
)
def test_parameters_that_are_not_whole_are_a_sentence(text: str, says: str, tmp_path: Path) -> None:
    (tmp_path / "a.params").write_text(text)
    with pytest.raises(InputError, match=says):
        read_foreign(tmp_path / "a.params", "px4")
