"""Where the store, the keys and the settings of this user lie, for nobody else to read."""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

FOLDER, FILE = 0o700, 0o600
DEEP = 3  # parts of a path; what is no deeper may be the system's
PASSPHRASE = "LABCAL_PASSPHRASE"
ARCHIVE = "LABCAL_ARCHIVE"  # a URL, which may state a password
SMTP_PASSWORD = "LABCAL_SMTP_PASSWORD"
WEBHOOK = "LABCAL_WEBHOOK"  # addresses, whose paths are often their passwords
OF_S3 = ("AWS_SECRET_ACCESS_KEY", "AWS_SESSION_TOKEN")  # where the archive's bundles lie there
SECRETS = (PASSPHRASE, ARCHIVE, "PGPASSWORD", SMTP_PASSWORD, WEBHOOK, *OF_S3)


def home() -> Path:
    """The folder `LABCAL_HOME` names, else the user's data folder for labcal. It need not exist yet."""
    if stated := os.environ.get("LABCAL_HOME"):
        return Path(stated).expanduser()
    import platformdirs

    return platformdirs.user_data_path("labcal", appauthor=False)


def own_folder(path: Path) -> Path:
    """Make the folder `path` for this user alone (0700), whatever the umask; one of the user's own is tightened.

    Not so one that others share by its nature: a sticky one, the user's home, one as near the root as /var/lib.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    with suppress(FileExistsError):
        path.mkdir(mode=FOLDER)
    whole = path.resolve()
    if len(whole.parts) > DEEP and whole != Path.home().resolve():
        _tighten(path, FOLDER)
    return path


def own_file(path: Path) -> Path:
    """Have the file `path` be for this user alone (0600), whatever the umask; made empty where it is absent."""
    with suppress(FileExistsError):
        os.close(os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, FILE))
    return tightened(path)


def tightened(path: Path) -> Path:
    """The file `path`, for this user alone where it is this user's; what is absent or another's stays as it is."""
    _tighten(path, FILE)
    return path


def file_at_home(name: str) -> Path:
    """A file in labcal's folder, both made and for this user alone. Raises OSError where there is no place."""
    return own_file(own_folder(home()) / name)


def for_children() -> dict[str, str]:
    """The environment for a process that labcal starts: what is secret stays here."""
    return {name: value for name, value in os.environ.items() if name not in SECRETS}


@contextmanager
def secrets_aside() -> Iterator[None]:
    """Within, this process's own environment has no secret: what a library starts by itself inherits none."""
    aside = {name: os.environ.pop(name) for name in SECRETS if name in os.environ}
    try:
        yield
    finally:
        os.environ.update(aside)


def _tighten(path: Path, mode: int) -> None:
    if sys.platform == "win32":
        return
    with suppress(OSError):  # absent, or on a disk that knows no modes or may not be written
        found = path.stat()
        shared = bool(found.st_mode & stat.S_ISVTX) or not (stat.S_ISDIR(found.st_mode) or stat.S_ISREG(found.st_mode))
        if found.st_uid == os.geteuid() and not shared and found.st_mode & 0o077:
            os.chmod(path, stat.S_IMODE(found.st_mode) & mode)
