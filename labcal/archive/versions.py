"""The catalogue's version: looked at before every use, made and brought up to date by `labcal archive init`."""

from __future__ import annotations

from pathlib import Path

from sqlalchemy import Connection, select, text

from labcal.archive.server import NOT_SET_UP, Archive
from labcal.archive.tables import SCHEMA, SETTING, VERSION
from labcal.errors import InputError

MIGRATIONS = Path(__file__).parent / "migrations"
ONE_AT_A_TIME = 0x6C616263  # the key of the lock under which the catalogue is made


def make(archive: Archive, bundles: str | None = None) -> str:
    """Make the catalogue, or bring it to this version; state where bundles lie. Returns its version.

    Raises InputError where a newer labcal made it, or this role may not.
    """
    with archive.transaction() as connection:
        connection.execute(text("SELECT pg_advisory_xact_lock(:key)"), {"key": ONE_AT_A_TIME})
        if (found := version(connection)) != VERSION:
            _refuse_newer(found, archive)
            _upgrade(connection)
        if bundles is not None:
            connection.execute(SETTING.delete().where(SETTING.c.name == "bundles"))
            connection.execute(SETTING.insert().values(name="bundles", value=bundles))
    return VERSION


def check(archive: Archive, *, made: bool = False) -> None:
    """Have a catalogue of this version there, `made` where there is none. Raises InputError where it is not so."""
    with archive.transaction() as connection:
        found = version(connection)
    if found is None and made:
        make(archive)
    elif found is None:
        raise InputError(f"{archive.address.shown}: {NOT_SET_UP}")
    elif found != VERSION:
        _refuse_newer(found, archive)
        older = f"its catalogue is of version {found}, and this labcal works with {VERSION}"
        raise InputError(f"{archive.address.shown}: {older}: its owner runs `labcal archive init` once")


def version(connection: Connection) -> str | None:
    """The version that the catalogue is of; None where there is none."""
    if not connection.scalar(text("SELECT to_regclass(:name)"), {"name": f"{SCHEMA}.alembic_version"}):
        return None
    return str(connection.scalar(text(f"SELECT version_num FROM {SCHEMA}.alembic_version")))


def _upgrade(connection: Connection) -> None:
    from alembic import command
    from alembic.config import Config

    connection.execute(text(f"CREATE SCHEMA IF NOT EXISTS {SCHEMA}"))
    config = Config(attributes={"connection": connection})
    config.set_main_option("script_location", str(MIGRATIONS).replace("%", "%%"))
    config.set_main_option("path_separator", "os")
    command.upgrade(config, "head")


def _refuse_newer(found: str | None, archive: Archive) -> None:
    if found is not None and found > VERSION:
        message = f"a newer labcal made its catalogue (version {found}, this one knows {VERSION}): update labcal here"
        raise InputError(f"{archive.address.shown}: {message}")


def setting(archive: Archive, name: str) -> str | None:
    """What the archive's owner stated for all sites; None where nothing."""
    with archive.transaction() as connection:
        return connection.scalar(select(SETTING.c.value).where(SETTING.c.name == name))
