"""A calibration copied for somebody else replaces nothing that is another's."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from labcal.certificate import hand_out
from labcal.certificate.signing import signature_files
from labcal.errors import InputError
from labcal.record.run_id import name_outside

GOLDEN = Path(__file__).parents[1] / "golden" / "calibration-1.json"


def test_what_another_file_stands_for_is_kept_and_nothing_is_copied(tmp_path: Path) -> None:
    own, folder = tmp_path / "own", tmp_path / "given"
    own.mkdir(), folder.mkdir()
    calibration = own / "cal.json"
    shutil.copy(GOLDEN, calibration)
    (own / "cal.json.sshsig").write_text("of Ada")
    for name, content in (("cal.json", b"another"), ("cal.json.sshsig", b"of Bob"), ("allowed_signers", b"theirs")):
        (folder / name).write_bytes(content)
        with pytest.raises(InputError, match="is there already"):
            hand_out(calibration, folder, [])
        assert [(path.name, path.read_bytes()) for path in folder.iterdir()] == [(name, content)]
        (folder / name).unlink()
    hand_out(calibration, folder, [])
    (own / "cal.json.2.sshsig").write_text("of Eve")
    hand_out(calibration, folder, [])  # once more, with a second signature
    assert {path.name for path in folder.iterdir()} == {path.name for path in own.iterdir()} | {"allowed_signers"}


def test_outside_it_is_called_by_serial_and_run_with_its_signatures_after_it_and_its_content_is_the_same(
    tmp_path: Path,
) -> None:
    calibration = tmp_path / "20261129T054647-904f.json"
    shutil.copy(GOLDEN, calibration)
    for number in ("", ".2"):
        (tmp_path / f"{calibration.name}{number}.sshsig").write_text(f"signature{number}")
    (tmp_path / f"{calibration.name}.sshsig.tsr").write_text("token")
    name = name_outside("FM-207", calibration.stem)
    (tmp_path / "given").mkdir()
    hand_out(calibration, tmp_path / "given", [], name)
    endings = ("", ".sshsig", ".2.sshsig", ".sshsig.tsr")
    wanted = {f"FM-207_20261129T054647-904f.json{ending}" for ending in endings} | {"allowed_signers"}
    assert {path.name for path in (tmp_path / "given").iterdir()} == wanted
    copies = signature_files(tmp_path / "given" / f"{name}.json")
    assert [copy.read_text() for copy in copies] == ["signature", "signature.2"]
    assert (tmp_path / "given" / f"{name}.json").read_bytes() == calibration.read_bytes()
    assert name_outside("FM-207", name) == name  # once it has this name it keeps it
