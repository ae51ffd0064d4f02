"""What is installed from: the same bytes from the same source, all of it, and what Qt asks of the system."""

import io
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import time
import tomllib
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.utils import canonicalize_name

from labcal.system.qt_packages import QT_PACKAGES

ROOT = Path(__file__).parents[1]
LEFT_BEHIND = {".gitignore"}


def tool(name):
    spec = spec_from_file_location(name, ROOT / "tools" / f"{name}.py")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def tracked():
    try:
        told = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("no git here, or no repository")
    return [name for name in told.splitlines() if (ROOT / name).is_file()]


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """One wheel and one sdist, by their names."""
    release = tool("release")
    return release.build(tmp_path_factory.mktemp("built"), tracked(), *release.BUILDS[0], "1767600000")


def test_a_build_is_one_wheel_and_one_sdist_and_the_sdist_is_whole(built):
    release, names = tool("release"), tracked()
    assert [name.rsplit(".", 1)[1] for name in sorted(built)] == ["whl", "gz"]
    [sdist] = (content for name, content in built.items() if name.endswith(".gz"))
    assert release.lacking(sdist, names) == []
    assert release.lacking(sdist, [*names, "labcal/another.py"]) == ["labcal/another.py"]


@pytest.mark.slow
def test_two_builds_and_one_of_the_sdist_are_the_same_bytes(built, tmp_path):
    release = tool("release")
    assert release.build(tmp_path / "again", tracked(), *release.BUILDS[1], "1767600000") == built
    [sdist] = (content for name, content in built.items() if name.endswith(".gz"))
    assert wheel_of(sdist, tmp_path, "1767600000") == next(one for name, one in built.items() if name[-3:] == "whl")


