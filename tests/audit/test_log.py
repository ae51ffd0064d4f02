"""The audit log: what was done is in it, and whatever is done to it afterwards is told."""

from __future__ import annotations

import json
import os
import sqlite3
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing, contextmanager
from dataclasses import replace
from pathlib import Path

import pytest

from labcal import audit, session
from labcal.audit.lab_key import NAME as KEY
from labcal.audit.log import FILE
from labcal.cli import execute
from labcal.errors import InputError
from labcal.files.home import home
from labcal.runner import Outcome
from labcal.session.audited import note_run
from labcal.store import Store, chain, write_bundle
from labcal.testing.made_up_runs import made_up_run

SIMULATED = Path(__file__).parents[2] / "examples" / "simulated.toml"
DEEDS = ("run", "approve", "sign", "export", "revoke")


@pytest.fixture
def log() -> Path:
    """A log of one entry of each of DEEDS, behind the one that begins it."""
    for deed in DEEDS:
        audit.append(home(), deed, "Ada", {"file": f"{deed}.json"})
    return home() / FILE


@contextmanager
def behind_the_guards(path: Path) -> Iterator[sqlite3.Connection]:
    with closing(sqlite3.connect(path, isolation_level=None)) as connection:
        kept = connection.execute("SELECT name, sql FROM sqlite_master WHERE type = 'trigger'").fetchall()
        for name, _ in kept:
            connection.execute(f"DROP TRIGGER {name}")
        yield connection
        for _, sql in kept:
            connection.execute(sql)


def test_the_log_says_who_did_what_when_and_where(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert execute(["audit", "--json", "-"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["format"], told["fits"], told["fault"]) == ("labcal-audit/1", True, "")
    assert [entry["deed"] for entry in told["entries"]] == ["begin", *DEEDS]
    assert told["entries"][1].keys() == {"number", "utc", "deed", "who", "login", "machine", "about", "before"}
    assert told["entries"][1]["who"] == "Ada"
    assert told["key"].startswith("ssh-ed25519 ")
    assert execute(["audit"]) == 0
    assert f"sound: 6 entries, head {told['head']}" in capsys.readouterr().out
    if os.name == "posix":
        assert {oct((home() / name).stat().st_mode & 0o777) for name in (FILE, KEY)} == {"0o600"}


def test_rows_are_never_edited_nor_put_between(log: Path) -> None:
    with closing(sqlite3.connect(log)) as connection:
        for statement in (
            "UPDATE entry SET text = text",
            "DELETE FROM entry",
            "INSERT OR REPLACE INTO entry SELECT 3, text, signature FROM entry WHERE number = 2",
        ):
            with pytest.raises(sqlite3.DatabaseError, match="only added to"):
                connection.execute(statement)


@pytest.mark.parametrize(
    ("statement", "says"),
    [
        (
            "UPDATE entry SET text = replace(text, 'Ada', 'Eve') WHERE number = 4",
            "entry 4: it is not as it was written",
        ),
        ("UPDATE entry SET text = x'ff00' WHERE number = 4", "entry 4: it is not as labcal writes one"),
        ("UPDATE entry SET signature = 'AAAA' WHERE number = 5", "entry 5: it is not as it was written"),
        (
            "UPDATE entry SET signature = (SELECT e.signature FROM entry e WHERE e.number = 2) WHERE number = 3",
            "entry 3",
        ),
        ("DELETE FROM entry WHERE number = 3", "entry 3: it does not follow"),
        ("DELETE FROM entry WHERE number = 1", "entry 1: "),
        ("UPDATE entry SET number = -number WHERE number IN (3, 4)", "entry 1: "),
        ("CREATE TABLE other (a)", "another program has changed its table"),
    ],
)
def test_the_first_entry_that_does_not_fit_is_named(
    log: Path, statement: str, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with behind_the_guards(log) as connection:
        connection.execute(statement)
    assert execute(["audit"]) == 1
    assert f"NOT SOUND: {says}" in capsys.readouterr().out


def test_a_log_by_another_key_is_told(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    key = (home() / KEY).read_bytes()
    log.unlink()
    (home() / KEY).unlink()
    audit.append(home(), "run", "Eve", {"run": "never"})
    (home() / KEY).write_bytes(key)
    assert execute(["audit"]) == 1
    assert "lab-key.pem is not the key of entry 1" in capsys.readouterr().out


@pytest.mark.parametrize("empty", [False, True])
def test_a_log_that_is_gone_is_told_by_its_key(log: Path, empty: bool, capsys: pytest.CaptureFixture[str]) -> None:
    log.unlink()
    if empty:
        log.touch()
    assert execute(["audit"]) == 1
    assert "there is no entry, though lab-key.pem is there" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        (lambda key: key.unlink(), "lab-key.pem is gone"),
        (lambda key: key.write_bytes(b"-----BEGIN"), "is not the lab's key"),
        (lambda key: key.chmod(0o644), "others may read the lab's key"),
    ],
)
def test_without_its_key_nothing_is_added(log: Path, spoil: Callable[[Path], object], says: str) -> None:
    if os.name != "posix" and "others" in says:
        pytest.skip("modes are of POSIX")
    spoil(home() / KEY)
    with pytest.raises(InputError, match=says):
        audit.append(home(), "run", "Ada", {})
    with closing(sqlite3.connect(log)) as connection:
        assert connection.execute("SELECT count(*) FROM entry").fetchone() == (6,)


def test_who_adds_at_once_adds_one_after_the_other() -> None:
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda n: audit.append(home(), "run", "Ada", {"run": str(n)}), range(24)))
    found = audit.read(home())
    assert found.fault == ""
    assert {entry.about.get("run") for entry in found.entries[1:]} == {str(n) for n in range(24)}


