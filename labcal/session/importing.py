"""What `labcal import --from` takes in, by the name of what the file is: one table, one function a kind."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from labcal import importers
from labcal.errors import InputError
from labcal.files.atomic import write_text
from labcal.files.outputs import Output, claim, writing
from labcal.session.records import import_bundle
from labcal.store import Bundle, bundle_files, bundle_of, save_bundle
from labcal.store.limits import LARGEST


@dataclass(frozen=True, slots=True)
class ImportRequest:
    """The words of one `labcal import --from`."""

    path: Path
    kind: str
    map: Path | None = None
    guess: bool = False
    out: Path | None = None
    force: bool = False


@dataclass(frozen=True, slots=True)
class ImportResult:
    """What is said of it: `remarks` while it was read, and `result`, the run id, the file, or a mapping's text."""

    result: str
    remarks: tuple[str, ...] = ()


def import_foreign(asked: ImportRequest) -> ImportResult:
    """Take in what others wrote. Raises InputError where that is nothing labcal knows."""
    if asked.kind not in IMPORTS:
        from labcal.session.foreign_calibration import FOREIGN_CALIBRATIONS

        kinds = ", ".join((*IMPORTS, *FOREIGN_CALIBRATIONS))
        raise InputError(f"there is no --from {asked.kind[:40]!r}; it is one of {kinds}, or left out: a bundle")
    return IMPORTS[asked.kind](asked)


def _recording(asked: ImportRequest) -> ImportResult:
    """A recording by its mapping: into the store, or to `out` as a bundle; with `guess` the mapping alone."""
    if asked.guess:
        return _guessed(asked)
    if asked.map is None:
        what = "needs a mapping that says what its columns are: --guess --map MAP.toml writes one to be checked"
        raise InputError(what, file=asked.path)
    mapping = importers.read_mapping(asked.map)
    inputs = [*importers.files_of(asked.path, mapping), asked.map]
    outputs = _claimed(asked.out, inputs, asked.force) if asked.out is not None else []
    found = importers.take_in(asked.path, asked.kind, mapping)
    bundle = _checked(bundle_of(found.run), asked.path)
    if asked.out is None:
        return ImportResult(_into_the_store(bundle, asked.path), found.remarks)
    with writing(outputs):
        save_bundle(bundle, asked.out)
    return ImportResult(str(asked.out), found.remarks)


def _guessed(asked: ImportRequest) -> ImportResult:
    from labcal.importers.guess import guess

    if asked.out is not None:
        raise InputError(
            "a guess is for a person to check: --guess --map MAP.toml first, then --map MAP.toml --out BUNDLE"
        )
    outputs = claim("import", asked.map, inputs=[asked.path], force=asked.force)
    text = guess(asked.path, asked.kind)
    if asked.map is None:
        return ImportResult(text)
    with writing(outputs):
        write_text(asked.map, text)
    return ImportResult(str(asked.map), ("a guess: check every line of it before it is used",))


def _claimed(out: Path, inputs: list[Path], force: bool) -> list[Output]:
    """The bundle's files. Raises InputError where `out` is a folder of something else."""
    if not out.is_dir():
        claim("import", out, inputs=inputs, force=force)  # its name and its folder
    elif {file.name for file in out.iterdir()} - LARGEST.keys():
        raise InputError("is a folder that holds other things; name a new one, or a file that ends in .zip", file=out)
    return claim("import", *bundle_files(out), inputs=inputs, force=force, with_folder=out.suffix.lower() != ".zip")


def _checked(bundle: Bundle, path: Path) -> Bundle:
    """The bundle, once it reads back. Raises InputError where it says what no bundle may."""
    try:
        bundle.run()
    except InputError as error:
        where = f" ({', '.join(str(x) for x in (error.line, error.column) if x)})" if error.line or error.column else ""
        raise InputError(f"gives no bundle: {error.what}{where}", file=path) from None
    return bundle


def _into_the_store(bundle: Bundle, path: Path) -> str:
    """The run's id. Raises InputError, of the recording, where another run has it already."""
    with TemporaryDirectory() as folder:
        save_bundle(bundle, Path(folder))
        try:
            return import_bundle(Path(folder))
        except InputError as error:
            raise InputError(error.what, file=path) from None


IMPORTS: Mapping[str, Callable[[ImportRequest], ImportResult]] = dict.fromkeys(importers.READERS, _recording)
