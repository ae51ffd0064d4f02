"""Numbers of certificates: LAB-BENCH-YEAR-NNNN without a gap, set by the last approval or the first signature."""

from __future__ import annotations

import re
import sqlite3
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from labcal import session
from labcal.certificate import calibration_bytes, register
from labcal.certificate.signing import atomic
from labcal.cli import execute
from labcal.errors import InputError
from labcal.model import Calibration

UTC_OF = "{}-11-21T08:00:00Z"
YEAR = datetime.now(UTC).year
WORDS = "correct horse battery"


@pytest.fixture
def people(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LABCAL_PASSPHRASE", WORDS)
    for name in ("ada", "bob", "carol"):
        session.new_key(name, WORDS)


def fresh(draft: Path, calibration: Calibration, run_id: str = "r1") -> Path:
    draft.write_bytes(calibration_bytes(replace(calibration, run_id=run_id, number=None, issued_utc=None)))
    for file in draft.parent.glob("*.sshsig"):
        file.unlink()
    return draft


def test_each_bench_and_year_counts_by_itself(home_of_its_own: Path):
    taken = [
        register.take(home_of_its_own, lab, bench, "r", "cal.json", UTC_OF.format(year))
        for lab, bench, year in (*[("FL", "Cage 1", 2026)] * 2, ("FL", "b", 2026), ("FL", "Cage 1", 2027))
    ]
    assert taken == ["FL-CAGE1-2026-0001", "FL-CAGE1-2026-0002", "FL-B-2026-0001", "FL-CAGE1-2027-0001"]
    assert register.part_of("日本") == "OTHER"
    assert register.part_of("Käfig, the long name of it") == "KAFIGTHELONGNAME"


def test_forty_at_once_have_forty_numbers_without_a_gap(home_of_its_own: Path):
    def take(i: int) -> str:
        return register.take(home_of_its_own, "FL", "cage", f"r{i}", "cal.json", UTC_OF.format(2026))

    with ThreadPoolExecutor(8) as pool:
        taken = sorted(pool.map(take, range(40)))
    assert taken == [f"FL-CAGE-2026-{i:04d}" for i in range(1, 41)]


def test_no_number_leaves_the_register(home_of_its_own: Path):
    for i in range(3):
        register.take(home_of_its_own, "FL", "cage", f"r{i}", "cal.json", UTC_OF.format(2026))
    with sqlite3.connect(home_of_its_own / register.FILE) as file, pytest.raises(sqlite3.Error, match="stays"):
        file.execute("DELETE FROM certificate WHERE running = 2")
    with sqlite3.connect(home_of_its_own / register.FILE) as file, pytest.raises(sqlite3.Error, match="stays"):
        file.execute("INSERT INTO certificate SELECT series, year, 9, utc, run_id, file, state, reason, sha256 "
                     "FROM certificate WHERE running = 1")  # fmt: skip


def test_the_last_approval_sets_number_and_date_and_the_signature_leaves_them(
    draft: Path, people: None, monkeypatch: pytest.MonkeyPatch
):
    first = session.approve(draft, "bob")
    assert first.number == f"SIM-OTHER-{YEAR}-0001"
    second = session.approve(draft, "carol")
    assert second.number == first.number
    assert second.issued_utc >= first.issued_utc
    content = draft.read_bytes()
    session.sign(draft, "ada", WORDS)
    assert draft.read_bytes() == content
    assert [one.state for one in session.numbers()] == ["signed"]
    session.sign(draft, "bob", WORDS)
    assert len(session.numbers()) == 1


def test_who_works_alone_gets_the_number_by_the_first_signature(draft: Path, people: None):
    session.sign(draft, "ada", WORDS)
    signed = session.load_calibration(draft)
    assert signed.number == f"SIM-OTHER-{YEAR}-0001"
    assert datetime.fromisoformat(signed.issued_utc).tzinfo is not None
    assert session.verify(draft).valid


def test_what_was_not_written_leaves_its_number_void_with_the_reason(
    draft: Path, calibration: Calibration, people: None, monkeypatch: pytest.MonkeyPatch
):
    def full(path: Path, content: bytes) -> None:
        raise OSError("no space left")

    with monkeypatch.context() as patch:
        patch.setattr(atomic, "write_bytes", full)
        with pytest.raises(OSError, match="no space"):
            session.approve(draft, "bob")
    assert session.load_calibration(draft).number is None
    session.approve(draft, "bob")
    assert [(one.state, one.reason) for one in session.numbers()] == [
        ("void", "cal.json was not written: no space left"), ("taken", "")]  # fmt: skip


def test_a_refused_approval_takes_no_number(draft: Path, people: None):
    with pytest.raises(InputError, match="nobody of the trust list"):
        session.approve(draft, "mallory")
    assert session.numbers() == ()


def test_a_number_that_is_not_its_own_is_not_signed(draft: Path, calibration: Calibration, people: None):
    session.approve(fresh(draft, calibration), "bob")
    own = session.load_calibration(draft)
    cases = {
        "was given to the calibration of run r1": replace(own, run_id="r2"),
        "never given out": replace(own, number=f"SIM-OTHER-{YEAR}-0007"),
    }
    for says, forged in cases.items():
        draft.write_bytes(calibration_bytes(forged))
        with pytest.raises(InputError, match=says):
            session.sign(draft, "ada", WORDS)
    draft.write_bytes(calibration_bytes(own))
    session.sign(draft, "ada", WORDS)
    twin = draft.with_name("twin.json")
    twin.write_bytes(calibration_bytes(replace(own, supersedes="ab" * 32)))
    with pytest.raises(InputError, match="another file has been signed as"):
        session.sign(twin, "ada", WORDS)
    assert not list(draft.parent.glob("twin.json.*"))


def test_the_command_shows_them_and_keeps_a_void_one_with_its_reason(
    draft: Path, calibration: Calibration, people: None, capsys: pytest.CaptureFixture[str]
):
    assert execute(["numbers"]) == 0
    assert "no certificate has a number yet" in capsys.readouterr().out
    session.approve(fresh(draft, calibration), "bob")
    number = f"SIM-OTHER-{YEAR}-0001"
    assert execute(["numbers", "--void", number]) == 2
    assert "keeps its reason" in capsys.readouterr().err
    assert execute(["numbers", "--void", number, "--reason", "typing error"]) == 0
    assert re.search(rf"{number}.*r1.*cal.json.*void: typing error", capsys.readouterr().out)
    assert execute(["sign", str(draft), "--key", "ada"]) == 2
    assert "is void (typing error)" in capsys.readouterr().err
    assert execute(["numbers", "--void", number, "--reason", "again"]) == 2
    assert execute(["numbers", "--void", "X-1", "--reason", "again"]) == 2
    session.approve(fresh(draft, calibration, "r2"), "bob")
    assert session.load_calibration(draft).number == f"SIM-OTHER-{YEAR}-0002"
