"""Make a folder that installs labcal on a PC without a network: `make bundle`.

python tools/bundle/make.py --out dist/labcal-bundle [--python 3.11]

It holds wheels for Linux (x86-64) and Windows (x64), what Qt needs of X and Debian does not bring, the installers, an
inventory (CycloneDX) and the licences, and a list of the SHA-256 of every file. Needs a network, pip and hatchling.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from email import message_from_bytes
from email.message import Message
from functools import cache
from pathlib import Path

from packaging.requirements import Requirement
from packaging.tags import Tag, compatible_tags, cpython_tags
from packaging.utils import canonicalize_name, parse_wheel_filename

ROOT, HERE = Path(__file__).parents[2], Path(__file__).parent
COPIED = ("install.py", "install.sh", "install.ps1", "labcal.svg")
EXTRAS = "dcc"
LINUX = (  # up to the C library of Debian 12
    *(f"manylinux_2_{minor}_x86_64" for minor in range(36, 4, -1)),
    *("manylinux2014_x86_64", "manylinux2010_x86_64", "manylinux1_x86_64"),
)
PLATFORMS = {"linux": LINUX, "windows": ("win_amd64",)}
# What a marker in a wheel's needs is asked about: pip asks the computer it runs on, whatever platform it fetches for.
SYSTEMS = {
    "linux": {"sys_platform": "linux", "platform_system": "Linux", "os_name": "posix", "platform_machine": "x86_64"},
    "windows": {"sys_platform": "win32", "platform_system": "Windows", "os_name": "nt", "platform_machine": "AMD64"},
}
X_LIBRARIES = (  # of labcal.system.qt_packages those that a desktop may lack and that depend on nothing but X
    *("libxcb-cursor0", "libxcb-icccm4", "libxcb-image0", "libxcb-keysyms1", "libxcb-render-util0", "libxcb-shape0"),
    *("libxcb-util1", "libxcb-xkb1", "libxkbcommon-x11-0"),
)


@dataclass(frozen=True, slots=True)
class Wheel:
    """One wheel of the folder, as its own METADATA says."""

    file: Path
    name: str
    version: str
    needs: tuple[Requirement, ...]
    licence: str

    @property
    def sha256(self) -> str:
        """Of the file."""
        with self.file.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()


def read_wheel(file: Path) -> Wheel:
    """What the wheel's METADATA says."""
    with zipfile.ZipFile(file) as archive:
        [about] = [name for name in archive.namelist() if re.fullmatch(r"[^/]+\.dist-info/METADATA", name)]
        said = message_from_bytes(archive.read(about))
    needs = tuple(Requirement(text) for text in said.get_all("Requires-Dist") or ())
    return Wheel(file, str(canonicalize_name(said["Name"])), said["Version"], needs, licence_of(said))


def licence_of(said: Message) -> str:
    """In one line: the expression, else the classifiers, else the first line of the text."""
    if expression := said.get("License-Expression"):
        return expression
    classified = [
        value.split(" :: ")[-1] for key, value in said.items() if key == "Classifier" and "License ::" in value
    ]
    return "; ".join(classified) or (said.get("License") or "not stated").strip().splitlines()[0][:80]


def environment(system: str, python: str) -> dict[str, str]:
    """What a marker is asked about."""
    return {
        **SYSTEMS[system], "python_version": python, "python_full_version": f"{python}.0", "extra": "",
        "implementation_name": "cpython", "platform_python_implementation": "CPython",
    }  # fmt: skip


@cache
def tags_of(system: str, python: str) -> frozenset[Tag]:
    """What wheels can be installed there, by the tags in their names."""
    version, platforms = [int(part) for part in python.split(".")], PLATFORMS[system]
    own = compatible_tags(version, interpreter=f"cp{python.replace('.', '')}", platforms=platforms)
    return frozenset((*cpython_tags(version, platforms=platforms), *own))


