"""What a command may write over: asked before its work, and again at the moment of writing.

Never, with `--force` or without: a store, labcal's own folder, an input of the command, a signature, anything with a
signature beside it. Another file that is there only with `--force`, except where the same command wrote it and its
bytes are still those: each file written is remembered in labcal's folder, by its place, with its command and SHA-256.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

from labcal.errors import InputError
from labcal.files.atomic import replaceable, write_bytes
from labcal.files.home import FILE, home, own_folder

DRAFTS = "calibrations"  # in labcal's folder; all else there is labcal's own
SQLITE = b"SQLite format 3\0"
OF_A_STORE = re.compile(r"-(wal|shm|journal|writers)\Z")


@dataclass(frozen=True, slots=True)
class Output:
    """A file that `command` is about to write, having read `inputs`."""

    path: Path
    command: str
    inputs: tuple[Path, ...] = ()
    force: bool = False
    with_folder: bool = False  # the folder is made with it

    def check(self) -> None:
        """Raise InputError where the file may not be written, or only with `--force`."""
        there = _real(self.path)  # also where a folder on the way is not there yet
        for name in {self.path, there}:
            self._refuse_by_name(name)
        self._refuse_inputs(there)
        if not self.with_folder or there.exists():
            replaceable(there if self.with_folder else self.path)
        if there.exists() and not self.force and not _wrote(self.command, there):
            self._refuse("is there already; --force replaces it")

    @contextmanager
    def writing(self) -> Iterator[Path]:
        """Give the path to write to, asked about once more; what is written there is remembered."""
        self.check()
        yield self.path
        self.remember()

    def remember(self) -> None:
        """Keep that `command` wrote these bytes here. Where labcal's folder takes nothing, --force will be needed.

        What it could have written and did not is passed over.
        """
        if not self.path.exists():
            return
        said = {"path": str(_real(self.path)), "command": self.command, "sha256": _sha256(self.path)}
        with suppress(OSError):
            record = _record(self.path)
            own_folder(own_folder(home()) / record.parent.name)
            write_bytes(record, json.dumps(said).encode() + b"\n", FILE)

    def _refuse_by_name(self, name: Path) -> None:
        if name.name == "-":
            self._refuse("names no file: standard output takes only what --json writes")
        if name.is_symlink() and not name.exists():
            self._refuse("is a link to a file that is not there")
        if _is_own(name):
            self._refuse("would lie among what is labcal's own; name another folder")
        if _is_store(name):
            self._refuse("belongs to a store of runs: nothing replaces it, --force neither")
        if any(part.lower().endswith(".sshsig") for part in (name.name, name.parent.name)):
            self._refuse("is the name of a signature, which only `labcal sign` writes")
        if signature := _signature_beside(name):
            self._refuse(f"is signed ({signature}): nothing replaces it, --force neither")

    def _refuse_inputs(self, there: Path) -> None:
        for given in self.inputs:
            for read in (given, *(_files_in(given) if given.is_dir() else ())):
                if _real(read) == there or (read.exists() and there.exists() and there.samefile(read)):
                    self._refuse("is what this command reads: write the result to another file")

    def _refuse(self, what: str) -> NoReturn:
        raise InputError(what, file=self.path)


def claim(
    command: str,
    *paths: Path | None,
    inputs: Iterable[Path] = (),
    force: bool = False,
    with_folder: bool = False,
) -> list[Output]:
    """The files that `command` will write, in their order without those that are None.

    Raises InputError where one may not be written, or two are the same.
    """
    read = tuple(inputs)
    outputs = [Output(path, command, read, force, with_folder) for path in paths if path is not None]
    for number, output in enumerate(outputs):
        output.check()
        if _real(output.path) in {_real(other.path) for other in outputs[:number]}:
            raise InputError("two results would be written to it; name two files", file=output.path)
    return outputs


@contextmanager
def writing(outputs: Iterable[Output]) -> Iterator[None]:
    """Files that are written together: asked about once more, then remembered."""
    with ExitStack() as stack:
        for output in outputs:
            stack.enter_context(output.writing())
        yield


def _real(path: Path) -> Path:
    return Path(os.path.realpath(path))


def _is_own(path: Path) -> bool:
    """Whether `path` is labcal's folder or lies there; a draft in `calibrations` is a draft."""
    own, here = _real(home()), _real(path.parent) / path.name
    return here == own or (own in here.parents and (own / DRAFTS) not in here.parents)


def _is_store(path: Path) -> bool:
    """Whether `path` is a SQLite file, what SQLite keeps beside one, or the lock of a run's writer."""
    beside = [p.with_name(OF_A_STORE.sub("", p.name)) for p in (path, path.parent) if OF_A_STORE.search(p.name)]
    return any(_is_sqlite(candidate) for candidate in (path, *beside))


def _is_sqlite(path: Path) -> bool:
    if not path.is_file():
        return False
    with path.open("rb") as file:
        return file.read(len(SQLITE)) == SQLITE


def _signature_beside(path: Path) -> str | None:
    """The name of a signature of `path`, in whatever case of letters: some file systems see no difference."""
    numbered = re.compile(re.escape(path.name) + r"(\.\d+)?\.sshsig", re.IGNORECASE)
    there = os.listdir(path.parent) if path.parent.is_dir() else ()
    return next((name for name in sorted(there) if numbered.fullmatch(name)), None)


def _files_in(folder: Path) -> Iterator[Path]:
    return (path for path in folder.iterdir() if path.is_file())


def _wrote(command: str, path: Path) -> bool:
    """Whether `command` wrote the file at `path`, and its bytes are still those."""
    try:
        said = json.loads(_record(path).read_text(encoding="utf-8"))
        return (said["command"], said["sha256"]) == (command, _sha256(path))
    except (OSError, ValueError, KeyError, TypeError):
        return False


def _record(path: Path) -> Path:
    place = os.path.normcase(_real(path))
    return home() / "written" / f"{hashlib.sha256(os.fsencode(place)).hexdigest()}.json"


def _sha256(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
