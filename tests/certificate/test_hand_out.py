"""A calibration copied for somebody else replaces nothing that is another's."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from labcal.certificate import hand_out
from labcal.errors import InputError

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
