"""The example package, installed as another lab would: it is listed, keeps its promises, and our own suite stands."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import venv
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
AT_MOST_S = 600.0
PARTS = [
    ["driver", "example-supply"],
    ["emulator", "example-supply"],
    ["procedure", "example-steps"],
    ["effect", "example-core"],
    ["estimator", "example-magnitudes"],
    ["page", "Example DUTs"],
]
Python = Callable[..., str]


@pytest.fixture(scope="module")
def python(tmp_path_factory: pytest.TempPathFactory) -> Python:
    """Run Python in a fresh environment that has the example, and beside it what is installed here."""
    pytest.importorskip("hatchling", reason="builds the example: install labcal's dev extra again")
    folder = tmp_path_factory.mktemp("elsewhere")
    home, plugin = folder / "venv", folder / "plugin"
    venv.create(home, symlinks=os.name == "posix")
    shutil.copytree(ROOT / "examples" / "plugin", plugin, ignore=shutil.ignore_patterns("__pycache__"))
    program = home / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    packages = next(home.rglob("site-packages"))
    beside = [path for path in sys.path if "site-packages" in path or Path(path) == ROOT]
    (packages / "beside.pth").write_text("\n".join(beside), encoding="utf-8")

    def run(*words: str) -> str:
        environment = {**os.environ, "LABCAL_HOME": str(folder / "home"), "PYTHONPATH": "", "COLUMNS": "200"}
        done = subprocess.run(
            [program, "-m", *words], cwd=plugin, env=environment, capture_output=True, text=True, timeout=AT_MOST_S
        )
        assert done.returncode == 0, f"{words}\n{done.stdout}\n{done.stderr}"
        return done.stdout

    install = ("install", "--quiet", "--no-deps", "--no-index", "--no-build-isolation", "--disable-pip-version-check")
    run("pip", *install, ".")
    return run


def test_it_is_listed_with_its_package(python: Python) -> None:
    listed = [re.split("  +", line) for line in python("labcal", "plugins").splitlines()]
    assert [[kind, name] for kind, name, _, _ in listed] == PARTS
    assert {package for _, _, package, _ in listed} == {"labcal-example 1.0"}
    assert "example-steps" in python("labcal", "run")


def test_its_own_tests_hold_it_to_labcal_testing(python: Python) -> None:
    assert "6 passed" in python("pytest", "-q", "-p", "no:cacheprovider", "tests")


def test_our_own_suite_does_not_try_what_others_installed(python: Python) -> None:
    tests = str(ROOT / "tests" / "conformance" / "test_drivers.py")
    said = python(
        "pytest", "-q", "-p", "no:cacheprovider", "-c", str(ROOT / "pyproject.toml"), tests, "-k", "every_dri"
    )
    assert "2 passed" in said
