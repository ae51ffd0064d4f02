"""Run bundles: a folder, or a zip of it, with run.json, samples.csv and, where it was recorded so, chain.jsonl."""

from __future__ import annotations

import json
import stat
import zipfile
import zlib
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path, PurePosixPath
from typing import IO, Any

from labcal.errors import InputError
from labcal.files.atomic import replacing, write_bytes
from labcal.record import Run
from labcal.store.chain import Chain
from labcal.store.limits import CHAIN_JSONL, FREELY, INFLATED, LARGEST, MOST_FILES, RUN_JSON, SAMPLES_CSV, MiB
from labcal.store.origin import shown
from labcal.store.run_json import read_run_json, write_run_json
from labcal.store.samples_csv import read_samples, write_samples
from labcal.store.zip_directory import refuse_a_long_directory
from labcal.store.zip_writing import deflaters, zip_of


@dataclass(frozen=True, slots=True)
class Bundle:
    """The files of a bundle, byte for byte, and where they came from (for messages).

    `chain` is chain.jsonl, empty where there is none; `origin` its head, None where the run's origin is not shown.
    """

    run_json: bytes
    samples_csv: bytes
    source: Path = Path()
    of_store: bool = False
    chain: bytes = b""
    origin: Chain | None = None

    @property
    def stated_chain(self) -> dict[str, Any] | None:
        """The head of its chain as a calibration states it; None where the run's origin is not shown."""
        return None if self.origin is None else self.origin.stated()

    @property
    def cage_sha256(self) -> str | None:
        """SHA-256 of the approved cage calibration that drove the run, as its chain has it; None where none did."""
        if not self.chain:
            return None
        header: dict[str, Any] = json.loads(json.loads(self.chain.partition(b"\n")[0])["header"])
        return header.get("cage_sha256")

    @property
    def sha256(self) -> str:
        """SHA-256 of `sha256(run.json)\\nsha256(samples.csv)\\n`, lower-case hex (contract: run_sha256)."""
        digests = (sha256(part).hexdigest() for part in (self.run_json, self.samples_csv))
        return sha256("".join(f"{digest}\n" for digest in digests).encode()).hexdigest()

    def run(self) -> Run:
        """The run that the files hold. Raises InputError with file, line and column at the first fault."""
        header = read_run_json(self.run_json, file=self.source / RUN_JSON, of_store=self.of_store)
        return read_samples(self.samples_csv, header, file=self.source / SAMPLES_CSV)


def bundle_of(run: Run) -> Bundle:
    """The files that stand for `run`: the same bytes whenever they are made."""
    return Bundle(write_run_json(run), write_samples(run), Path(run.run_id))


def load_bundle(path: Path) -> Bundle:
    """The bytes of a bundle, folder or zip. Raises InputError where it is no bundle.

    They are unread, unless there is a chain: then they must be what its rows make.
    """
    bundle = _bytes_of(path)
    if not bundle.chain:
        return bundle
    bundle.run()  # a fault of its own comes first
    origin = shown(bundle.chain, bundle.run_json, bundle.samples_csv, path / CHAIN_JSONL)
    return replace(bundle, origin=origin)


def _bytes_of(path: Path) -> Bundle:
    if path.is_dir():
        run_json, samples_csv = _from_folder(path, RUN_JSON), _from_folder(path, SAMPLES_CSV)
        return Bundle(run_json, samples_csv, path, chain=_chain_in(path))
    if not path.exists():
        raise InputError("there is no such file or folder", file=path)
    if not path.is_file():
        raise InputError("expected a folder or a zip file", file=path)
    return _from_zip(path)


def read_bundle(path: Path) -> Run:
    """Read a bundle, folder or zip. Raises InputError with file, line and column at the first fault."""
    return load_bundle(path).run()


def bundle_files(path: Path) -> list[Path]:
    """The files that `save_bundle` writes at `path`, the chain though the bundle may have none."""
    return [path] if path.suffix.lower() == ".zip" else [path / name for name in LARGEST]


def save_bundle(bundle: Bundle, path: Path) -> None:
    """Write the bundle to `path`: a zip where the name ends in .zip, the same bytes on every PC; else a folder."""
    if path.suffix.lower() == ".zip":
        write_bytes(path, zip_of(_members_of(bundle), zlib))
        return
    if path.exists() and not path.is_dir():
        raise InputError("is a file; a bundle is a folder, or a name that ends in .zip", file=path)
    path.mkdir(parents=True, exist_ok=True)
    with replacing(path / SAMPLES_CSV) as samples, replacing(path / RUN_JSON) as header:
        samples.write_bytes(bundle.samples_csv)
        header.write_bytes(bundle.run_json)
    if bundle.chain:
        write_bytes(path / CHAIN_JSONL, bundle.chain)
    else:
        (path / CHAIN_JSONL).unlink(missing_ok=True)  # another run's


