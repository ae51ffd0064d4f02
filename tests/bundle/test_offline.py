"""The real folder, installed where there is no route to anywhere: self-test passed, command and desktop entry there."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
APART = ["unshare", "--map-root-user", "--net"]
PATIENCE_S = 1200

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform != "linux" or not shutil.which("unshare"), reason="needs Linux's namespaces"),
]


def test_a_pc_without_a_network_comes_from_the_folder_to_a_passed_self_test(tmp_path):
    if subprocess.run([*APART, "true"], capture_output=True, timeout=60).returncode:
        pytest.skip("this system gives no network namespace of one's own")
    folder, python = tmp_path / "bundle", f"{sys.version_info[0]}.{sys.version_info[1]}"
    make = [sys.executable, "tools/bundle/make.py", "--out", str(folder), "--python", python]
    made = subprocess.run(make, cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE_S)
    assert made.returncode == 0, made.stderr
    assert "windows: " in made.stdout
    home = tmp_path / "home"
    home.mkdir()
    environment = {"HOME": str(home), "PATH": os.environ["PATH"], "PYTHON": sys.executable, "LANG": "C.UTF-8"}
    installed = subprocess.run(
        [*APART, folder / "install.sh"], env=environment, capture_output=True, text=True, timeout=PATIENCE_S
    )
    assert installed.returncode == 0, installed.stdout + installed.stderr
    assert "✓ files" in installed.stdout
    assert "✓ signature" in installed.stdout
    assert (home / ".local" / "share" / "applications" / "labcal.desktop").is_file()
    [page] = (home / ".local" / "share" / "labcal" / "self-tests").iterdir()
    assert page.read_bytes().startswith(b"%PDF")
