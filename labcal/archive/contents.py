"""All that is there, one after the other, to be compared with what it was made from."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from sqlalchemy import Connection, Table, select

from labcal.archive.server import Archive
from labcal.archive.tables import CALIBRATION, DOCUMENT, EFFECT, INSTRUMENT, PARAMETER, RUN

Row = dict[str, Any]


@dataclass(frozen=True, slots=True)
class OfCalibration:
    """A calibration's row, its file's bytes, and the rows that were made from it, in their order.

    `documents` are name, SHA-256 and content of each.
    """

    row: Row
    content: bytes
    effects: list[Row]
    parameters: list[Row]
    instruments: list[Row]
    documents: list[tuple[str, str, bytes]]


def runs(archive: Archive) -> list[Row]:
    """The rows of all runs that this role may see."""
    with archive.transaction() as connection:
        asked = select(RUN).order_by(RUN.c.site, RUN.c.started_utc, RUN.c.sha256)
        return [dict(row) for row in connection.execute(asked).mappings()]


def calibrations(archive: Archive) -> Iterator[OfCalibration]:
    """All calibrations that this role may see, each in a transaction of its own."""
    c = CALIBRATION.c
    with archive.transaction() as connection:
        keys = connection.execute(select(c.site, c.sha256).order_by(c.site, c.issued_utc, c.sha256)).all()
    for site, digest in keys:
        with archive.transaction() as connection:
            yield _one(connection, site, digest)


def _one(connection: Connection, site: str, digest: str) -> OfCalibration:
    c, d = CALIBRATION.c, DOCUMENT.c
    row = dict(connection.execute(select(CALIBRATION).where(c.site == site, c.sha256 == digest)).mappings().one())
    effects = _rows(connection, EFFECT, "calibration", site, digest)
    parameters = _rows(connection, PARAMETER, "calibration", site, digest)
    asked = select(d.name, d.sha256, d.content).where(d.site == site, d["of"] == digest)
    documents = [(str(name), str(sha), bytes(content)) for name, sha, content in connection.execute(asked)]
    instruments = _rows(connection, INSTRUMENT, "of", site, digest)
    return OfCalibration(row, bytes(row.pop("content")), effects, parameters, instruments, documents)


def _rows(connection: Connection, table: Table, of: str, site: str, digest: str) -> list[Row]:
    """The rows of a calibration in their order, without site and calibration."""
    mine = [column for column in table.c if column.key not in ("site", of)]
    asked = select(*mine).where(table.c.site == site, table.c[of] == digest).order_by(table.c.number)
    return [dict(row) for row in connection.execute(asked).mappings()]
