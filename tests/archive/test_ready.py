"""A run is made ready when it has ended: the push copies what was made, and never what is no longer true or whole."""

from __future__ import annotations

import sqlite3
import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pytest
from conftest import in_archive, rows_of
from made_lab import stored_runs
from postgres import Server

from labcal import session
from labcal.archive import make_ready, ready
from labcal.archive.run_to_push import RunToPush, of_store
from labcal.errors import InputError
from labcal.files.home import home
from labcal.runner import Outcome
from labcal.session import archiving
from labcal.session.made_ready import begin_to_make_ready
from labcal.store import Store
from labcal.store.listing import FILE as STORE

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
SAMPLES, WITHIN_S = 300, 60.0


def kept(*run_ids: str) -> list[Path]:
    """Make these runs ready, as the process does that a run starts at its end; the files."""
    ready.want()
    for run_id in run_ids:
        ready.keep(of_store(run_id))
    return files()


def made_before(run_id: str) -> RunToPush | None:
    """What a push takes of a run that was made ready."""
    with closing(Store.read_only(home() / STORE)) as store:
        return ready.kept(run_id, store.head_of(run_id))


def files() -> list[Path]:
    return sorted(ready.folder().iterdir()) if ready.folder().is_dir() else []


def edited_behind_the_guards() -> None:
    with closing(sqlite3.connect(home() / "store.sqlite")) as store:
        [guard] = store.execute("SELECT sql FROM sqlite_master WHERE name = 'item_update'").fetchone()
        store.execute("DROP TRIGGER item_update")
        store.execute("UPDATE item SET raw = zeroblob(length(raw)) WHERE raw IS NOT NULL AND length(raw) > 0")
        store.execute(guard)
        store.commit()


def test_the_same_is_pushed_byte_for_byte_and_nothing_is_made_then(
    postgres: Server, database: str, url: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stored_runs(range(3), SAMPLES)
    other = postgres.url(again := postgres.database())
    archiving.init_archive(other, None)
    assert archiving.push(f"{other}&bundles={tmp_path / 'again'}&site=aalto").runs == 3
    assert len(kept("size-0", "size-1", "size-2")) == 3
    monkeypatch.setattr("labcal.session.pushing.of_store_into", lambda *_: pytest.fail("was made by the push"))
    assert (archiving.push(url).runs, files()) == (3, [])
    as_made_then = in_archive(postgres, again, tmp_path / "again")
    assert in_archive(postgres, database, tmp_path / "bundles") == as_made_then
    assert len(as_made_then.bundles) == 3
    assert archiving.check_archive(url, None) == []


def lost(path: Path) -> None:
    path.unlink()


def cut_off(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:-1])


def emptied(path: Path) -> None:
    path.write_bytes(b"")


def edited(path: Path) -> None:
    content = bytearray(path.read_bytes())
    content[-500] ^= 1
    path.write_bytes(content)


def of_another_operator(path: Path) -> None:
    path.write_bytes(path.read_bytes().replace(b'"ada"', b'"eve"'))


@pytest.mark.parametrize("spoil", [lost, cut_off, emptied, edited, of_another_operator])
def test_a_file_that_is_not_as_it_was_written_is_made_anew(
    spoil: Callable[[Path], None], postgres: Server, database: str, url: str, tmp_path: Path
) -> None:
    stored_runs([0], SAMPLES)
    true = of_store("size-0")
    assert made_before("size-0") is None
    [path] = kept("size-0")
    assert made_before("size-0") == true
    spoil(path)
    assert made_before("size-0") is None
    assert (archiving.push(url).runs, files()) == (1, [])
    found = in_archive(postgres, database, tmp_path / "bundles")
    assert ([row[9] for row in found.runs], list(found.bundles.values())) == (["ada"], [true.zipped])


def test_a_record_that_has_gone_on_since_is_made_anew(postgres: Server, database: str, url: str) -> None:
    stored_runs([0], SAMPLES)
    before = kept("size-0")
    with Store.open() as store:
        store.correct_serial("size-0", "S-right", "ada")
    assert made_before("size-0") is None
    assert kept("size-0") != before
    assert (archiving.push(url).runs, files()) == (1, [])
    assert [row[6] for row in rows_of(postgres, database)["run"]] == ["S-right"]


