"""Bundles as zip files: what a zip may hold, and what a crafted or damaged one gets."""

from __future__ import annotations

import stat
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal.errors import InputError
from labcal.store import read_bundle, write_bundle


def zip_of(path: Path, members: list[tuple[Any, bytes]]) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members:
            archive.writestr(name, content)
    return path


def test_a_zipped_folder_is_a_bundle_too(bundle, tmp_path: Path) -> None:
    folder = bundle()
    members = [(f"run7/{name}", (folder / name).read_bytes()) for name in ("run.json", "samples.csv")]
    assert read_bundle(zip_of(tmp_path / "b.zip", [*members, ("__MACOSX/._x", b"")])).run_id == "r1"


@pytest.mark.parametrize("name", ["../run.json", "/run.json", "a/../../run.json", "..\\run.json", "C:\\run.json"])
def test_a_zip_that_climbs_out_is_refused(bundle, tmp_path: Path, name: str) -> None:
    folder = bundle()
    good = [(part, (folder / part).read_bytes()) for part in ("run.json", "samples.csv")]
    with pytest.raises(InputError, match="climbs out"):
        read_bundle(zip_of(tmp_path / "b.zip", [*good, (name, b"{}")]))
    assert sorted(p.name for p in tmp_path.iterdir()) == ["b.zip", "bundle"]


def test_zips_with_links_doubles_bombs_or_missing_files_are_refused(bundle, tmp_path: Path, monkeypatch) -> None:
    folder, path = bundle(), tmp_path / "b.zip"
    header, rows = (((part), (folder / part).read_bytes()) for part in ("run.json", "samples.csv"))
    link = zipfile.ZipInfo("samples.csv")
    link.create_system, link.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
    with pytest.raises(InputError, match="a link"):
        read_bundle(zip_of(path, [header, (link, b"/etc/passwd")]))
    with pytest.raises(InputError, match=r"no samples\.csv"):
        read_bundle(zip_of(path, [header]))
    with pytest.raises(InputError, match="two files"):
        read_bundle(zip_of(path, [header, rows, ("a/samples.csv", b"")]))
    monkeypatch.setattr("labcal.store.bundle.LARGEST", {"run.json": 1 << 20, "samples.csv": 1 << 20})
    with pytest.raises(InputError, match="larger than"):
        read_bundle(zip_of(path, [header, ("samples.csv", bytes(50 << 20))]))


def test_every_damaged_zip_is_an_input_error(bundle, tmp_path: Path) -> None:
    path = tmp_path / "b.zip"
    write_bundle(read_bundle(bundle()), path)
    good, rng = path.read_bytes(), np.random.default_rng(1)
    for _ in range(300):
        damaged = bytearray(good[: rng.integers(len(good) // 2, len(good) + 1)])
        for place in rng.integers(0, len(damaged), 3):
            damaged[place] = rng.integers(256)
        path.write_bytes(damaged)
        try:
            read_bundle(path)
        except InputError:
            continue


def test_the_two_files_of_a_zip_lie_together(bundle, tmp_path: Path) -> None:
    folder = bundle()
    members = [(f"{name[0]}/{name}", (folder / name).read_bytes()) for name in ("run.json", "samples.csv")]
    with pytest.raises(InputError, match="different folders"):
        read_bundle(zip_of(tmp_path / "b.zip", members))
