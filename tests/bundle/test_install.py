"""A folder that installs labcal offline: verified by hash first, a way back, the store untouched.

The folder here holds a stand-in labcal of a few lines; it is installed by a stand-in pip that unpacks wheels.
"""

import json
import os
import subprocess
import sys
import zipfile
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PYTHON = f"{sys.version_info[0]}.{sys.version_info[1]}"
PIP = """import hashlib, os, sys, zipfile
words = sys.argv
wheels, wanted = words[words.index("--find-links") + 1], words[words.index("--requirement") + 1]
assert {"--isolated", "--no-index", "--require-hashes"} <= set(words)
assert not [name for name in os.environ if name.startswith(("PIP_", "PYTHON"))]
name, stated = open(wanted).read().split(" --hash=sha256:")
file = next(f for f in os.listdir(wheels) if f.startswith("labcal-" + name.split("==")[1]))
content = open(os.path.join(wheels, file), "rb").read()
assert hashlib.sha256(content).hexdigest() == stated.strip()
place = os.path.join(sys.prefix, "bin", "labcal")
with zipfile.ZipFile(os.path.join(wheels, file)) as archive:
    open(place, "wb").write(archive.read("labcal"))
os.chmod(place, 0o755)
"""
LABCAL = """#!/bin/sh
[ "$1" = self-test ] && exit {code}
echo "labcal {version}"
"""

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the stand-in labcal is a shell script")


def module(name):
    spec = spec_from_file_location(f"bundle_{name}", ROOT / "tools" / "bundle" / f"{name}.py")
    made = module_from_spec(spec)
    sys.modules[spec.name] = made
    spec.loader.exec_module(made)
    return made


make, installer = module("make"), module("install")


def wheel(folder, name, version, needs=(), tags="py3-none-any", files=()):
    """A wheel of METADATA and a few files."""
    file = folder / f"{name.replace('-', '_')}-{version}-{tags}.whl"
    needed = "".join(f"Requires-Dist: {one}\n" for one in needs)
    with zipfile.ZipFile(file, "w") as archive:
        about = f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\nLicense-Expression: MIT\n{needed}"
        archive.writestr(f"{name.replace('-', '_')}-{version}.dist-info/METADATA", about)
        for inside, text in files:
            archive.writestr(inside, text)
    return make.read_wheel(file)


@pytest.fixture
def lab(tmp_path, monkeypatch):
    """A user's home with runs and keys in it, and where labcal goes."""
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.delenv("XDG_DATA_HOME", raising=False)
    monkeypatch.setenv("PIP_INDEX_URL", "http://localhost:1")
    store = tmp_path / "home" / ".local" / "share" / "labcal"
    store.mkdir(parents=True)
    (store / "store.sqlite").write_bytes(b"the runs of a year")
    return tmp_path / "home"


def bundle(folder, version, code=0, python=PYTHON):
    """A folder as `make bundle` leaves it."""
    wheels = folder / "wheels"
    wheels.mkdir(parents=True)
    (folder / "lib").mkdir()
    (folder / "lib" / "libxcb-of-nobody.so.9").write_text("a library")
    pip = wheel(wheels, "pip", "1", files=[("pip/__main__.py", PIP)])
    own = wheel(wheels, "labcal", version, files=[("labcal", LABCAL.format(version=version, code=code))])
    make.write(folder, {"linux": [own, pip], "windows": [own, pip]}, python)
    return folder


def install(folder, *words):
    return subprocess.run(
        [str(folder / "install.sh"), *words], capture_output=True, text=True, timeout=120,
        env={**os.environ, "PYTHON": sys.executable},
    )  # fmt: skip


def says(lab):
    done = subprocess.run([lab / ".local" / "bin" / "labcal", "x"], capture_output=True, text=True, timeout=60)
    return done.stdout.strip()


def test_installed_updated_rolled_back_and_removed_with_the_store_as_it_was(tmp_path, lab):
    first = install(bundle(tmp_path / "a folder's name", "1.0"))
    assert (first.returncode, says(lab)) == (0, "labcal 1.0"), first.stderr
    assert "added for the window: libxcb-of-nobody.so.9" in first.stdout
    second = install(bundle(tmp_path / "new", "2.0"))
    assert (second.returncode, says(lab)) == (0, "labcal 2.0"), second.stderr
    failing = install(bundle(tmp_path / "bad", "3.0", code=1))
    assert failing.returncode == 1
    assert "does not pass its self-test here; what was installed before is in use as before" in failing.stderr
    assert says(lab) == "labcal 2.0"
    assert install(tmp_path / "new", "--roll-back").returncode == 0
    assert says(lab) == "labcal 1.0"
    entry = lab / ".local" / "share" / "applications" / "labcal.desktop"
    assert f'Exec="{lab}/.local/bin/labcal" gui\n' in entry.read_text()
    assert (lab / ".local/share/icons/hicolor/scalable/apps/labcal.svg").is_file()
    assert install(tmp_path / "new", "--remove").returncode == 0
    assert not entry.exists()
    left = sorted(path.relative_to(lab).as_posix() for path in lab.rglob("*") if path.is_file())
    assert left == [".local/share/labcal/store.sqlite"]
    assert (lab / left[0]).read_bytes() == b"the runs of a year"


