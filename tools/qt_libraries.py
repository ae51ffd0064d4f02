"""Which Debian packages the window's Qt needs: what its own libraries name, looked up in dpkg's database.

python tools/qt_libraries.py            prints them
python tools/qt_libraries.py --check    exit 1 where labcal.system.qt_packages or README names others
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
from collections.abc import Iterable
from functools import cache
from importlib.util import find_spec
from pathlib import Path

from labcal.system.qt_packages import QT_PACKAGES

ROOT = Path(__file__).parents[1]
BEGINS_WITH = (
    *("lib/libQt6Core.so.6", "lib/libQt6Gui.so.6", "lib/libQt6Widgets.so.6", "lib/libQt6DBus.so.6"),
    *("plugins/platforms/libqxcb.so", "plugins/platforms/libqoffscreen.so"),
)
NEEDED = re.compile(r"\(NEEDED\).*\[(.+)\]")
SONAME = re.compile(r"(?P<name>.+)\.so\.(?P<version>\d+)\Z")
CACHED = re.compile(r"^\s*(\S+) \(libc6,x86-64.*=> (\S+)$", re.MULTILINE)
ON_EVERY_DEBIAN = ("apt", "dpkg", "libc6")  # with what these themselves need
TIME64 = re.compile(r"t64\Z")  # Debian 13 and Ubuntu 24.04: the package answers to the name without it, too


def main() -> int:
    """Print what is needed, or compare it with what is stated."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare with labcal.system.qt_packages and README")
    check = parser.parse_args().check
    found = needed_packages()
    if not check:
        print(*found)
        return 0
    said = {"labcal/system/qt_packages.py": QT_PACKAGES, "README.md": stated_in(ROOT / "README.md")}
    wrong = [line for place, stated in said.items() for line in differences(place, found, stated)]
    print(*wrong, sep="\n", file=sys.stderr, end="\n" * bool(wrong))
    return 1 if wrong else 0


def needed_packages() -> list[str]:
    """The packages of all libraries that Qt asks of the system, without those that every Debian has."""
    packages = {TIME64.sub("", package_of(soname)) for soname in system_libraries(qt_folder())}
    return sorted(packages - everywhere())


def qt_folder() -> Path:
    """Where PySide6 keeps Qt. Raises SystemExit where it is not installed."""
    found = find_spec("PySide6")
    if found is None or not found.submodule_search_locations:
        raise SystemExit("PySide6 is not installed here")
    return Path(found.submodule_search_locations[0]) / "Qt"


def system_libraries(qt: Path) -> set[str]:
    """The names of libraries that those of BEGINS_WITH, and what they need of Qt's own, need of the system."""
    waiting, seen, outside = [qt / name for name in BEGINS_WITH], set[Path](), set[str]()
    while waiting:
        library = waiting.pop()
        seen.add(library)
        for name in needed_by(library):
            own = qt / "lib" / name
            if not own.exists():
                outside.add(name)
            elif own not in seen:
                waiting.append(own)
    return outside


def needed_by(library: Path) -> list[str]:
    """What an ELF file names as needed."""
    return NEEDED.findall(said_by("readelf", "--dynamic", "--wide", str(library)))


def package_of(soname: str) -> str:
    """The package that has it; where it is not installed, the name that Debian's policy gives (8.1)."""
    path = installed_libraries().get(soname)
    for place in () if path is None else (path, path.resolve(), Path("/usr") / path.relative_to("/")):
        if said := said_by("dpkg-query", "--search", str(place), may_fail=True):
            return said.split(":")[0]
    return by_policy(soname)


def by_policy(soname: str) -> str:
    """libxcb-icccm.so.4 is in libxcb-icccm4, libdbus-1.so.3 in libdbus-1-3."""
    parts = SONAME.match(soname)
    if parts is None:
        return soname.lower()
    name, version = parts["name"].lower(), parts["version"]
    return f"{name}-{version}" if name[-1].isdigit() else f"{name}{version}"


@cache
def installed_libraries() -> dict[str, Path]:
    """Each library that the loader knows, and its file."""
    return {name: Path(path) for name, path in CACHED.findall(said_by("/sbin/ldconfig", "--print-cache"))}


def everywhere() -> set[str]:
    """The packages that apt and dpkg themselves need."""
    fields = said_by("dpkg-query", "--show", "--showformat=${Depends}, ${Pre-Depends}, ", *ON_EVERY_DEBIAN)
    return {re.split(r"[ :(|]", one.strip())[0] for one in fields.split(",") if one.strip()} | {"libc6", "libgcc-s1"}


def stated_in(readme: Path) -> list[str]:
    """The packages of the README's line for apt-get that names Qt's: the block that has libxcb-cursor0."""
    blocks = re.findall(r"^```\n(.*?)^```", readme.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    named = [block for block in blocks if "libxcb-cursor0" in block]
    return re.findall(r"\blib[a-z0-9][a-z0-9.+-]*", named[0]) if named else []


def differences(place: str, found: Iterable[str], stated: Iterable[str]) -> list[str]:
    """What `place` names and Qt does not need, and the other way round."""
    lacks, more = sorted(set(found) - set(stated)), sorted(set(stated) - set(found))
    return [f"{place} does not name {name}, which Qt needs" for name in lacks] + [
        f"{place} names {name}, which Qt does not need" for name in more
    ]


def said_by(*command: str, may_fail: bool = False) -> str:
    """What a program prints. Raises SystemExit where it is not there or fails, unless it `may_fail`."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=not may_fail)
    except (OSError, subprocess.CalledProcessError) as error:
        raise SystemExit(f"{command[0]}: {error}") from error
    return done.stdout


if __name__ == "__main__":
    sys.exit(main())