def wheel_of(sdist, folder, epoch):
    """What an sdist builds that somebody unpacked, without git."""
    with tarfile.open(fileobj=io.BytesIO(sdist)) as archive:
        archive.extractall(folder / "unpacked", filter="data")
    [source] = (folder / "unpacked").iterdir()
    command = [sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", str(folder / "wheel")]
    subprocess.run(command, cwd=source, check=True, capture_output=True, env=os.environ | {"SOURCE_DATE_EPOCH": epoch})
    [wheel] = (folder / "wheel").iterdir()
    return wheel.read_bytes()


def test_the_inventory_names_what_labcal_and_its_extras_need_with_licences():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    release = tool("release")
    listed = json.loads(release.inventory(release.needed("labcal")))["components"]
    names = {one["name"]: one["licenses"][0]["license"]["name"] for one in listed}
    assert {canonicalize_name(Requirement(text).name) for text in project["dependencies"]} < names.keys()
    assert "BSD" in names["numpy"]
    assert "contourpy" in names  # of matplotlib
    assert not {"pytest", "ruff", "mypy"} & names.keys()


def test_readme_names_what_the_window_needs_of_the_system():
    assert tool("qt_libraries").stated_in(ROOT / "README.md") == list(QT_PACKAGES)


@pytest.mark.parametrize(
    ("soname", "package"),
    [
        ("libxcb-icccm.so.4", "libxcb-icccm4"),
        ("libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
        ("libdbus-1.so.3", "libdbus-1-3"),
        ("libX11-xcb.so.1", "libx11-xcb1"),
        ("libEGL.so.1", "libegl1"),
    ],
)
def test_a_library_that_is_not_installed_is_in_the_package_that_debian_s_policy_names(soname, package):
    assert tool("qt_libraries").by_policy(soname) == package


@pytest.mark.slow  # tools/check.sh does so each time
@pytest.mark.skipif(not shutil.which("readelf") or not shutil.which("dpkg-query"), reason="needs Debian and binutils")
def test_what_qt_s_own_libraries_need_is_what_is_stated():
    assert set(tool("qt_libraries").needed_packages()) == set(QT_PACKAGES)


def test_what_is_missing_and_what_is_too_much_is_told_with_its_place():
    lacks = [name for name in QT_PACKAGES if name != "libxcb-cursor0"]
    assert tool("qt_libraries").differences("README.md", QT_PACKAGES, [*lacks, "libfoo1"]) == [
        "README.md does not name libxcb-cursor0, which Qt needs",
        "README.md names libfoo1, which Qt does not need",
    ]


def test_setting_up_is_not_silent_for_long_and_tells_what_failed(tmp_path, monkeypatch, capsys):
    set_up = tool("set_up")
    monkeypatch.setattr(set_up, "SILENCE_S", 0.1)
    (tmp_path / "lib" / "python3" / "site-packages" / "numpy.dist-info").mkdir(parents=True)
    said = io.StringIO()
    aloud = set_up.Aloud(tmp_path, said)
    try:
        until = time.monotonic() + 15
        while said.getvalue().count("1 packages are in place") < 2:
            assert time.monotonic() < until
            time.sleep(0.02)
        code = "print('Collecting numpy'); print('of no interest'); raise SystemExit(3)"
        assert set_up.run([sys.executable, "-c", code], aloud) == 3
    finally:
        aloud.end()
    assert "  Collecting numpy\n" in said.getvalue()
    assert "of no interest" not in said.getvalue()
    assert "of no interest" in capsys.readouterr().err  # what was not said is, where it failed


def test_a_python_that_labcal_does_not_run_on_is_told_at_once(monkeypatch, capsys, tmp_path):
    set_up = tool("set_up")
    monkeypatch.setattr(set_up, "OLDEST", (3, 12 if sys.version_info < (3, 12) else 99))
    monkeypatch.setattr(sys, "argv", ["set_up.py", str(tmp_path / "venv"), "."])
    assert set_up.main() == 2
    assert re.search(r"needs Python 3.11 to 3.13, python3 is 3\.", capsys.readouterr().err)
    assert not (tmp_path / "venv").exists()


def test_every_dependency_has_an_upper_bound() -> None:
    told = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    wanted = [*told["dependencies"], *(one for extra in told["optional-dependencies"].values() for one in extra)]
    bounded = {text: {spec.operator for spec in Requirement(text).specifier} & {"<", "~=", "=="} for text in wanted}
    assert [text for text, operators in bounded.items() if not operators] == []


def test_the_versions_that_were_tried_are_stated_and_lie_within_the_bounds() -> None:
    """A bound that is moved asks for a version that was tried, and a package that is new for one too."""
    told = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = [one for name, of in told["optional-dependencies"].items() if name != "dev" for one in of]
    wanted = {r.name: r.specifier for r in map(Requirement, [*told["dependencies"], *extras])}
    page = (ROOT / "docs" / "installation.md").read_text().partition("## Versions that were tried")[2]
    lines = [re.split(r" *\| *", line) for line in page.splitlines() if line.startswith("|")][2:]
    rows = {name: (permitted, tried) for _, name, _, permitted, tried, _ in lines}
    assert rows.keys() == wanted.keys()
    assert {name: SpecifierSet(said.strip("`")) for name, (said, _) in rows.items()} == wanted
    assert [name for name, (_, tried) in rows.items() if tried != "not here" and tried not in wanted[name]] == []
    assert sum(tried != "not here" for _, tried in rows.values()) > len(rows) - 6


def test_setting_up_compiles_nothing_that_nobody_imports(monkeypatch, tmp_path):
    """All packages at once took 31 s of processor of 74; what is imported is compiled then, and kept."""
    set_up, asked = tool("set_up"), []
    monkeypatch.setattr(set_up, "run", lambda command, aloud: asked.append(list(command)) or 0)
    assert set_up.set_up(tmp_path / "venv", ["--editable", "."], io.StringIO()) == 0
    [made, installed] = asked
    assert made[1:3] == ["-m", "venv"]
    assert installed[1:4] == ["-m", "pip", "install"]
    assert "--no-compile" in installed
