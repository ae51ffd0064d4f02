"""The log: a SQLite file in labcal's folder to which entries are added and never anything else.

An entry is JSON text that states the link of the entry before it; its own link is the SHA-256 of that text, and the
lab's key signs CONTEXT with the link. The first entry states the key.
"""

from __future__ import annotations

import getpass
import json
import platform
import sqlite3
from base64 import b64decode, b64encode
from collections.abc import Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import Any, Literal

from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PublicKey

from labcal.audit import lab_key
from labcal.errors import InputError
from labcal.files.home import own_file, own_folder

Row = tuple[int, bytes, bytes]
Deed = Literal[
    "begin", "run", "import", "approve", "sign", "key", "trust", "revoke", "export", "push", "correct", "void",
    "override", "gone",
]  # fmt: skip
FILE = "audit.sqlite"
CONTEXT = b"labcal-audit/1\n"
START = "0" * 64
PATIENCE_S = 5.0
APPLICATION = 0x6C61_6261  # "laba", in the file's header
NEVER = "BEGIN SELECT RAISE(ABORT, 'the audit log is only added to'); END"
MADE = {  # by name: what makes it
    "entry": "CREATE TABLE entry (number INTEGER PRIMARY KEY, text TEXT NOT NULL, signature TEXT NOT NULL)",
    "entry_update": f"CREATE TRIGGER entry_update BEFORE UPDATE ON entry {NEVER}",
    "entry_delete": f"CREATE TRIGGER entry_delete BEFORE DELETE ON entry {NEVER}",
    "entry_next": "CREATE TRIGGER entry_next BEFORE INSERT ON entry "
    f"WHEN NEW.number <> (SELECT coalesce(max(number), 0) + 1 FROM entry) {NEVER}",
}
ROWS = (
    "SELECT number, CAST(text AS BLOB), CAST(signature AS BLOB) FROM entry ORDER BY number"  # whatever bytes they are
)
SET_ASIDE = "`labcal audit` says where; set the file aside and keep it: labcal begins another"


@dataclass(frozen=True, slots=True)
class Entry:
    """What was done: `who` is the person who is named, `login` the user of the machine, `about` what it was done to."""

    number: int
    utc: str
    deed: Deed
    who: str
    login: str
    machine: str
    about: Mapping[str, str]
    before: str


@dataclass(frozen=True, slots=True)
class Audit:
    """The entries that fit, up to the first that does not: `fault` says which and why, "" where all do.

    `head` is the link of the last that fits, `key` the public half of the lab's key.
    """

    entries: tuple[Entry, ...] = ()
    head: str = START
    key: str = ""
    fault: str = ""


def append(home: Path, deed: Deed, who: str, *abouts: Mapping[str, str]) -> None:
    """Add an entry about each to the log in `home`, all or none; the first one makes the log and the lab's key.

    Raises InputError where the log or the key cannot be used: then nothing is added.
    """
    with _opened(home) as log:
        log.execute("BEGIN IMMEDIATE")
        last = log.execute("SELECT number, CAST(text AS BLOB) FROM entry ORDER BY number DESC LIMIT 1").fetchone()
        key = lab_key.kept(home)
        if key is None and last is not None:
            words = f"the lab's key {lab_key.NAME} is gone, that signs the audit log: put it back, or set the log aside"
            raise InputError(words, file=home / FILE)
        key = key or lab_key.made(home)
        number, before = (last[0], link_of(last[1])) if last else (0, START)
        if last is None:
            begun = _entry(1, "begin", who, {"key": lab_key.public_text(key.public_key())}, START)
            number, before = 1, _add(log, begun, key.sign)
        for place, about in enumerate(abouts, number + 1):
            before = _add(log, _entry(place, deed, who, about, before), key.sign)
        log.execute("COMMIT")


def read(home: Path) -> Audit:
    """Look at every entry of the log in `home`, in order; no entries where there is no log yet.

    Raises InputError where the file is no audit log at all.
    """
    path = home / FILE
    fault, rows = _rows(path) if path.is_file() and path.stat().st_size else ("", [])
    entries, head, key = list[Entry](), START, ""
    for row in rows:
        try:
            entry, key = _entry_of(row, len(entries) + 1, head, key)
        except ValueError as error:
            fault = f"entry {len(entries) + 1}: {error}"
            break
        entries.append(entry)
        head = link_of(row[1])
    return Audit(tuple(entries), head, key, fault or _against_the_key(home, key))


