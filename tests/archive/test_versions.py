"""The catalogue over the years: made, brought up to date with what is in it, and back from a dump."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import Bundle, rows_of
from postgres import Server, server

from labcal.cli import execute as labcal
from labcal.errors import InputError
from labcal.session import archiving

DUMP = Path(__file__).parents[1] / "golden" / "archive-1.sql"  # pg_dump of version 1: it is read for ever


@pytest.fixture
def empty(postgres: Server) -> Iterator[str]:
    """A database with nothing in it."""
    yield (name := postgres.database())
    with postgres.connect() as connection:
        connection.execute(f"DROP DATABASE {name} WITH (FORCE)")


def restore(server: Server, database: str, dump: str) -> None:
    """What psql would do, without what is for psql alone."""
    with server.connect(database) as connection:
        connection.execute(re.sub(r"^\\.*$", "", dump, flags=re.MULTILINE))


def dumped(server: Server, database: str) -> str:
    words = [server.programs / "pg_dump", "--inserts", "--no-owner", "--no-privileges", "-d", server.url(database)]
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def test_the_first_push_makes_it_and_it_is_what_the_tables_say(postgres: Server, empty: str, bundle: Bundle) -> None:
    from alembic.autogenerate import compare_metadata
    from alembic.runtime.migration import MigrationContext

    from labcal.archive.address import parse_address
    from labcal.archive.server import opened
    from labcal.archive.tables import METADATA

    assert archiving.push(postgres.url(empty), [str(bundle())]).runs == 1
    options = {"include_schemas": True, "version_table_schema": "labcal", "compare_type": True}
    with opened(parse_address(postgres.url(empty))) as archive, archive.transaction() as connection:
        context = MigrationContext.configure(connection, opts=options)
        assert compare_metadata(context, METADATA) == []


def test_the_version_that_is_looked_for_is_the_last_there_is() -> None:
    pytest.importorskip("alembic", reason="needs the extra `archive`")
    from alembic.script import ScriptDirectory

    from labcal.archive.tables import VERSION
    from labcal.archive.versions import MIGRATIONS

    assert ScriptDirectory(str(MIGRATIONS)).get_current_head() == VERSION


def test_an_archive_of_the_first_version_is_brought_up_to_date_with_what_is_in_it(
    postgres: Server, empty: str, bundle: Bundle
) -> None:
    restore(postgres, empty, DUMP.read_text(encoding="utf-8"))
    url = f"{postgres.url(empty)}&site=aalto"
    archiving.init_archive(url, None)
    assert [(one["site"], one["run_id"], one["dut_serial"]) for one in archiving.archived_runs(url)] == [
        ("aalto", "demo-0", "SN-1"),
        ("glasgow", "demo-0", "SN-2"),
    ]
    [found] = archiving.archived_calibrations(url, instrument="H-1", effect="offset-current", above=(0.0, "nT/A"))
    assert (found["run_id"], found["dut_serial"]) == ("r-2026-11-21-01", "FM-07")
    assert archiving.push(url, [str(bundle())]).runs == 0  # it is there
    assert archiving.push(url, [str(bundle("new"))]).runs == 1


def test_one_of_another_version_is_named_and_left_alone(
    postgres: Server, empty: str, capsys: pytest.CaptureFixture[str]
) -> None:
    archiving.init_archive(postgres.url(empty), None)
    for version, told in (("0000", "its owner runs `labcal archive init` once"), ("9999", "update labcal here")):
        with postgres.connect(empty) as connection:
            connection.execute("UPDATE labcal.alembic_version SET version_num = %s", (version,))
        assert labcal(["push", "--archive", postgres.url(empty)]) == 2
        assert told in capsys.readouterr().err
    with pytest.raises(InputError, match="update labcal here"):
        archiving.init_archive(postgres.url(empty), None)


@pytest.mark.slow
def test_an_archive_comes_back_from_its_dump_on_another_server(
    postgres: Server, database: str, url: str, bundle: Bundle, tmp_path: Path
) -> None:
    with postgres.connect() as connection:
        connection.execute("CREATE ROLE restored_reader LOGIN")
    archiving.push(url, [str(bundle()), str(bundle("r2"))])
    archiving.grant_in_archive(url, "restored_reader", "aalto", "read")
    with server() as other:
        restore(other, name := other.database(), dumped(postgres, database))
        place = url.replace(str(postgres.folder), str(other.folder)).replace(f"/{database}?", f"/{name}?")
        assert rows_of(other, name) == rows_of(postgres, database)
        assert archiving.push(place, [str(bundle()), str(bundle("r2"))]).runs == 0
        archiving.fetch_from_archive(place, "r2", None, tmp_path / "r2.zip")
        with other.connect() as connection:  # the role is there again, and its right with it, once it is granted
            connection.execute("CREATE ROLE restored_reader LOGIN")
        archiving.grant_in_archive(place, "restored_reader", "aalto", "read")
        reader = place.replace("//keeper@", "//restored_reader@")
        assert len(archiving.archived_runs(reader)) == 2
