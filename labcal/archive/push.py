"""What is added to the archive: each run, each calibration and each piece of an audit log whole, in a transaction.

The bundle of a run is kept before its rows: a push that is cut leaves at most a file that nobody names yet.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from typing import Any

from sqlalchemy import Connection, Table, func, select
from sqlalchemy.dialects.postgresql import insert

from labcal.archive import rows, tables
from labcal.archive.bundles import put
from labcal.archive.run_to_push import RunToPush
from labcal.archive.server import Archive
from labcal.model import Calibration


@dataclass(frozen=True, slots=True)
class Document:
    """A signature or a report of a calibration. `signer` and `objection` are what its lab saw in the signature."""

    kind: str
    name: str
    content: bytes
    signer: str = ""
    objection: str = ""

    @property
    def sha256(self) -> str:
        """Of its content."""
        return sha256(self.content).hexdigest()


@dataclass(frozen=True, slots=True)
class AuditRow:
    """An entry of an audit log as it stands there: its bytes, its signature, and what a list shows of it."""

    number: int
    link: str
    utc: str
    deed: str
    who: str
    machine: str
    entry: bytes
    signature: bytes


@dataclass(frozen=True, slots=True)
class Placed:
    """A run whose bundle is kept where bundles lie; its rows are not in the catalogue yet."""

    run: RunToPush  # without its zip
    bundle_sha256: str
    bundle_bytes: int


@dataclass(frozen=True, slots=True)
class Known:
    """What the archive has of a site, as far as it can be known without reading runs."""

    runs: frozenset[str]  # SHA-256 of each
    heads: Mapping[str, str]  # {head of the chain in a store: SHA-256 of the run}
    documents: frozenset[tuple[str, str]]  # SHA-256 of the calibration, of the document


def known(archive: Archive, site: str) -> Known:
    """What is there of this site. A head whose run is not there, or a document without its file, says nothing.

    The two are put together here: a planner that has not counted rows yet compares each with each.
    """
    heads, documents = tables.KEPT_HEAD.c, tables.DOCUMENT.c
    with archive.transaction() as connection:
        runs = frozenset(connection.scalars(select(tables.RUN.c.sha256).where(tables.RUN.c.site == site)))
        files = set(connection.scalars(select(tables.CALIBRATION.c.sha256).where(tables.CALIBRATION.c.site == site)))
        kept = connection.execute(select(heads.head, heads.sha256).where(heads.site == site)).all()
        beside = connection.execute(select(documents["of"], documents.sha256).where(documents.site == site)).all()
    return Known(
        runs,
        {str(head): str(digest) for head, digest in kept if digest in runs},
        frozenset((str(of), str(digest)) for of, digest in beside if of in files),
    )


def run_there(archive: Archive, site: str, digest: str) -> Mapping[str, Any] | None:
    """The row of this site's run of this SHA-256; None where it is not there."""
    there = select(tables.RUN).where(tables.RUN.c.site == site, tables.RUN.c.sha256 == digest)
    with archive.transaction() as connection:
        row = connection.execute(there).mappings().one_or_none()
        return None if row is None else dict(row)


def note_head(archive: Archive, site: str, head: str | None, digest: str) -> None:
    """Keep that a store's chain of this head is a run that is there: it need not be read again."""
    with archive.transaction() as connection:
        _add(connection, tables.KEPT_HEAD, site, [] if head is None else [{"head": head, "sha256": digest}])


def push_run(archive: Archive, site: str, one: RunToPush, place: str) -> bool:
    """Add a run: its bundle at `place`, then its rows. Returns whether it is new here."""
    return push_placed(archive, site, [put_in_place(place, one)]) == {one.sha256}


def put_in_place(place: str, one: RunToPush) -> Placed:
    """Keep the bundle of a run at `place`: the first half of adding it."""
    return Placed(replace(one, zipped=b""), put(place, one.zipped, one.bundle_sha256), len(one.zipped))


