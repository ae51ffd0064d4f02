"""The register of certificate numbers, LAB-BENCH-YEAR-NNNN: without a gap for each bench and year, none used twice.

A SQLite file in labcal's folder to which numbers are added and from which none goes: one that was not used stays,
void, with its reason. Taking a number is one transaction, so that two who take at once get two numbers.
"""

from __future__ import annotations

import re
import sqlite3
import unicodedata
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from labcal.errors import InputError
from labcal.files.home import own_file, own_folder

State = Literal["taken", "signed", "void"]
FILE = "certificates.sqlite"
LONGEST = 16  # of the bench's part
PATIENCE_S = 15.0
NEVER = "BEGIN SELECT RAISE(ABORT, 'a certificate number stays in the register'); END"
MADE = (
    "CREATE TABLE IF NOT EXISTS certificate (series TEXT NOT NULL, year INTEGER NOT NULL, running INTEGER NOT NULL, "
    "utc TEXT NOT NULL, run_id TEXT NOT NULL, file TEXT NOT NULL, state TEXT NOT NULL, reason TEXT NOT NULL, "
    "sha256 TEXT NOT NULL, PRIMARY KEY (series, year, running))",
    f"CREATE TRIGGER IF NOT EXISTS certificate_delete BEFORE DELETE ON certificate {NEVER}",
    "CREATE TRIGGER IF NOT EXISTS certificate_next BEFORE INSERT ON certificate WHEN NEW.running <> (SELECT "
    f"coalesce(max(running), 0) + 1 FROM certificate WHERE series = NEW.series AND year = NEW.year) {NEVER}",
)
NUMBER = re.compile(r"([A-Z0-9]+-[A-Z0-9]+)-(\d{4})-(\d{4,9})", re.ASCII)
COLUMNS = "series, year, running, utc, run_id, file, state, reason, sha256"


@dataclass(frozen=True, slots=True)
class NumberEntry:
    """One number: when it was taken, for which run and file; `taken` is a draft's, `reason` says why it is void."""

    number: str
    utc: str
    run_id: str
    file: str
    state: State
    reason: str
    sha256: str  # of the file that was signed first with it


def take(home: Path, laboratory: str, bench: str, run_id: str, file: str, utc: str) -> str:
    """The next number of `bench` in the year of `utc` (ISO 8601), which is taken with it. Raises InputError."""
    series, year = f"{laboratory}-{part_of(bench)}", int(utc[:4])
    with _opened(home) as register:
        found = register.execute(
            "SELECT coalesce(max(running), 0) + 1 FROM certificate WHERE series = ? AND year = ?", (series, year)
        ).fetchone()
        row = (series, year, found[0], utc, run_id, file, "taken", "", "")
        register.execute(f"INSERT INTO certificate ({COLUMNS}) VALUES (?,?,?,?,?,?,?,?,?)", row)
    return _number(series, year, found[0])


def void(home: Path, number: str, reason: str) -> None:
    """Keep `number` as void. Raises InputError without a reason, for one that is unknown, signed or void."""
    if not (said := " ".join(reason.split())):
        raise InputError(f"{number}: a void number keeps its reason, and none was said")
    with _opened(home) as register:
        found = _require(register, number, home)
        if found.state != "taken":
            text = ": withdraw the file by another that supersedes it" if found.state == "signed" else " already"
            raise InputError(f"{number} is {found.state}{text}")
        _change(register, number, ("void", said, ""))


def check(home: Path, number: str, run_id: str, sha256: str = "") -> None:
    """Raise InputError where `number` is not that of a draft of this run: another's, void, or signed with other bytes.

    One of a bench that this register knows nothing of was taken on another computer: nothing is said against it.
    """
    with _opened(home) as register:
        _check(register, number, run_id, sha256)


def signed(home: Path, number: str, run_id: str, sha256: str) -> None:
    """Keep that the file of this SHA-256 was signed with `number`. Raises InputError as `check` does."""
    with _opened(home) as register:
        if (found := _check(register, number, run_id, sha256)) and found.state == "taken":
            _change(register, number, ("signed", "", sha256))


def listed(home: Path) -> tuple[NumberEntry, ...]:
    """Every number in the order of bench, year and number; none where there is no register yet."""
    if not (home / FILE).exists():
        return ()
    with _opened(home) as register:
        rows = register.execute(f"SELECT {COLUMNS} FROM certificate ORDER BY series, year, running").fetchall()
    return tuple(map(_numbered, rows))


def part_of(bench: str) -> str:
    """The bench's part of a number: capital letters and digits of its name."""
    plain = unicodedata.normalize("NFKD", bench).upper()
    return "".join(re.findall("[A-Z0-9]", plain))[:LONGEST] or "OTHER"


def _check(register: sqlite3.Connection, number: str, run_id: str, sha256: str) -> NumberEntry | None:
    found = _find(register, number)
    if found is None:
        if not NUMBER.fullmatch(number):
            raise InputError(f"number: {number[:40]!r} is no LAB-BENCH-YEAR-NNNN; make the draft again")
        series = number.rsplit("-", 2)[0]
        if register.execute("SELECT 1 FROM certificate WHERE series = ? LIMIT 1", (series,)).fetchone():
            raise InputError(f"number: {number} was never given out; make the draft again")
        return None
    if found.run_id != run_id:
        raise InputError(f"number: {number} was given to the calibration of run {found.run_id}; make the draft again")
    if found.state == "void":
        raise InputError(f"number: {number} is void ({found.reason}); make the draft again")
    if sha256 and found.sha256 not in ("", sha256):
        raise InputError(f"number: another file has been signed as {number}; make the draft again")
    return found


def _require(register: sqlite3.Connection, number: str, home: Path) -> NumberEntry:
    if (found := _find(register, number)) is None:
        raise InputError(f"{number} is no number of this register (`labcal numbers` shows them)", file=home / FILE)
    return found


def _find(register: sqlite3.Connection, number: str) -> NumberEntry | None:
    if (match := NUMBER.fullmatch(number)) is None:
        return None
    where = (match[1], int(match[2]), int(match[3]))
    asked = f"SELECT {COLUMNS} FROM certificate WHERE series = ? AND year = ? AND running = ?"
    row = register.execute(asked, where).fetchone()
    return None if row is None else _numbered(row)


def _change(register: sqlite3.Connection, number: str, to: tuple[str, str, str]) -> None:
    series, year, running = number.rsplit("-", 2)
    where = (series, int(year), int(running))
    change = "UPDATE certificate SET state = ?, reason = ?, sha256 = ? WHERE series = ? AND year = ? AND running = ?"
    register.execute(change, (*to, *where))


def _numbered(row: tuple[str, int, int, str, str, str, State, str, str]) -> NumberEntry:
    return NumberEntry(_number(*row[:3]), *row[3:])


def _number(series: str, year: int, running: int) -> str:
    return f"{series}-{year}-{running:04d}"


@contextmanager
def _opened(home: Path) -> Iterator[sqlite3.Connection]:
    """The register within one transaction that nobody else writes in. Raises InputError where it cannot be used."""
    path = home / FILE
    try:
        own_file(own_folder(home) / FILE)
        with closing(sqlite3.connect(path, timeout=PATIENCE_S, isolation_level=None)) as register:
            register.execute("PRAGMA synchronous = FULL")
            register.execute("BEGIN IMMEDIATE")
            for made in MADE:
                register.execute(made)
            yield register
            register.execute("COMMIT")
    except (sqlite3.Error, OSError) as fault:
        raise InputError(f"the register of certificate numbers cannot be used: {fault}", file=path) from None
