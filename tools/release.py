"""What is handed out: wheel and sdist, built twice and the same both times, what they need, and under which licences.

python tools/release.py --out dist

Builds from the files that git tracks, in two folders, the second with other ages and rights, and exits with 1 where
the two differ or the sdist lacks a file. The inventory (CycloneDX 1.5) is of what labcal and its extras need, as
installed in the environment that runs this.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Iterable
from email import message_from_string
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tools" / "bundle"))

from make import licence_of  # noqa: E402

LEFT_BEHIND = {".gitignore"}
BUILDS = ((1.6e9, 0o022), (1.7e9, 0o077))  # age of the files [s since 1970], and the umask they were written with


def tracked() -> list[str]:
    """The files that git tracks."""
    told = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False).stdout
    if not told:
        sys.exit("git tracks nothing here: a release is built from a checkout, not from an unpacked sdist")
    return [name for name in told.splitlines() if (ROOT / name).is_file()]


def build(folder: Path, names: Iterable[str], age_s: float, umask: int, epoch: str) -> dict[str, bytes]:
    """Wheel and sdist by name, built in `folder` from a copy of the files."""
    for name in names:
        copy = folder / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, copy)
        copy.chmod(0o666 & ~umask)
        os.utime(copy, (age_s, age_s))
    command = [sys.executable, "-m", "hatchling", "build", "--directory", str(folder / "out")]
    subprocess.run(command, cwd=folder, check=True, capture_output=True, env={**os.environ, "SOURCE_DATE_EPOCH": epoch})
    return {path.name: path.read_bytes() for path in sorted((folder / "out").iterdir())}


def lacking(sdist: bytes, names: Iterable[str]) -> list[str]:
    """The files that the sdist does not have."""
    with tempfile.TemporaryFile() as file:
        file.write(sdist)
        file.seek(0)
        with tarfile.open(fileobj=file) as archive:
            inside = {name.partition("/")[2] for name in archive.getnames()}
    return sorted(set(names) - inside - LEFT_BEHIND)


def needed(name: str) -> list[Distribution]:
    """A distribution and all that it and its extras but `dev` need, as far as it is installed here."""
    extras = set(distribution(name).metadata.get_all("Provides-Extra") or ()) - {"dev"}
    found, done = dict[str, Distribution](), set[str]()
    waiting = [Requirement(f"{name}[{','.join(sorted(extras))}]")]
    while waiting:
        one = waiting.pop()
        if str(one) in done:
            continue
        done.add(str(one))
        try:
            there = found[str(canonicalize_name(one.name))] = distribution(one.name)
        except PackageNotFoundError:
            continue
        needs = map(Requirement, there.requires or ())
        waiting += [
            need
            for need in needs
            if need.marker is None or any(need.marker.evaluate({"extra": extra}) for extra in one.extras or {""})
        ]
    return [found[key] for key in sorted(found)]


def licence(one: Distribution) -> str:
    """As it states it itself."""
    return licence_of(message_from_string(one.read_text("METADATA") or ""))


def inventory(found: Iterable[Distribution]) -> str:
    """CycloneDX 1.5: each with version and licence."""
    components = [
        {
            "type": "library",
            "name": (name := str(canonicalize_name(one.metadata["Name"]))),
            "version": one.version,
            "purl": f"pkg:pypi/{name}@{one.version}",
            "licenses": [{"license": {"name": licence(one)}}],
        }
        for one in found
    ]
    return json.dumps(
        {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1, "components": components}, indent=1
    )


def licences(found: Iterable[Distribution]) -> str:
    """A line a package."""
    return "".join(f"{one.metadata['Name']} {one.version}: {licence(one)}\n" for one in found)


def main() -> int:
    """Build, compare, write."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("--out", type=Path, default=ROOT / "dist")
    out: Path = asked.parse_args().out
    names = tracked()
    epoch = subprocess.run(["git", "log", "-1", "--format=%ct"], cwd=ROOT, capture_output=True, text=True, check=True)
    with tempfile.TemporaryDirectory() as folder:
        first, second = (
            build(Path(folder, str(number)), names, *how, epoch.stdout.strip()) for number, how in enumerate(BUILDS)
        )
    if first != second:
        print("two builds differ: " + ", ".join(name for name in first if first[name] != second.get(name)))
        return 1
    [sdist] = (content for name, content in first.items() if name.endswith(".tar.gz"))
    if missing := lacking(sdist, names):
        print("the sdist lacks " + ", ".join(missing))
        return 1
    out.mkdir(parents=True, exist_ok=True)
    found = needed("labcal")
    texts = {"inventory.cdx.json": inventory(found) + "\n", "licences.txt": licences(found)}
    for name, content in {**first, **{name: text.encode() for name, text in texts.items()}}.items():
        (out / name).write_bytes(content)
        print(f"{hashlib.sha256(content).hexdigest()}  {name}")
    print(f"two builds, the same bytes; {len(names)} files in the sdist; {len(found)} packages in the inventory")
    return 0


if __name__ == "__main__":
    sys.exit(main())
