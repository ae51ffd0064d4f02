"""Entry points that are read from packages' own files: the same that Python finds, and no more."""

from __future__ import annotations

import sys
from importlib.metadata import entry_points
from pathlib import Path

import pytest

from labcal import entry_files
from labcal.plugin_loading import KINDS


@pytest.fixture(autouse=True)
def afresh() -> None:
    entry_files.entries.cache_clear()
    entry_files._texts.cache_clear()


@pytest.mark.parametrize("group", KINDS)
def test_what_is_installed_is_found_as_python_finds_it(group: str) -> None:
    known = {(entry.name, entry.value) for entry in entry_points(group=group)}
    assert {(entry.name, entry.value) for entry in entry_files.entries(group).values()} == known


def test_each_driver_of_labcal_is_loaded_alike() -> None:
    for entry in entry_points(group="labcal.drivers"):
        assert entry_files.entries("labcal.drivers")[entry.name].load() is entry.load()


def installed(folder: Path, package: str, text: str) -> None:
    (folder / f"{package}.dist-info").mkdir(parents=True)
    (folder / f"{package}.dist-info" / "entry_points.txt").write_text(text)
    (folder / f"{package}.dist-info" / "METADATA").write_text(f"Name: {package.split('-')[0]}\nVersion: 1\n")


def test_of_a_package_that_is_there_twice_the_first_counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    installed(tmp_path / "a", "one-1", "[labcal.drivers]\nnew = os.path:join\n[others]\nodd = os:x\n")
    installed(tmp_path / "b", "One-2", "[labcal.drivers]\nold = os.path:join\n")
    installed(tmp_path / "b", "two-2", "# nothing\n\n[ labcal.drivers ]\n[labcal.drivers]\n")
    monkeypatch.setattr(sys, "path", [str(tmp_path / "a"), str(tmp_path / "b"), str(tmp_path / "not there")])
    found = {name: entry.value for name, entry in entry_files.entries("labcal.drivers").items()}
    assert found == {"new": "os.path:join"}
    assert [entry.name for entry in entry_points(group="labcal.drivers")] == ["new"]
