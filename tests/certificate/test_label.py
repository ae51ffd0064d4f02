"""The label for the DUT: what it says, that all of it is on it, and that its code is that of the certificate."""

from __future__ import annotations

import sys
from dataclasses import replace
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import Signer, Verification, calibration_bytes, sign, verify
from labcal.certificate.report.front import code_text
from labcal.certificate.report.label import label_lines, write_label
from labcal.errors import InputError
from labcal.model import Calibration

NOW = datetime(2026, 11, 21, tzinfo=UTC)


@pytest.fixture
def issued(calibration: Calibration) -> Calibration:
    validity = replace(calibration.validity, until="2027-11-21")
    return replace(calibration, simulated=False, number="FL-CAGE-2026-0007", validity=validity, approvers=("bob",))


def checked(path: Path, c: Calibration) -> Verification:
    path.write_bytes(calibration_bytes(c))
    return verify(path, (), frozenset(), NOW)


def test_a_label_says_whose_which_until_when_and_its_number(
    issued: Calibration, tmp_path: Path, lab: tuple[Signer, ...], key: Ed25519PrivateKey
) -> None:
    file = tmp_path / "cal.json"
    draft = checked(file, issued)
    assert label_lines(issued, draft, "Field Laboratory", "2026-11-20")[4] == "DRAFT, NOT SIGNED"
    sign(file, "ada", key, lab)
    said = label_lines(issued, verify(file, lab, frozenset(), NOW), "Field Laboratory", "2026-11-20")
    assert said == (
        "Field Laboratory", issued.dut.serial, "calibrated 2026-11-20, good until 2027-11-21", "FL-CAGE-2026-0007", "",
    )  # fmt: skip
    bare = replace(issued, simulated=True, number=None, validity=replace(issued.validity, until=None))
    assert label_lines(bare, draft, "", "") == (
        "", issued.dut.serial, "", f"run {issued.run_id}", "SIMULATED · DRAFT, NOT SIGNED",
    )  # fmt: skip


def test_the_code_of_a_label_is_that_of_the_certificate(issued: Calibration) -> None:
    digest = sha256(calibration_bytes(issued)).hexdigest()
    assert code_text(issued, digest) == f"FL-CAGE-2026-0007 sha256:{digest}"


@pytest.mark.parametrize("serial", ["EM-07", "FLUXGATE-MAGNETOMETER-OF-THE-SECOND-SATELLITE-0001"])
def test_nothing_on_a_label_is_cut(issued: Calibration, tmp_path: Path, serial: str) -> None:
    pytest.importorskip("segno")
    from matplotlib.image import imread

    named = replace(issued, simulated=True, dut=replace(issued.dut, serial=serial))
    out = tmp_path / "label.png"
    write_label(named, checked(tmp_path / "cal.json", named), "Field Laboratory of the University", "2026-11-20", out)
    picture = imread(out)[:, :, :3].min(axis=2)
    rows, columns = picture.shape
    assert columns / rows == pytest.approx(62 / 29, rel=0.01)
    edge = round(columns * 1.5 / 62)
    for strip in (picture[:edge], picture[-edge:], picture[:, :edge], picture[:, -edge:]):
        assert strip.min() == 1.0  # white: all stands within the label, the code's quiet zone is quiet
    assert picture[:, columns // 2 :].min() < 0.5


@pytest.mark.parametrize("form", ["pdf", "svg"])
def test_the_same_label_is_the_same_bytes(issued: Calibration, tmp_path: Path, form: str) -> None:
    pytest.importorskip("segno")
    found = checked(tmp_path / "cal.json", issued)
    made = [tmp_path / f"{n}.{form}" for n in (1, 2)]
    for out in made:
        write_label(issued, found, "Field Laboratory", "2026-11-20", out)
    assert made[0].read_bytes() == made[1].read_bytes()


def test_a_label_that_cannot_be_made_says_why(
    issued: Calibration, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = checked(tmp_path / "cal.json", issued)
    with pytest.raises(InputError, match=r"a label ends in .pdf or .svg or .png"):
        write_label(issued, found, "", "", tmp_path / "label.html")
    monkeypatch.setitem(sys.modules, "segno", None)
    with pytest.raises(InputError, match=r"pip install 'labcal\[paper\]'"):
        write_label(issued, found, "", "", tmp_path / "label.pdf")
    assert not (tmp_path / "label.pdf").exists()