def changed(folder):
    file = next((folder / "wheels").glob("labcal-*.whl"))
    file.write_bytes(file.read_bytes()[:-1] + b"x")
    return file


def added(folder):
    (folder / "wheels" / "numpy-9-py3-none-any.whl").touch()
    return folder / "wheels" / "numpy-9-py3-none-any.whl"


def lost(folder):
    (folder / "licences.txt").unlink()
    return folder / "licences.txt"


def changed_program(folder):
    (folder / "install.py").write_text("print('anything')")
    return folder / "install.py"


@pytest.mark.parametrize("harm", [changed, added, lost, changed_program])
def test_a_folder_that_is_not_as_it_was_packed_installs_nothing(tmp_path, lab, harm):
    folder = bundle(tmp_path / "folder", "1.0")
    file = harm(folder)
    done = install(folder)
    assert done.returncode == 1
    assert file.name in done.stdout + done.stderr
    assert "nothing was installed" in done.stderr
    assert not (lab / ".local" / "lib").exists()
    assert not (lab / ".local" / "bin").exists()


@pytest.mark.parametrize("line", ["0123  wheels/a.whl", f"{'0' * 64}  ../a.whl", f"{'0' * 64}  /etc/passwd", "words"])
def test_a_list_of_hashes_that_is_none_is_refused(tmp_path, line):
    (tmp_path / "SHA256SUMS").write_text(line + "\n")
    with pytest.raises(installer.Refused, match="is no line of hashes: nothing was installed"):
        installer.read_sums(tmp_path / "SHA256SUMS")


def test_another_python_than_the_wheels_are_for_is_refused(tmp_path, lab, capsys):
    with pytest.raises(installer.Refused, match=r"this folder is for Python 3\.1, this is 3\."):
        installer.install(bundle(tmp_path / "folder", "1.0", python="3.1"), tmp_path / "prefix", self_test=False)
    assert not (tmp_path / "prefix").exists()


def test_a_try_that_is_cut_off_leaves_nothing_and_the_next_succeeds(tmp_path, lab, monkeypatch, capsys):
    folder, prefix = bundle(tmp_path / "folder", "1.0"), tmp_path / "prefix"

    def cut_off(command):
        (prefix / "versions").mkdir(parents=True, exist_ok=True)
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(installer, "asked", cut_off)
        with pytest.raises(KeyboardInterrupt):
            installer.install(folder, prefix, self_test=False)
    assert list((prefix / "versions").iterdir()) == []
    assert installer.current(prefix) == ""


def test_there_is_no_way_back_from_the_first_version(tmp_path, lab):
    folder = bundle(tmp_path / "folder", "1.0")
    done = install(folder, "--roll-back")
    assert (done.returncode, done.stderr) == (1, "install: there is no version before this one: nothing was changed\n")


def test_what_windows_needs_beside_linux_is_missed_by_name(tmp_path):
    needs = ['colorama; sys_platform == "win32"', "numpy>=2", 'lxml; extra == "dcc"']
    wheels = [
        wheel(tmp_path, "labcal", "1.0", needs),
        wheel(tmp_path, "pip", "25.0"),
        wheel(tmp_path, "numpy", "2.1", tags="cp311-cp311-manylinux_2_28_x86_64"),
        wheel(tmp_path, "lxml", "6.0", tags="cp310-abi3-win_amd64"),
    ]
    assert make.closure(wheels, "windows", "3.11")[1] == ["colorama", "numpy>=2"]
    assert make.closure(wheels, "linux", "3.11")[1] == ["lxml"]
    wheels += [wheel(tmp_path, "colorama", "0.4"), wheel(tmp_path, "numpy", "2.2", tags="cp311-cp311-win_amd64")]
    found, missing = make.closure(wheels, "windows", "3.11")
    assert [one.name for one in found] == ["colorama", "labcal", "lxml", "numpy", "pip"]
    assert missing == []
    old = [one for one in wheels if one.version != "2.2"] + [
        wheel(tmp_path, "numpy", "1.9", tags="cp311-cp311-win_amd64")
    ]
    assert make.closure(old, "windows", "3.11")[1] == ["numpy>=2"]
    assert make.closure(wheels, "windows", "3.12")[1] == ["numpy>=2"]  # its wheel is for another Python


def test_the_inventory_names_every_wheel_with_its_hash_and_licence(tmp_path):
    folder = bundle(tmp_path / "folder", "1.0")
    told = json.loads((folder / "inventory.cdx.json").read_text())
    assert {one["name"]: one["licenses"][0]["license"]["name"] for one in told["components"]} == {
        "labcal": "MIT", "pip": "MIT",
    }  # fmt: skip
    listed = installer.read_sums(folder / "SHA256SUMS")
    assert {one["hashes"][0]["content"] for one in told["components"]} < set(listed.values())
    assert "labcal 1.0: MIT" in (folder / "licences.txt").read_text()