def test_what_a_lab_does_is_in_its_log(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("LABCAL_PASSPHRASE", "correct horse battery")
    assert execute(["audit"]) == 0
    assert "no entries yet" in capsys.readouterr().out
    assert execute(["keys", "new", "--name", "ada@lab"]) == 0
    run = tmp_path / "run"
    write_bundle(made_up_run(rows=20).run, run)
    assert execute(["export", str(run), "--format", "bundle", "--out", str(tmp_path / "out.zip")]) == 0
    assert execute(["keys", "revoke", "ada@lab"]) == 0
    done = [(entry.deed, dict(entry.about)) for entry in audit.read(home()).entries[1:]]
    assert [deed for deed, _ in done] == ["key", "export", "revoke"]
    assert done[0][1]["person"] == "ada@lab"
    assert done[1][1]["file"] == "out.zip"


def test_a_run_is_in_the_log_with_the_head_of_its_chain(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = session.run("ambient", SIMULATED, {"duration_s": "10"}, operator="Ada")
    with Store.open() as store:
        chain = store.chain_of(outcome.run_id)
    entry = audit.read(home()).entries[-1]
    assert chain is not None
    assert (entry.deed, entry.who) == ("run", "Ada")
    named = {"run": outcome.run_id, "status": "finished", "chain": chain.head}
    assert entry.about == named | {"first": outcome.run_id}
    assert execute(["check-store"]) == 0
    assert "parsed again" in capsys.readouterr().out  # what the instruments sent says what was kept


def chained_anew(run: int) -> None:
    """As who owns the disk can: rows of `run` rewritten, and every link after them worked out again."""
    with behind_the_guards(home() / "store.sqlite") as store:
        store.execute("UPDATE item SET content = content || ' ' WHERE run = ?", (run,))
        before = chain.START
        for place, (table, row, _) in enumerate(chain.parts(store, run), 1):
            before = chain.link(before, table, chain.values_of(store, run, table, row) or ())
            store.execute("UPDATE chain SET sha256 = ? WHERE run = ? AND place = ?", (before, run, place))


def test_a_run_that_was_chained_anew_or_taken_out_is_told_by_the_log(capsys: pytest.CaptureFixture[str]) -> None:
    first, second, third = (
        session.run("ambient", SIMULATED, {"duration_s": "10"}, operator="Ada").run_id for _ in range(3)
    )
    assert execute(["check-store"]) == 0
    chained_anew(2)
    capsys.readouterr()
    assert execute(["check-store"]) == 1
    said = capsys.readouterr().out
    assert said.startswith(f"NOT SOUND: run {second}: its chain is another than the one whose head the audit log")
    assert execute(["check-store", first]) == 0
    assert execute(["check-store", second]) == 1
    with behind_the_guards(home() / "store.sqlite") as store:
        for table, key in (("chain", "run"), ("status", "run"), ("item", "run"), ("run", "number")):
            store.execute(f"DELETE FROM {table} WHERE {key} = 2")
    capsys.readouterr()
    assert execute(["check-store"]) == 1
    assert f"run {second} is gone" in capsys.readouterr().out
    assert execute(["check-store", third]) == 0
    (home() / FILE).unlink()
    assert execute(["check-store"]) == 1  # by the gap in the numbers


def taken_out(run: int) -> None:
    """As who owns the disk can: every row of a run, those behind it as if it never had been."""
    with behind_the_guards(home() / "store.sqlite") as store:
        store.execute("PRAGMA foreign_keys = OFF")
        for table in ("bundle", "origin", "chain", "status", "item", "run"):
            key = "number" if table == "run" else "run"
            store.execute(f"DELETE FROM {table} WHERE {key} = ?", (run,))
            store.execute(f"UPDATE {table} SET {key} = {key} - 1 WHERE {key} > ?", (run,))
        store.execute("UPDATE chain SET row = run WHERE kept_in IN ('run', 'bundle', 'origin')")


@pytest.mark.parametrize("runs", [1, 2, 3])
def test_whichever_run_is_taken_out_the_log_names_it(runs: int, tmp_path: Path) -> None:
    """The first, one between others, the last, the only one; recorded or taken in."""
    there = [imported(tmp_path / str(number), number) for number in range(runs)]
    whole = (home() / "store.sqlite").read_bytes()
    assert session.check_store().fault == ""
    for number, run_id in enumerate(there, 1):
        taken_out(number)
        assert session.check_store().fault.startswith(f"run {run_id} is gone")
        (home() / "store.sqlite").write_bytes(whole)
    assert session.check_store().fault == ""


def imported(folder: Path, number: int) -> str:
    run = replace(made_up_run(rows=20).run, run_id=f"r{number}")
    write_bundle(run, folder)
    return session.import_bundle(folder)


def test_a_store_that_was_begun_anew_misses_nothing(tmp_path: Path) -> None:
    imported(tmp_path / "0", 0)
    (home() / "store.sqlite").unlink()
    imported(tmp_path / "1", 1)
    assert session.check_store().fault == ""


def test_a_run_that_is_taken_into_the_next_store_too_is_no_sign_of_the_one_before(tmp_path: Path) -> None:
    for number in range(3):
        imported(tmp_path / str(number), number)
    (home() / "store.sqlite").unlink()
    for _ in range(2):
        session.import_bundle(tmp_path / "0")
    assert session.check_store().fault == ""
    assert [entry.about["run"] for entry in session.read_audit().entries[1:]] == ["r0", "r1", "r2", "r0"]


def test_a_gap_in_the_numbers_is_told_where_there_is_no_log(tmp_path: Path) -> None:
    for number in range(3):
        imported(tmp_path / str(number), number)
    (home() / FILE).unlink()
    with behind_the_guards(home() / "store.sqlite") as store:
        for table, key in (("bundle", "run"), ("chain", "run"), ("status", "run"), ("run", "number")):
            store.execute(f"DELETE FROM {table} WHERE {key} = 1")
    assert session.check_store().fault == "run r1 is the store's number 2, and number 1 is gone"


def test_a_run_that_the_log_does_not_take_says_so_and_is_kept() -> None:
    (home() / FILE).mkdir()
    with Store.open() as store:
        told = note_run(Outcome("r1", "finished", None, ending="finished"), store, "Ada").ending
    assert told.startswith(f"finished; {home() / FILE}: done (run), but not in the audit log")