def write_bundle(run: Run, path: Path) -> None:
    """Write `run` to `path`: a zip where the name ends in .zip, else a folder."""
    save_bundle(bundle_of(run), path)


def bundle_sha256(run: Run | Bundle) -> str:
    """`run_sha256` of a run's exported bundle, or of a bundle's own bytes (contract: calibration file)."""
    return (run if isinstance(run, Bundle) else bundle_of(run)).sha256


def _from_folder(folder: Path, name: str) -> bytes:
    path = folder / name
    if not path.exists() and not path.is_symlink():
        raise InputError(f"the bundle has no {name}", file=folder)
    if folder.resolve() not in path.resolve().parents:
        raise InputError("is a link that leads out of the bundle: put the file itself there", file=path)
    if not path.is_file():
        raise InputError("is no plain file: a folder, a device, a pipe or a broken link", file=path)
    with path.open("rb") as source:
        return _limited(source, LARGEST[name], path)


def _chain_in(folder: Path) -> bytes:
    path = folder / CHAIN_JSONL
    return _from_folder(folder, CHAIN_JSONL) if path.exists() or path.is_symlink() else b""


def _limited(source: IO[bytes], most: int, path: Path) -> bytes:
    """All that `source` gives. Raises InputError where that is more than `most` bytes."""
    content = source.read(most + 1)
    if len(content) > most:
        raise InputError(f"is larger than {most // MiB} MiB: split the run", file=path)
    return content


def zipped(bundle: Bundle) -> bytes:
    """The bundle as a zip: the same bytes whenever it is made by the same deflate (see `zip_writing`)."""
    return zip_of(_members_of(bundle))


def zipped_as(bundle: Bundle, digest: str) -> bytes | None:
    """The bundle as the zip of this SHA-256, whichever deflate made it; None where none that is here does."""
    made = (zip_of(_members_of(bundle), deflater) for deflater in deflaters())
    return next((content for content in made if sha256(content).hexdigest() == digest), None)


def _members_of(bundle: Bundle) -> list[tuple[str, bytes]]:
    found = zip(LARGEST, (bundle.run_json, bundle.samples_csv, bundle.chain), strict=True)
    return [(name, content) for name, content in found if content or name != CHAIN_JSONL]


def _from_zip(path: Path) -> Bundle:
    try:
        refuse_a_long_directory(path)
        with zipfile.ZipFile(path) as archive:
            members = _members(archive, path)
            found = {name: _content(archive, member, path) for name, member in members.items()}
            return Bundle(found[RUN_JSON], found[SAMPLES_CSV], path, chain=found.get(CHAIN_JSONL, b""))
    except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, ValueError, OverflowError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"not a readable zip file: {error}", file=path) from None


def _members(archive: zipfile.ZipFile, path: Path) -> dict[str, zipfile.ZipInfo]:
    """Its files, at the top or together in one folder. Refuses paths that climb out, links and doubles."""
    found: dict[str, zipfile.ZipInfo] = {}
    folders: set[PurePosixPath] = set()
    if len(archive.infolist()) > MOST_FILES:
        raise InputError(f"the zip has {len(archive.infolist())} files; a bundle has three", file=path)
    for member in archive.infolist():
        name = PurePosixPath(member.filename.replace("\\", "/"))
        if name.is_absolute() or ".." in name.parts or ":" in member.filename:
            raise InputError(f"the zip has a path that climbs out of it: {member.filename[:80]!r}", file=path)
        if stat.S_ISLNK(member.external_attr >> 16):
            raise InputError(f"the zip has a link in it: {member.filename[:80]!r}", file=path)
        if name.name in LARGEST and len(name.parts) <= 2:
            if name.name in found:
                raise InputError(f"the zip has two files called {name.name}", file=path)
            found[name.name] = member
            folders.add(name.parent)
    for required in (RUN_JSON, SAMPLES_CSV):
        if required not in found:
            raise InputError(f"the bundle has no {required}", file=path)
    if len(folders) > 1:
        raise InputError(f"{' and '.join(found)} lie in different folders of the zip", file=path)
    return found


def _content(archive: zipfile.ZipFile, member: zipfile.ZipInfo, path: Path) -> bytes:
    """One member's bytes, never more than allowed, whatever the zip says about its size."""
    name = PurePosixPath(member.filename).name
    if member.flag_bits & 1:
        raise InputError(f"{name} is encrypted", file=path)
    if member.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise InputError(f"{name} is compressed in an unusual way: zip it with deflate", file=path)
    if member.file_size > LARGEST[name]:
        raise InputError(f"{name} is larger than {LARGEST[name] // MiB} MiB: split the run", file=path)
    believed = max(FREELY, INFLATED * min(member.compress_size, path.stat().st_size))
    if member.file_size > believed:
        what = f"{name} would grow from {member.compress_size} to {member.file_size} bytes, as no recording does"
        raise InputError(what, file=path)
    with archive.open(member) as stream:
        return _limited(stream, min(LARGEST[name], believed), path / name)