def push_placed(archive: Archive, site: str, found: Iterable[Placed]) -> set[str]:
    """Add the rows of runs whose bundles are kept, all or none of them. Returns the SHA-256 of those new here.

    One commit for all: each waits for the server's disk. In the order of their SHA-256, so that two pushes of the same
    runs wait for each other and never both.
    """
    ordered = sorted(found, key=lambda one: one.run.sha256)
    heads = [{"head": one.run.kept_head, "sha256": one.run.sha256} for one in ordered if one.run.kept_head is not None]
    with archive.transaction() as connection:
        new = _add_runs(connection, [{"site": site, **_run_row(one)} for one in ordered])
        used = ((one.run.sha256, each) for one in ordered if one.run.sha256 in new for each in one.run.instruments)
        _add(connection, tables.INSTRUMENT, site, [{"of": digest, **each} for digest, each in used])
        _add(connection, tables.KEPT_HEAD, site, heads)
    return new


def _run_row(placed: Placed) -> dict[str, Any]:
    one = placed.run
    return one.row | {
        "sha256": one.sha256,
        "chain_head": one.chain_head,
        "bundle_sha256": placed.bundle_sha256,
        "bundle_bytes": placed.bundle_bytes,
    }


def _add_runs(connection: Connection, found: Sequence[dict[str, Any]]) -> set[str]:
    """Add the rows of runs, in one statement; returns the SHA-256 of those new here."""
    if not found:
        return set()
    added = insert(tables.RUN).on_conflict_do_nothing().returning(tables.RUN.c.sha256)
    return set(connection.scalars(added, found))


def push_calibration(
    archive: Archive,
    site: str,
    calibration: Calibration,
    content: bytes,
    documents: Sequence[Document],
) -> bool:
    """Add a calibration with what was found, its signatures and reports. Returns whether anything of it is new here."""
    digest = sha256(content).hexdigest()
    row = rows.calibration_row(calibration) | {"sha256": digest, "content": content}
    with archive.transaction() as connection:
        new = _add(connection, tables.CALIBRATION, site, [row]) > 0
        if new:
            of = {"calibration": digest}
            _add(connection, tables.EFFECT, site, [of | one for one in rows.effect_rows(calibration)])
            _add(connection, tables.PARAMETER, site, [of | one for one in rows.parameter_rows(calibration)])
            found = rows.instruments_of_calibration(calibration)
            _add(connection, tables.INSTRUMENT, site, [{"of": digest, **one} for one in found])
        return _add(connection, tables.DOCUMENT, site, [_document(digest, one) for one in documents]) > 0 or new


def last_entry(archive: Archive, site: str, log: str) -> tuple[int, frozenset[str]]:
    """The number of the last entry of an audit log that is there, 0 where none is, and the links of that number."""
    c = tables.AUDIT.c
    own = select(c.number, c.link).where(c.site == site, c.log == log)
    last = own.where(c.number == select(func.max(c.number)).where(c.site == site, c.log == log).scalar_subquery())
    with archive.transaction() as connection:
        found = [(int(number), str(link)) for number, link in connection.execute(last)]
    return (found[0][0] if found else 0), frozenset(link for _, link in found)


def push_audit(archive: Archive, site: str, log: str, entries: Iterable[AuditRow]) -> int:
    """Add entries of an audit log; returns how many are new here."""
    found = [{"log": log} | {name: getattr(one, name) for name in AuditRow.__slots__} for one in entries]
    with archive.transaction() as connection:
        return _add(connection, tables.AUDIT, site, found)


def _document(of: str, one: Document) -> dict[str, Any]:
    return {"of": of, "sha256": one.sha256} | {name: getattr(one, name) for name in Document.__slots__}


def _add(connection: Connection, table: Table, site: str, found: Sequence[dict[str, Any]]) -> int:
    """Add rows; those whose key is there stay as they are. Returns how many are new."""
    if not found:
        return 0
    added = insert(table).on_conflict_do_nothing()
    options = {"preserve_rowcount": True}
    return connection.execute(added, [{"site": site, **row} for row in found], execution_options=options).rowcount
