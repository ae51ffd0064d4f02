"""Whether labcal and all that it needs are there, as they were packed: versions, and each file's hash by its RECORD.

A RECORD lies beside the files that it lists: it shows damage and hand-made changes, not a forger.
"""

from __future__ import annotations

import hashlib
import sys
from base64 import urlsafe_b64encode
from collections.abc import Iterable
from importlib.metadata import Distribution, PackageNotFoundError, PackagePath, distribution

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from labcal.self_test.result import Check

NAMED = 3  # of several faults
CACHED = ".pyc"  # what Python makes of a source and pip makes anew, whatever a RECORD says of it


def check_versions(of: str = "labcal") -> Check:
    """Every package that labcal needs is there in a version that it takes."""
    found, wrong = closure(of)
    if wrong:
        return Check("", "FAIL", some(wrong), "Install labcal again; nothing else changes its environment.")
    return Check("", "pass", f"labcal {distribution(of).version}, {len(found) - 1} packages beside it, all in range")


def check_files(of: str = "labcal") -> Check:
    """Every file that has a hash in its package's RECORD is there and has it."""
    counted, wrong, changing = 0, list[str](), list[str]()
    for package in closure(of)[0]:
        if is_editable(package):
            changing.append(package.name)
        for file in package.files or ():
            if file.hash is not None and file.suffix != CACHED:
                counted += 1
                wrong += [] if sound(file) else [f"{package.name}: {file}"]
    if wrong:
        todo = "Install labcal again: its files here are not those that were packed."
        return Check(
            "", "FAIL", f"{len(wrong)} of {counted} files differ from their package's RECORD: {some(wrong)}", todo
        )
    if changing:
        said = f"{', '.join(changing)} runs from a folder that is worked on, whose files no RECORD lists"
        return Check("", "not shown", f"{said}; the other {counted} files are as they were packed")
    return Check("", "pass", f"{counted} files are as they were packed, by the SHA-256 in each package's RECORD")


def closure(of: str) -> tuple[list[Distribution], list[str]]:
    """The package, all that it needs here, and what of that is missing or of a wrong version."""
    found, wrong, waiting = dict[str, Distribution](), list[str](), [(of, "")]
    while waiting:
        name, extra = waiting.pop()
        if (key := canonicalize_name(name)) in found and not extra:
            continue
        try:
            found[key] = package = distribution(name)
        except PackageNotFoundError:
            wrong.append(f"{name} is not installed")
            continue
        for needed in requirements(package, extra):
            waiting += [(needed.name, extra) for extra in (needed.extras or {""})]
            if (there := version_of(needed.name)) and not needed.specifier.contains(there, prereleases=True):
                wrong.append(f"{package.name} needs {needed.name} {needed.specifier}, {there} is installed")
    return list(found.values()), sorted(set(wrong))


def requirements(package: Distribution, extra: str) -> Iterable[Requirement]:
    """What a package needs here, with one of its extras."""
    for text in package.requires or ():
        needed = Requirement(text)
        if needed.marker is None or needed.marker.evaluate({"extra": extra}):
            yield needed


def version_of(name: str) -> str:
    """The installed version; "" where there is none."""
    try:
        return distribution(name).version
    except PackageNotFoundError:
        return ""


def is_editable(package: Distribution) -> bool:
    """Whether its modules lie in a folder that somebody works on."""
    return '"editable": true' in (package.read_text("direct_url.json") or "")


def sound(file: PackagePath) -> bool:
    """Whether the file has the hash that its RECORD states, if it states one."""
    if file.hash is None:
        return True
    try:
        with open(str(file.locate()), "rb") as there:
            digest = hashlib.file_digest(there, file.hash.mode).digest()
    except OSError:
        return False
    return urlsafe_b64encode(digest).rstrip(b"=").decode() == file.hash.value


def some(of: list[str]) -> str:
    """The first of several, and how many more there are."""
    return "; ".join(of[:NAMED]) + (f"; and {len(of) - NAMED} more" if len(of) > NAMED else "")


def python_version() -> str:
    """In short."""
    return f"{sys.version.split()[0]} ({sys.implementation.name})"
