"""The hash chain: what was edited, put in or taken out behind the guards is told, whatever value it is."""

from __future__ import annotations

import json
import random
import shutil
import sqlite3
from base64 import b64decode
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest

from labcal.cli import execute
from labcal.errors import InputError
from labcal.record import Dut, Reference, RunHeader, Segment
from labcal.record.stream import Block, Event, Item, Measurement, Prompt, SegmentClosed, SegmentOpened
from labcal.store import Store, check_store, load_bundle, save_bundle
from labcal.store.chain import COLUMNS, KEYS, START
from labcal.store.items import merged, to_row, whole

HEADER = RunHeader("r1", "2026-03-02T08:15:00Z", True, "bench", Dut("SN1"), Reference("vector"))
GOLDEN = Path(__file__).parents[1] / "golden"
Bundles = Callable[..., Path]


def block(stream: str, start: float, n: int = 40) -> Block:
    t, prefix = start + np.arange(n) / 10, {"dut": "dut", "reference": "ref"}[stream]
    values = np.outer(np.sin(t), [1e4, 2e4, -3e4])
    return Block(stream, stream, tuple(f"{prefix}_{a}" for a in "xyz"), t, values, b"frame\n" * n)  # type: ignore[arg-type]


def timeline() -> Iterator[Item]:
    yield SegmentOpened(0.0, Segment("a", "free"))
    for number in range(5):
        yield block("dut", 4.0 * number)
        yield block("reference", 4.0 * number)
        yield Prompt(4.0 * number, "ready", "ready?")
        yield Event(4.0 * number + 1, "answer", "done")
        yield Measurement(4.0 * number + 2, "zero", 3.5, 0.5, "nT", 10.0)
    yield SegmentClosed(20.0)


def record(store: Store, run_id: str = "r1") -> None:
    with store.begin(replace(HEADER, run_id=run_id)) as writer:
        for item in timeline():
            writer.write(item)


@pytest.fixture
def path(bundle: Bundles) -> Path:
    """The user's own store: a recorded run, one that came with its chain, and one that came without."""
    with Store.open() as store:
        record(store)
        with Store.open(store.path.with_name("other.sqlite")) as other:
            record(other, "came")
            save_bundle(other.bundle("came", with_chain=True), store.path.with_name("came.zip"))
        store.add_bundle(store.path.with_name("came.zip"))
        store.add_bundle(bundle(lambda header: header.update(run_id="bare")))
        return store.path


@contextmanager
def behind_the_guards(path: Path) -> Iterator[sqlite3.Connection]:
    """As somebody would who knows SQLite: guards off, edited, guards on."""
    with closing(sqlite3.connect(path, isolation_level=None)) as connection:
        connection.execute("PRAGMA synchronous = OFF")
        connection.execute("BEGIN")
        kept = connection.execute("SELECT name, sql FROM sqlite_master WHERE type = 'trigger'").fetchall()
        for name, _ in kept:
            connection.execute(f"DROP TRIGGER {name}")
        yield connection
        for _, sql in kept:
            connection.execute(sql)
        connection.execute("COMMIT")


def changed(value: object, chance: random.Random) -> object:
    """Another value of the same kind, near or far."""
    if isinstance(value, bytes):
        place, bit = chance.randrange(len(value)), 1 << chance.randrange(8)
        return value[:place] + bytes([value[place] ^ bit]) + value[place + 1 :]
    if isinstance(value, str):
        place = chance.randrange(len(value))
        return value[:place] + chance.choice("x0 é") + value[place + chance.randrange(2) :] + chance.choice(["", "1"])
    assert isinstance(value, int | float)
    return value + chance.choice([1, -1, 1000, 1e-6] if isinstance(value, float) else [1, -1, 1000])