def fits(wheel: Wheel, system: str, python: str) -> bool:
    """Whether the wheel, by its file's name, can be installed there."""
    return not tags_of(system, python).isdisjoint(parse_wheel_filename(wheel.file.name)[3])


def closure(wheels: Iterable[Wheel], system: str, python: str) -> tuple[list[Wheel], list[str]]:
    """The wheels that labcal needs there, pip beside them, and what is missing or of a wrong version."""
    there = {wheel.name: wheel for wheel in wheels if fits(wheel, system, python)}
    found, missing, waiting = dict[str, Wheel](), list[str](), [Requirement(f"labcal[{EXTRAS}]"), Requirement("pip")]
    done = set[str]()
    while waiting:
        needed = waiting.pop()
        if str(needed) in done:
            continue
        done.add(str(needed))
        wheel = there.get(canonicalize_name(needed.name))
        if wheel is None or not needed.specifier.contains(wheel.version, prereleases=True):
            missing.append(str(needed).split(";")[0].strip())
            continue
        found[wheel.name] = wheel
        for one in wheel.needs:
            asked = [{**environment(system, python), "extra": extra} for extra in (needed.extras or {""})]
            if one.marker is None or any(one.marker.evaluate(about) for about in asked):
                waiting.append(one)
    return sorted(found.values(), key=lambda wheel: wheel.name), sorted(missing)


def fetch(labcal: Path, folder: Path, system: str, python: str) -> list[Wheel]:
    """Fetch what labcal needs there: at first as pip sees it, then what markers ask for. Raises SystemExit."""
    where = [flag for platform in PLATFORMS[system] for flag in ("--platform", platform)]
    options = ["--only-binary=:all:", "--python-version", python, "--implementation", "cp", *where]
    pip("download", "--dest", str(folder), *options, f"{labcal}[{EXTRAS}]", "pip")
    while True:
        found, missing = closure(map(read_wheel, folder.glob("*.whl")), system, python)
        if not missing:
            return found
        before = len(list(folder.iterdir()))
        pip("download", "--dest", str(folder), *options, "--no-deps", *missing)
        if len(list(folder.iterdir())) == before:
            raise SystemExit(f"for {system} no wheel is to be had of {', '.join(missing)}")


def pip(*words: str) -> None:
    """Run pip, which says itself what it does."""
    subprocess.run([sys.executable, "-m", "pip", *words, "--disable-pip-version-check"], check=True)


