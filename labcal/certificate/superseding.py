"""Which calibration took the place of another, as far as this lab has seen it signed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from hashlib import sha256
from pathlib import Path

from labcal.certificate.calibration_file import LARGEST_BYTES, parse_calibration
from labcal.certificate.signing import Verification, signature_files
from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.files.home import FILE, own_folder
from labcal.files.plain_file import read_limited


def keep_superseding(found: Verification, folder: Path) -> None:
    """Keep a file that holds and supersedes another, with its signatures, in `folder`; nothing where it cannot be."""
    if not found.valid or found.calibration is None or found.calibration.supersedes is None:
        return
    name = f"{sha256(found.content).hexdigest()}.json"
    with suppress(OSError):
        own_folder(folder)
        for file in signature_files(found.file):
            write_bytes(folder / (name + file.name.removeprefix(found.file.name)), file.read_bytes(), FILE)
        write_bytes(folder / name, found.content, FILE)


def superseded_by(found: Verification, folders: Iterable[Path], check: Callable[[Path], Verification]) -> str | None:
    """The run of a calibration in `folders` that takes the place of this one and whose signatures hold by `check`."""
    if found.calibration is None:
        return None
    digest = sha256(found.content).hexdigest()
    for path in _naming(digest, folders):
        with suppress(InputError, OSError):
            later = check(path)
            if later.valid and later.calibration and _supersedes(later, digest, found):
                return later.calibration.run_id
    return None


def _supersedes(later: Verification, digest: str, found: Verification) -> bool:
    one, other = later.calibration, found.calibration
    if one is None or other is None or one.supersedes != digest:
        return False
    return (one.dut.serial, one.simulated) == (other.dut.serial, other.simulated)


def _naming(digest: str, folders: Iterable[Path]) -> Iterator[Path]:
    """Files in the folders that name this digest in `supersedes`, as far as they can be read."""
    for path in (file for folder in folders for file in sorted(folder.glob("*.json"))):
        with suppress(InputError, OSError):
            content = read_limited(path, LARGEST_BYTES)
            if digest.encode() in content and parse_calibration(content, path).supersedes == digest:
                yield path
