"""The archive that a command line or the environment names, opened, and what this lab is in it.

Its libraries (the extra `archive`) load with the first use.
"""

from __future__ import annotations

import os
import platform
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from labcal.errors import InputError
from labcal.files.home import ARCHIVE, home
from labcal.system.private_memory import kept_private

if TYPE_CHECKING:
    from labcal.archive.address import ServerAddress
    from labcal.archive.server import Archive

MISSING = "the archive needs SQLAlchemy, Alembic and psycopg: pip install 'labcal[archive]'"
LIBRARIES = ("sqlalchemy", "alembic", "psycopg")
BUNDLES = "bundles"  # in labcal's folder, where nobody says another place


def archive_address(given: str | None) -> ServerAddress:
    """What `--archive`, else LABCAL_ARCHIVE, names. Raises InputError: neither is there, or a password on view."""
    from labcal.archive.address import parse_address

    stated = given if given is not None else os.environ.get(ARCHIVE)
    if not stated:
        raise InputError(f"which archive? --archive URL, or the URL in {ARCHIVE} (docs/archive.md)")
    address = parse_address(stated)
    if address.has_password:
        kept_private()
    if given is not None and address.has_password:
        what = "everybody on this machine can read a password on a command line"
        raise InputError(f"{what}: put the URL into {ARCHIVE}, or the password into ~/.pgpass; and change it now")
    return address


@contextmanager
def opened(given: str | None, *, made: bool = False) -> Iterator[Archive]:
    """The archive that is named, its catalogue there (`made` where there is none) and of this version.

    Raises InputError.
    """
    with needing_the_extra():
        from labcal.archive import server, versions

        with server.opened(archive_address(given)) as archive:
            versions.check(archive, made=made)
            yield archive


@contextmanager
def needing_the_extra() -> Iterator[None]:
    """Within, a library that is not installed is one sentence."""
    try:
        yield
    except ImportError as missing:
        if (missing.name or "").partition(".")[0] in LIBRARIES or "libpq" in str(missing):
            raise InputError(MISSING) from None
        raise


def place_of_bundles(archive: Archive, stated: str | None = None) -> str:
    """Where bundles lie: as stated, else as the URL says, else the archive itself, else in labcal's own folder."""
    from labcal.archive.versions import setting

    return stated or archive.address.bundles or setting(archive, "bundles") or str(home() / BUNDLES)


def own_site(archive: Archive) -> str:
    """The site whose rows are pushed: as the URL says, else the role's one lab, else this machine's name."""
    from labcal.archive.rights import own_lab

    if archive.address.site:
        return archive.address.site
    with archive.transaction() as connection:
        return own_lab(connection) or platform.node() or "unnamed"
