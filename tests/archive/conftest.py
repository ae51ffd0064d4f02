"""One temporary PostgreSQL for all tests of the archive, emptied for each."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from postgres import NoServerError, Server, server

from labcal.session import archiving

GOLDEN = Path(__file__).parents[1] / "golden"
Bundle = Callable[..., Path]
TABLES = (
    "run",
    "kept_head",
    "instrument",
    "calibration",
    "effect",
    "parameter",
    "document",
    "audit",
    "member",
    "setting",
)


Rows = list[tuple[object, ...]]
Everything = dict[str, Rows]


def rows_of(server: Server, database: str) -> Everything:
    """All rows of the catalogue."""
    with server.connect(database) as connection:
        return {
            one: connection.execute(f"SELECT * FROM labcal.{one} ORDER BY 1, 2, 3").fetchall() for one in TABLES[:8]
        }


class InArchive(NamedTuple):
    """Rows of the runs without when they came, of their instruments and heads, and the bundles by name."""

    runs: Rows
    beside: Rows
    bundles: dict[str, bytes]


def in_archive(server: Server, database: str, bundles: Path) -> InArchive:
    """What came of pushes, to be compared with what came of others."""
    rows = rows_of(server, database)
    files = {path.name: path.read_bytes() for path in bundles.rglob("*.zip")}
    return InArchive([row[:-2] for row in rows["run"]], [*rows["instrument"], *rows["kept_head"]], files)


@pytest.fixture(scope="session")
def postgres() -> Iterator[Server]:
    for library in ("sqlalchemy", "alembic", "psycopg"):
        pytest.importorskip(library, reason="needs the extra `archive`: pip install 'labcal[archive]'")
    try:
        with server() as running:
            yield running
    except NoServerError as reason:
        pytest.skip(str(reason))  # it says which program is missing, or what it said when it did not start


@pytest.fixture(scope="session")
def catalogue(postgres: Server) -> str:
    """A database with a catalogue in it."""
    made = postgres.database()
    archiving.init_archive(postgres.url(made), None)
    return made


@pytest.fixture
def database(postgres: Server, catalogue: str) -> str:
    """The same, with nothing in it: to make a database for each test takes longer than most tests."""
    with postgres.connect(catalogue) as connection:
        connection.execute(f"TRUNCATE {', '.join(f'labcal.{name}' for name in TABLES)}")
    return catalogue


@pytest.fixture
def url(postgres: Server, database: str, tmp_path: Path) -> str:
    return f"{postgres.url(database)}&bundles={tmp_path / 'bundles'}&site=aalto"


@pytest.fixture
def bundle(tmp_path: Path) -> Bundle:
    """Write the small golden bundle as a run of this name and DUT."""

    def write(run_id: str = "demo-0", serial: str = "SN-1", note: str = "") -> Path:
        header = json.loads((GOLDEN / "bundle-small.json").read_text())
        header["run_id"], header["dut"]["serial"] = run_id, serial
        header["segments"][0]["note"] = note
        folder = tmp_path / f"{run_id}-{serial}-{note}"
        folder.mkdir(exist_ok=True)
        (folder / "run.json").write_text(json.dumps(header, indent=1))
        (folder / "samples.csv").write_bytes((GOLDEN / "bundle-small.csv").read_bytes())
        return folder

    return write