@pytest.mark.parametrize(
    ("which", "other"),
    [
        ("labcal.archive.ready.__version__", "99.0"),
        ("labcal.archive.ready.sources", lambda: "another day"),
        ("numpy.__version__", "99.0"),
    ],
)
def test_what_another_program_made_is_made_anew(
    which: str, other: object, url: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    stored_runs([0], SAMPLES)
    kept("size-0")
    monkeypatch.setattr(which, other)
    assert made_before("size-0") is None
    assert (archiving.push(url).runs, files()) == (1, [])


def test_what_is_of_another_run_is_not_taken(url: str) -> None:
    stored_runs(range(2), SAMPLES)
    [first] = kept("size-0")
    [second] = {*kept("size-1")} - {first}
    second.write_bytes(first.read_bytes())
    assert made_before("size-1") is None
    assert archiving.push(url).runs == 2
    assert archiving.check_archive(url, None) == []


def test_a_record_that_was_edited_before_is_refused_and_one_edited_since_is_pushed_as_it_was(
    postgres: Server, database: str, url: str, tmp_path: Path
) -> None:
    stored_runs(range(2), SAMPLES)
    true = of_store("size-0")
    kept("size-0")
    edited_behind_the_guards()
    with pytest.raises(InputError, match="does not fit its hash chain"):
        of_store("size-0")
    pushed = archiving.push(url)
    assert pushed.runs == 1
    assert ["run size-1 does not fit its hash chain" in said for said in pushed.refused] == [True]
    there = in_archive(postgres, database, tmp_path / "bundles")
    assert (list(there.bundles.values()), files()) == ([true.zipped], [])


def test_a_half_is_never_taken_and_goes_when_nobody_can_be_writing_it(
    url: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    stored_runs([0], SAMPLES)
    [path] = kept("size-0")
    half = path.with_name(f".{path.name}.x7.part")
    half.write_bytes(path.read_bytes()[:1000])
    assert archiving.push(url).runs == 1
    assert files() == [half]
    monkeypatch.setattr("labcal.archive.ready.HALVES_S", -1.0)
    archiving.push(url)
    assert files() == []


def test_without_a_place_for_them_all_goes_on_as_before(url: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """As in a folder that may only be read, which nobody keeps root from writing to."""
    monkeypatch.setattr("labcal.archive.make_ready.stand_back", lambda: None)  # all tests after it would come last
    stored_runs(range(2), SAMPLES)
    ready.folder().write_text("")
    make_ready.main("size-0")
    assert made_before("size-0") is None
    assert archiving.push(url).runs == 2
    assert ready.folder().read_text() == ""


@pytest.mark.parametrize(("limit", "value"), [("LEAST_FREE", 2**62), ("LARGEST", 0)])
def test_disk_and_memory_are_left_to_runs(limit: str, value: int, monkeypatch: pytest.MonkeyPatch) -> None:
    stored_runs(range(2), SAMPLES)
    monkeypatch.setattr("labcal.archive.make_ready.stand_back", lambda: None)
    ready.want()
    make_ready.main("size-0")
    assert len(files()) == 1
    monkeypatch.setattr(f"labcal.archive.make_ready.{limit}", value)
    make_ready.main("size-1")
    assert len(files()) == 1


def test_who_has_pushed_before_has_a_run_made_ready_once_it_has_ended(url: str) -> None:
    """By a process of its own, which has no part in what the run says."""
    first = session.run("ambient", EXAMPLE, {"duration_s": "10"}, seed=1)
    assert not ready.folder().exists()
    assert archiving.push(url).runs == 1
    ended = session.run("ambient", EXAMPLE, {"duration_s": "10"}, seed=1)
    assert (first.status, ended.status) == ("finished", "finished")
    until = time.monotonic() + WITHIN_S
    while not any(path.suffix == ready.ENDING for path in files()):
        assert time.monotonic() < until
        time.sleep(0.02)
    assert made_before(ended.run_id) == of_store(ended.run_id)


@pytest.mark.parametrize(
    ("status", "pushed"), [("stopped", True), ("failed: disk full", True), ("interrupted", True), ("finished", False)]
)
def test_nothing_is_begun_for_what_no_push_will_take(
    status: str, pushed: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if pushed:
        ready.want()
    monkeypatch.setattr("labcal.session.made_ready.subprocess", None)
    begin_to_make_ready(Outcome("size-0", status, None))


@pytest.mark.parametrize("made_ready", [False, True], ids=["as they lie", "made ready"])
def test_a_push_that_is_stopped_has_noted_what_is_in_the_archive(
    made_ready: bool, postgres: Server, database: str, url: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    stored_runs(range(5), SAMPLES)
    if made_ready:  # all five go there by one commit
        kept(*(f"size-{number}" for number in range(5)))
    monkeypatch.setattr("labcal.session.pushing.NOTED_EVERY_S", 1e9)
    came = list[str]()

    def stop_at_three(remark: str) -> None:
        came.append(remark)
        if len(came) == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        archiving.push(url, on_remark=stop_at_three)
    there = [row[2] for row in rows_of(postgres, database)["run"]]
    noted = [entry.about["run"] for entry in session.read_audit().entries if entry.deed == "push"]
    assert sorted(noted) == sorted(there)
    assert len(noted) == (5 if made_ready else 3)


def test_one_whose_rows_the_server_refuses_keeps_none_of_those_back_that_go_with_it(
    postgres: Server, database: str, url: str
) -> None:
    stored_runs(range(4), SAMPLES)
    ready.want()
    for number in range(4):
        one = of_store(f"size-{number}")
        ready.keep(replace(one, row=one.row | {"n_samples": 2**70}) if number == 1 else one)
    found = archiving.push(url)
    assert (found.runs, len(found.refused)) == (3, 1)
    assert "the archive refused it" in found.refused[0]
    assert sorted(row[2] for row in rows_of(postgres, database)["run"]) == ["size-0", "size-2", "size-3"]


def test_a_place_that_takes_no_bundle_refuses_each_run_once_and_keeps_what_was_made(
    postgres: Server, database: str, url: str, tmp_path: Path
) -> None:
    stored_runs(range(2), SAMPLES)
    there = kept("size-0", "size-1")
    (tmp_path / "bundles").write_text("")
    found = archiving.push(url)
    assert ["bundles cannot be kept" in said for said in found.refused] == [True, True]
    assert rows_of(postgres, database)["run"] == []
    (tmp_path / "bundles").unlink()
    assert files() == there
    assert archiving.push(url).runs == 2