def values(connection: sqlite3.Connection) -> list[tuple[str, str, int, str]]:
    """Every value of the store that is there: table, the condition on its key, number, column."""
    found = []
    of_chain = ("run", "place", "kept_in", "row", "sha256")
    for table, key in {**KEYS, "chain": "run * 1000000 + place"}.items():
        columns = COLUMNS.get(table, of_chain)
        for column in (*columns, *(("number",) if table in ("run", "item") else ())):
            there = connection.execute(f"SELECT {key} FROM {table} WHERE {column} IS NOT NULL AND {column} <> x''")
            found += [(table, key, row, column) for (row,) in there]
    return found


@pytest.mark.parametrize("edits", [60, pytest.param(2000, marks=pytest.mark.slow)])
def test_a_random_edit_of_any_value_is_told(path: Path, tmp_path: Path, edits: int) -> None:
    assert check_store(path).fault == ""
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        there = values(connection)
    chance, missed = random.Random(17), []
    for _ in range(edits):
        spoilt = Path(shutil.copy(path, tmp_path / "spoilt.sqlite"))
        table, key, row, column = chance.choice(there)
        with behind_the_guards(spoilt) as connection:
            (old,) = connection.execute(f"SELECT {column} FROM {table} WHERE {key} = ?", (row,)).fetchone()
            while (new := changed(old, chance)) == old:
                pass
            try:
                connection.execute(f"UPDATE {table} SET {column} = ? WHERE {key} = ?", (new, row))
            except sqlite3.IntegrityError:  # it would be another row's key
                connection.execute(f"UPDATE {table} SET {column} = -7 WHERE {key} = ?", (row,))
        if check_store(spoilt).fault == "":
            missed.append((table, column, row, old, new))
        for end in ("-wal", "-shm"):
            spoilt.with_name(spoilt.name + end).unlink(missing_ok=True)
    assert missed == []