def build_labcal(folder: Path) -> Path:
    """The wheel of labcal itself."""
    command = [sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", str(folder)]
    subprocess.run(command, cwd=ROOT, check=True)
    [wheel] = folder.glob("labcal-*.whl")
    return wheel


def add_x_libraries(folder: Path) -> bool:
    """Fetch the libraries from Debian's packages, by apt, which checks them; False where this is no Debian."""
    folder.mkdir()
    if not (shutil.which("apt-get") and shutil.which("dpkg-deb")):
        return False
    with tempfile.TemporaryDirectory() as place:
        subprocess.run(
            ["apt-get", "-qq", "-o", "APT::Sandbox::User=root", "download", *X_LIBRARIES], cwd=place, check=True
        )
        for package in Path(place).glob("*.deb"):
            subprocess.run(["dpkg-deb", "--extract", str(package), f"{place}/root"], check=True)
        for file in Path(place, "root").rglob("lib*.so.*"):
            if re.fullmatch(r"lib[\w-]+\.so\.\d+", file.name):  # the name that is asked for, a link to the file
                shutil.copyfile(file, folder / file.name)
    return True


def inventory(wheels: Iterable[Wheel]) -> str:
    """The wheels as CycloneDX 1.5."""
    components = [
        {
            "type": "library", "name": wheel.name, "version": wheel.version,
            "purl": f"pkg:pypi/{wheel.name}@{wheel.version}", "bom-ref": wheel.file.name,
            "hashes": [{"alg": "SHA-256", "content": wheel.sha256}],
            "licenses": [{"license": {"name": wheel.licence}}],
        }
        for wheel in wheels
    ]  # fmt: skip
    return json.dumps(
        {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1, "components": components}, indent=1
    )


def licences(wheels: Iterable[Wheel]) -> str:
    """A line a package; the texts are in the wheels."""
    lines = sorted({f"{wheel.name} {wheel.version}: {wheel.licence}" for wheel in wheels})
    return "Each package's licence as it states it itself; the texts are in its wheel.\n\n" + "\n".join(lines) + "\n"


def requirements(wheels: Iterable[Wheel]) -> str:
    """For pip: every wheel by version and hash. pip itself, which installs them, stays outside."""
    lines = (f"{one.name}=={one.version} --hash=sha256:{one.sha256}" for one in wheels if one.name != "pip")
    return "\n".join(lines) + "\n"


def sums(folder: Path) -> str:
    """The SHA-256 of every file of the folder, as sha256sum writes them."""
    files = sorted(path for path in folder.rglob("*") if path.is_file() and path.name != "SHA256SUMS")
    return "".join(f"{_sha256(path)}  {path.relative_to(folder).as_posix()}\n" for path in files)


def _sha256(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def write(folder: Path, by_system: Mapping[str, list[Wheel]], python: str) -> None:
    """Everything beside the wheels; the list of hashes last."""
    every = list({wheel.file.name: wheel for found in by_system.values() for wheel in found}.values())
    [labcal] = {wheel.version for wheel in every if wheel.name == "labcal"}
    for name in COPIED:
        shutil.copy(HERE / name, folder / name)
    texts = {
        "bundle.json": json.dumps({"version": labcal, "python": python}) + "\n",
        "inventory.cdx.json": inventory(every) + "\n",
        "licences.txt": licences(every),
        **{f"requirements-{system}.txt": requirements(found) for system, found in by_system.items()},
    }
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    (folder / "SHA256SUMS").write_text(sums(folder), encoding="utf-8", newline="\n")


def needed_files(wheels: Iterable[Wheel]) -> Iterator[str]:
    """What labcal reads at work and no network may be asked for, where it is missing: the coefficients of IGRF, WMM."""
    for wheel in wheels:
        for name, ending, model in (("ppigrf", ".shc", "IGRF"), ("pygeomag", ".COF", "WMM")):
            if wheel.name == name:
                with zipfile.ZipFile(wheel.file) as archive:
                    if not any(file.endswith(ending) for file in archive.namelist()):
                        yield f"{wheel.file.name} has no coefficients of {model}"


def main() -> int:
    """Make the folder; exit 1 where something is missing."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--python", default="3.11", choices=("3.11", "3.12", "3.13"), help="that the PC has")
    given = parser.parse_args()
    if given.out.exists():
        print(f"{given.out} is there already: name another folder, or remove it", file=sys.stderr)
        return 2
    wheels = given.out / "wheels"
    wheels.mkdir(parents=True)
    labcal = build_labcal(wheels)
    found = {system: fetch(labcal, wheels, system, given.python) for system in PLATFORMS}
    kept = {wheel.file for one in found.values() for wheel in one}
    for file in set(wheels.iterdir()) - kept:
        file.unlink()
    if not add_x_libraries(given.out / "lib"):
        print("this is no Debian: the folder has no libraries of X; on the PC, install those that README names")
    write(given.out, found, given.python)
    if lacking := list(needed_files(found["linux"])):
        print(*lacking, sep="\n", file=sys.stderr)
        return 1
    for system, one in found.items():
        print(f"{system}: {len(one)} wheels, nothing missing by name, version and platform")
    print(f"{given.out}: SHA256SUMS has SHA-256 {_sha256(given.out / 'SHA256SUMS')}; tell it to who installs")
    return 0


if __name__ == "__main__":
    sys.exit(main())
