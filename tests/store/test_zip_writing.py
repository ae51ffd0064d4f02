"""Zips by the quickest deflate that is here: what others read, and the same bytes again."""

from __future__ import annotations

import shutil
import stat
import subprocess
import sys
import zipfile
import zlib
from hashlib import sha256
from pathlib import Path

import pytest

from labcal.store import load_bundle, save_bundle, zipped_as
from labcal.store.zip_writing import LEVEL, deflaters, zip_of

FILES = [("run.json", b'{"a": 1}\n'), ("samples.csv", b"t_s,dut_x\n" + b"0.025,1\n" * 9_000), ("chain.jsonl", b"")]


def test_by_zlib_a_zip_is_what_zipfile_writes(tmp_path: Path) -> None:
    with zipfile.ZipFile(path := tmp_path / "a.zip", "w") as archive:
        for name, content in FILES:
            member = zipfile.ZipInfo(name)
            member.create_system, member.external_attr = 3, (stat.S_IFREG | 0o644) << 16
            archive.writestr(member, content, zipfile.ZIP_DEFLATED, LEVEL)
    assert zip_of(FILES, zlib) == path.read_bytes()


def test_by_whichever_deflate_others_read_the_same_files(tmp_path: Path) -> None:
    made = [zip_of(FILES, deflater) for deflater in deflaters()]
    assert zip_of(FILES) == made[0]
    for content in made:
        (path := tmp_path / "a.zip").write_bytes(content)
        with zipfile.ZipFile(path) as archive:
            assert archive.testzip() is None
            assert [(name, archive.read(name)) for name in archive.namelist()] == FILES
        if unzip := shutil.which("unzip"):
            said = subprocess.run([unzip, "-t", path], check=True, capture_output=True, text=True).stdout
            assert "No errors detected" in said


def test_without_isal_zlib_makes_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "isal", None)
    monkeypatch.setitem(sys.modules, "isal.isal_zlib", None)
    assert list(deflaters()) == [zlib]
    assert zip_of(FILES) == zip_of(FILES, zlib)


def test_what_is_written_for_a_person_is_the_same_whatever_is_installed(bundle, tmp_path: Path) -> None:
    """Two PCs that export one run can hold their zips against each other."""
    found = load_bundle(bundle())
    save_bundle(found, path := tmp_path / "run.zip")
    files = [("run.json", found.run_json), ("samples.csv", found.samples_csv), ("chain.jsonl", found.chain)]
    assert path.read_bytes() == zip_of([(name, content) for name, content in files if content], zlib)


def test_a_zip_is_made_again_as_it_was_whichever_deflate_made_it(bundle) -> None:
    found = load_bundle(bundle())
    for deflater in deflaters():
        made = zip_of([("run.json", found.run_json), ("samples.csv", found.samples_csv)], deflater)
        assert zipped_as(found, sha256(made).hexdigest()) == made
    assert zipped_as(found, "0" * 64) is None
