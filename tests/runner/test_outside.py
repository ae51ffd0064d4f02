"""Procedures and drivers of other packages that do not load: named with file and line, and the others stay."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

from labcal.bench.loading import _installed
from labcal.bench.opening import load_bench
from labcal.cli import execute as labcal
from labcal.errors import InputError
from labcal.runner import catalogue, find

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
FAULTS = {
    "exits": ("import sys\n\nsys.exit(0)\n", "line 3: .* SystemExit: 0"),
    "raises": ("x = 1 / 0\n", "line 1: .* ZeroDivisionError: division by zero"),
    "dies": ("class Own(BaseException):\n    def __str__(self):\n        exit()\n\n\nraise Own\n", "line 6: .* Own$"),
    "lacks": ("import not_there_at_all\n", "line 1: .* ModuleNotFoundError: No module named 'not_there_at_all'"),
    "broken": ("def x(:\n", "line 1: .* SyntaxError"),
    "shouts": ("raise ValueError('\\x1b[2J\\nall coils at zero')\n", "ValueError: \ufffd\\[2J all coils at zero$"),
    "number": ("exits = number = 7\n", "fails as it is looked at: TypeError"),
}


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A package of another lab: one procedure a fault, one of them as a driver too."""
    info = tmp_path / "other-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: other\nVersion: 1.0\n")
    points = "".join(f"other-{name} = other_{name}:{name}\n" for name in FAULTS)
    (info / "entry_points.txt").write_text(
        f"[labcal.procedures]\n{points}[labcal.drivers]\nother = other_exits:exits\n"
    )
    for name, (text, _) in FAULTS.items():
        (tmp_path / f"other_{name}.py").write_text(text)
        monkeypatch.delitem(sys.modules, f"other_{name}", raising=False)
    monkeypatch.syspath_prepend(tmp_path)
    return tmp_path


def test_one_that_does_not_load_is_named_with_file_and_line_and_the_others_stay(
    site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found, broken = catalogue()
    assert "preflight" in found
    assert broken.keys() == {f"other-{name}" for name in FAULTS}
    for name, (_, says) in FAULTS.items():
        with pytest.raises(InputError, match=says) as caught:
            find(f"other-{name}")
        if name != "number":
            assert str(caught.value).startswith(f"{site / f'other_{name}.py'}, line ")
    capsys.readouterr()
    assert labcal(["run"]) == 0
    told = capsys.readouterr()
    assert "preflight" in told.out
    assert told.err.strip().count("\n") == len(FAULTS) - 1


@pytest.mark.parametrize("name", [name for name in FAULTS if name != "number"])
def test_a_file_of_one_s_own_may_not_end_labcal_either(name: str, site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(site)
    with pytest.raises(InputError, match=r"other_\w+\.py, line \d: (cannot be loaded|is not Python)"):
        find(f"./other_{name}.py")


def test_a_driver_that_exits_is_named_in_the_bench_file(site: Path) -> None:
    bench = site / "bench.toml"
    text = EXAMPLE.read_text(encoding="utf-8")
    at = text.index("driver = ")
    bench.write_text(f'{text[:at]}driver = "other"{text[text.index(chr(10), at) :]}', encoding="utf-8")
    _installed.cache_clear()
    try:
        with pytest.raises(InputError, match=r"bench\.toml, line \d+: .*other_exits\.py, line 3: .* SystemExit: 0"):
            load_bench(bench, None, 0)
    finally:
        _installed.cache_clear()


def test_a_name_that_two_packages_bring_is_said(
    site: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("labcal.plugin_loading.KINDS", {"labcal.drivers": "driver", "labcal.emulators": "emulator"})
    text = "[labcal.drivers]\ntti-pl = drivers.zaber:ZaberStage\n[labcal.emulators]\nother = drivers.zaber:ZaberStage\n"
    (site / "other-1.0.dist-info" / "entry_points.txt").write_text(text)
    assert labcal(["plugins"]) == 1
    said = capsys.readouterr().err
    assert "two packages bring the driver 'tti-pl': labcal and other; one of them needs another name" in said
    assert "emulator 'other'" not in said


def test_a_driver_without_its_emulator_is_told_where_that_is_declared(
    site: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (site / "other-1.0.dist-info" / "entry_points.txt").write_text(
        "[labcal.drivers]\nother = drivers.zaber:ZaberStage\n"
    )
    monkeypatch.setattr("labcal.bench.loading.entry_files.entries", lambda group: {})
    bench = site / "bench.toml"
    bench.write_text(EXAMPLE.read_text(encoding="utf-8").replace('"zaber"', '"other"'), encoding="utf-8")
    _installed.cache_clear()
    try:
        with pytest.raises(InputError, match=r"the driver 'other' has no emulator: .*labcal\.emulators.*install again"):
            load_bench(bench, None, 0)
    finally:
        _installed.cache_clear()


def test_what_others_bring_is_listed_and_what_does_not_load_is_said_with_its_place(
    site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert labcal(["plugins"]) == 1
    told = capsys.readouterr()
    assert [line.split()[:4] for line in told.out.splitlines() if line.startswith("driver")] == [
        ["driver", "other", "other", "1.0"]
    ]
    assert sum(line.startswith("procedure") for line in told.out.splitlines()) == len(FAULTS)
    for name, (_, says) in FAULTS.items():
        if name != "number":
            assert re.search(rf"other_{name}\.py, {says}" if says.startswith("line") else says, told.err, re.MULTILINE)
