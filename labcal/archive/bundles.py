"""Runs as files that never change: each a zip called by its SHA-256, in a folder or wherever fsspec reaches (S3)."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path
from typing import Any

from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.files.text_safety import without_passwords

FOR_ALL_TO_READ = 0o444
LARGEST = 2**31


def put(place: str, content: bytes, known: str = "") -> str:
    """Keep `content` at `place`, whole or not at all; the same again changes nothing. Returns its SHA-256.

    It may be known: a bundle is large. Raises InputError where the place cannot be written.
    """
    digest = known or sha256(content).hexdigest()
    if "://" in place:
        _put_elsewhere(place, digest, content)
        return digest
    path = Path(place).expanduser() / _name(digest)
    try:
        if not path.is_file() or sha256(path.read_bytes()).hexdigest() != digest:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_bytes(path, content, FOR_ALL_TO_READ)
    except OSError as error:
        raise _not_reached(place, error) from None
    return digest


def get(place: str, digest: str) -> bytes:
    """What is kept at `place` under this SHA-256. Raises InputError where it is not there, or is not that."""
    where = f"{without_passwords(place).rstrip('/')}/{_name(digest)}"
    try:
        content = _get_elsewhere(place, digest) if "://" in place else _from_folder(place, digest)
    except FileNotFoundError:
        message = "is not there; `?bundles=PLACE` at the end of the archive's URL says where bundles lie"
        raise InputError(message, file=where) from None
    if sha256(content).hexdigest() != digest:
        raise InputError("is damaged: its content is not the one that it is called by", file=where)
    return content


def _name(digest: str) -> str:
    return f"{digest[:2]}/{digest}.zip"


def _from_folder(place: str, digest: str) -> bytes:
    with (Path(place).expanduser() / _name(digest)).open("rb") as file:
        return file.read(LARGEST)


def _put_elsewhere(place: str, digest: str, content: bytes) -> None:
    files, root = _elsewhere(place)
    path = f"{root}/{_name(digest)}"
    try:
        if not files.exists(path) or sha256(files.cat_file(path)).hexdigest() != digest:
            files.makedirs(path.rpartition("/")[0], exist_ok=True)
            files.pipe_file(path, content)
    except Exception as error:  # S3's own, of no connection or no credentials, are no OSError
        raise _not_reached(place, error) from None


def _get_elsewhere(place: str, digest: str) -> bytes:
    files, root = _elsewhere(place)
    try:
        return bytes(files.cat_file(f"{root}/{_name(digest)}"))
    except FileNotFoundError:
        raise
    except Exception as error:
        raise _not_reached(place, error) from None


def _elsewhere(place: str) -> tuple[Any, str]:
    """The file system of fsspec that `place` names, and the path in it."""
    try:
        from fsspec.core import url_to_fs

        files, root = url_to_fs(place)
    except ImportError as missing:
        name = (missing.name or "fsspec").partition(".")[0]
        message = f"bundles at {place.partition(':')[0]}:// need {name}: pip install fsspec and what it asks for (s3fs)"
        raise InputError(message) from None
    except ValueError as error:
        raise _not_reached(place, error) from None
    return files, str(root).rstrip("/")


def _not_reached(place: str, error: Exception) -> InputError:
    message = without_passwords(" ".join(str(error).split()))
    return InputError(f"{without_passwords(place)}: bundles cannot be kept or read there: {message}")