def stored(home: Path) -> list[Row]:
    """Number, text and signature of every entry as it lies in `home`, unread. Raises InputError: it is no log."""
    path = home / FILE
    return _rows(path)[1] if path.is_file() and path.stat().st_size else []


def link_of(text: bytes) -> str:
    """What binds the next entry to the one of this text: its SHA-256."""
    return sha256(text).hexdigest()


def _rows(path: Path) -> tuple[str, list[Row]]:
    with _named_faults(path), closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", uri=True)) as log:
        fault = _fault_of_file(log)
        return fault, [] if fault else log.execute(ROWS).fetchall()


def _entry_of(row: Row, number: int, before: str, key: str) -> tuple[Entry, str]:
    """The entry of a row and the key that signs it, which the first one states. Raises ValueError."""
    try:
        entry = Entry(**json.loads(row[1]))
        key = key or entry.about["key"]
        follows = (row[0], entry.number, entry.before) == (number, number, before)
        _check(lab_key.from_public_text(key), link_of(row[1]), row[2])
    except InvalidSignature:
        raise ValueError("it is not as it was written: the lab's key did not sign it") from None
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        raise ValueError("it is not as labcal writes one") from None
    if not follows:
        raise ValueError("it does not follow the one before it, or one is gone")
    return entry, key


def _against_the_key(home: Path, stated: str) -> str:
    """What the lab's key has against a log whose first entry states this one; "" where nothing, or no key is here."""
    if (kept := lab_key.kept(home)) is None:
        return ""
    if not stated:
        return f"there is no entry, though {lab_key.NAME} is there, which was made with the first one"
    same = lab_key.public_text(kept.public_key()) == stated
    return "" if same else f"{lab_key.NAME} is not the key of entry 1"


def _check(key: Ed25519PublicKey, link: str, signature: bytes) -> None:
    key.verify(b64decode(signature, validate=True), CONTEXT + link.encode())


def _entry(number: int, deed: Deed, who: str, about: Mapping[str, str], before: str) -> Entry:
    utc = datetime.now(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")
    login = _login()
    return Entry(number, utc, deed, who or login, login, platform.node(), dict(about), before)


def _add(log: sqlite3.Connection, entry: Entry, sign: Any) -> str:
    """Write the entry, signed; returns its link."""
    text = json.dumps(asdict(entry), separators=(",", ":"))
    link = link_of(text.encode())
    signature = b64encode(sign(CONTEXT + link.encode())).decode()
    log.execute("INSERT INTO entry (number, text, signature) VALUES (?, ?, ?)", (entry.number, text, signature))
    return link


def _login() -> str:
    try:
        return getpass.getuser()
    except (OSError, KeyError, ImportError):  # a user that the system has no name for
        return "unknown"


@contextmanager
def _opened(home: Path) -> Iterator[sqlite3.Connection]:
    """The log, made where it is absent, for this user alone; what is not committed within is not written."""
    path = home / FILE
    with _named_faults(path), _connected(path) as log:
        log.execute("PRAGMA synchronous = FULL")
        if log.execute("PRAGMA application_id").fetchone()[0] != APPLICATION:
            _make(log)
        if fault := _fault_of_file(log):
            raise InputError(f"the audit log takes no entry: {fault}; {SET_ASIDE}", file=path)
        yield log


@contextmanager
def _connected(path: Path) -> Iterator[sqlite3.Connection]:
    own_file(own_folder(path.parent) / path.name)
    with closing(sqlite3.connect(path, timeout=PATIENCE_S, isolation_level=None)) as log:
        yield log


def _make(log: sqlite3.Connection) -> None:
    log.execute("BEGIN IMMEDIATE")  # two programs may begin it at once: one makes it, one waits
    if not log.execute("SELECT count(*) FROM sqlite_master").fetchone()[0]:
        for statement in MADE.values():
            log.execute(statement)
        log.execute(f"PRAGMA application_id = {APPLICATION}")
    log.execute("COMMIT")


def _fault_of_file(log: sqlite3.Connection) -> str:
    """What of table and guards is not as labcal made it; "" where all is."""
    if dict(log.execute("SELECT name, sql FROM sqlite_master")) != MADE:
        return "another program has changed its table or its guards"
    (pages,) = log.execute("PRAGMA quick_check(1)").fetchone()
    return "" if pages == "ok" else f"a page is damaged: {' '.join(pages.split())}"


@contextmanager
def _named_faults(path: Path) -> Iterator[None]:
    try:
        yield
    except (sqlite3.Error, OSError) as error:
        raise InputError(f"the audit log cannot be read or written: {error}", file=path) from None
