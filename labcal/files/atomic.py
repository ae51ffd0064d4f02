"""Files that are whole or absent: written to a temporary name, flushed, then renamed."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from labcal.errors import InputError


@contextmanager
def replacing(path: Path, mode: int | None = None) -> Iterator[Path]:
    """Give a temporary path beside `path`; on success it is flushed to disk and takes the name, else it goes.

    A link stays, and what it points at is replaced. `mode` is the file's permissions (0o600 for a secret); by default
    the umask decides. Raises InputError where `path` is a folder or a device, which no file may replace, or lies in
    no folder.
    """
    replaceable(path)
    target = Path(os.path.realpath(path))
    part = _beside(target)
    try:
        yield part
        with part.open("rb+") as written:
            os.fsync(written.fileno())
        os.chmod(part, 0o666 & ~_umask() if mode is None else mode)
        part.replace(target)
    except BaseException as error:
        with suppress(FileNotFoundError):
            part.unlink()
        if isinstance(error, OSError) and error.filename in (None, str(part)):
            error.filename = str(path)  # the person named this one
        raise


def write_bytes(path: Path, content: bytes, mode: int | None = None) -> None:
    """Write `content` to `path`, whole or not at all."""
    with replacing(path, mode) as part:
        part.write_bytes(content)


def write_text(path: Path, content: str) -> None:
    """Write `content` to `path` as UTF-8 with LF line ends, whole or not at all."""
    write_bytes(path, content.encode())


def replaceable(path: Path) -> None:
    """Raise InputError where `path` is a folder or a device, or lies in no folder."""
    if path.exists() and not path.is_file():
        raise InputError("is a folder or a device; name a file", file=path)
    if not path.parent.is_dir():
        raise InputError("its folder does not exist", file=path)


def _beside(path: Path) -> Path:
    """An empty file of a new name in the folder of `path`."""
    import tempfile  # loads what chance needs: not for who only asks for a path

    try:
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name[:60]}.", suffix=".part")
    except OSError as error:
        error.filename = str(path)
        raise
    os.close(handle)
    return Path(name)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def absolute(path: Path) -> Path:
    """`path` from the root on, its links followed; one that leads nowhere or round in a circle stays as it is."""
    try:
        return path.resolve()
    except (OSError, RuntimeError):
        return Path(os.path.abspath(path))