@pytest.mark.parametrize(
    ("statement", "says"),
    [
        ("UPDATE item SET content = replace(content, '3.5', '2.5') WHERE number = 6", "row 6 (measurement)"),
        ("UPDATE status SET utc = '2026-03-02T08:15:01Z' WHERE rowid = 1", "row 1 of status"),
        ("DELETE FROM item WHERE number = 4", "row 4 of item is gone"),
        ("DELETE FROM chain WHERE run = 1 AND place = 5", "link 5 of its chain is gone"),
        ("DELETE FROM chain WHERE run = 1", "its chain is gone"),
        ("DELETE FROM chain WHERE run = 2", "run came: its chain is gone"),
        ("INSERT INTO item (run, kind, t_s, content) SELECT 1, kind, t_s, content FROM item WHERE number = 6", "binds"),
        ("UPDATE run SET header = replace(header, '\"bench\"', '\"other\"') WHERE number = 1", "its head"),
    ],
)  # fmt: skip
def test_the_first_row_that_does_not_fit_is_named_and_nothing_is_made_of_the_run(
    path: Path, statement: str, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with behind_the_guards(path) as connection:
        assert connection.execute(statement).rowcount
    assert says in check_store(path).fault
    assert execute(["check-store"]) == 1
    run = "came" if "came" in says else "r1"
    for command in (["show", run], ["fit", run], ["export", run, "--format", "bundle", "--out", "x.zip"]):
        capsys.readouterr()
        assert execute(command) == 2
        assert f"run {run} does not fit its hash chain" in capsys.readouterr().err


def test_a_stranger_can_work_the_head_out_again_from_the_bundle(path: Path) -> None:
    with Store.open() as store:
        bundle = store.bundle("r1", with_chain=True)
    before = START
    for line in bundle.chain.splitlines():
        told = json.loads(line)
        text = f"{before}\n{told['of']}\n"
        for name in COLUMNS[told["of"]]:
            value = told.get(name)
            if name in ("stamps", "samples", "raw") and value is not None:
                text += f"bytes {sha256(b64decode(value)).hexdigest()}\n"
            elif isinstance(value, str):
                text += f"text {sha256(value.encode()).hexdigest()}\n"
            else:
                text += "-\n" if value is None else f"real {value}\n"
        before = sha256(text.encode()).hexdigest()
        assert before == told["sha256"]
    assert bundle.origin is not None
    assert before == bundle.origin.head


def test_a_bundle_whose_rows_are_not_those_recorded_is_refused(path: Path, tmp_path: Path) -> None:
    with Store.open() as store:
        save_bundle(store.bundle("r1", with_chain=True), tmp_path / "b")
    lines = (tmp_path / "b" / "chain.jsonl").read_bytes()
    samples = (tmp_path / "b" / "samples.csv").read_text()
    assert load_bundle(tmp_path / "b").origin is not None
    first, row, *rest = samples.splitlines(keepends=True)
    cells = row.split(",")
    cells[2] = "17.5"
    (tmp_path / "b" / "samples.csv").write_text("".join([first, ",".join(cells), *rest]))
    with pytest.raises(InputError, match=r"samples\.csv is not what its rows make: reading"):
        load_bundle(tmp_path / "b")
    (tmp_path / "b" / "samples.csv").write_text(samples)
    for spoilt, says in (
        (lines.replace(b"3.5", b"2.5", 1), "line "),
        (lines[: len(lines) // 2], "chain.jsonl"),
        (b"".join(lines.splitlines(keepends=True)[:-1]), "cut off: it does not say how its run ended"),
        (b"{}\n" + lines, "line 1"),
        (b"\xff\n", "line 1"),
        (b"[" * 100_000 + b"\n", "line 1"),
    ):
        (tmp_path / "b" / "chain.jsonl").write_bytes(spoilt)
        assert spoilt != lines
        with pytest.raises(InputError, match=says):
            load_bundle(tmp_path / "b")


def test_a_run_that_has_not_ended_hands_out_no_chain(tmp_path: Path) -> None:
    with Store.open() as store:
        writer = store.begin(HEADER)
        for item in timeline():
            writer.write(item)
        writer.finish("interrupted")
        assert store.bundle("r1", with_chain=True).chain == b""
        with store.resume("r1"):
            pass
        assert store.bundle("r1", with_chain=True).chain


def test_a_run_that_came_without_a_chain_shows_no_origin(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with Store.open() as store:
        assert store.bundle("bare").origin is None
        assert store.bundle("came").origin is not None
    execute(["show", "bare"])
    assert "not shown" in capsys.readouterr().out


@pytest.mark.parametrize("version", [1, 2])
def test_a_store_of_before_is_read_and_shows_no_origin(tmp_path: Path, version: int) -> None:
    old = Path(shutil.copy(GOLDEN / f"store-{version}.sqlite", tmp_path / "old.sqlite"))
    assert check_store(old).fault == ""
    with Store.open(old) as store:
        assert {store.chain_of(run.run_id) for run in store.runs()} == {None}
        record(store, "new")
        assert store.chain_of("new") is not None
    assert check_store(old).fault == ""


def test_a_run_that_is_gone_on_with_goes_on_in_its_chain() -> None:
    with Store.open() as store:
        writer = store.begin(HEADER)
        writer.write(Event(1.0, "note", "before"))
        writer.finish("interrupted")
        first = store.chain_of("r1")
        with store.resume("r1") as again:
            again.write(Event(2.0, "note", "after"))
        last = store.chain_of("r1")
        assert first is not None
        assert last is not None
        assert last.rows == first.rows + 3
        for once in (first, last):
            assert store.has_head("r1", once.stated())
            assert not store.has_head("r1", {"head": START, "rows": once.rows})
            assert not store.has_head("r1", {"head": once.head, "rows": once.rows - 1})


def test_blocks_are_merged_alike_however_the_rows_are_handed_on() -> None:
    rows = [to_row(item) for item in timeline()]
    rows += [to_row(block("dut", start, 10)) for start in range(20, 60)]
    at_once, kept, pending = list(merged(rows)), [], []
    for row in rows:
        pending.append(row)
        ready = whole(pending)
        kept += merged(pending[:ready])
        del pending[:ready]
    assert kept + list(merged(pending)) == at_once
