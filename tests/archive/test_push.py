"""`labcal push`: whole or not there, once whoever says it twice, and never in the way of a run."""

from __future__ import annotations

import json
import shutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest
from conftest import Bundle, rows_of
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
from postgres import Server

from labcal import audit, certificate, session
from labcal.certificate import calibration_bytes, sshsig
from labcal.cli import execute as labcal
from labcal.errors import InputError, Stopped
from labcal.files.home import home
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Block
from labcal.session import archiving
from labcal.session.in_archive import asking
from labcal.store import Store, load_bundle

WORDS = "correct horse"
GOLDEN = Path(__file__).parents[1] / "golden"


def count(postgres: Server, database: str) -> dict[str, int]:
    return {name: len(rows) for name, rows in rows_of(postgres, database).items()}


@pytest.fixture
def signed(tmp_path: Path) -> Path:
    """A calibration with something beside it that is called a signature, and a report."""
    shutil.copy(GOLDEN / "calibration-2.json", tmp_path / "cal.json")
    (tmp_path / "cal.json.sshsig").write_text("-----BEGIN SSH SIGNATURE-----\nno one's\n-----END SSH SIGNATURE-----\n")
    (tmp_path / "cal.html").write_text("<p>report")
    return tmp_path / "cal.json"


def recorded(run_id: str, status: str = "finished") -> None:
    with Store.open() as store:
        header = RunHeader(
            *(run_id, "2026-05-01T10:00:00Z", True, "ada", Dut("SN-9", "M3"), Reference("vector", "R7")),
            procedure="preflight",
            instruments=({"name": "x", "model": "PL155", "serial": "S-77"},),
        )
        with store.begin(header) as writer:
            writer.write(Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), np.arange(3.0), np.ones((3, 3))))
            writer.finish(status)


def test_push_copies_runs_calibrations_and_the_audit_log_and_again_changes_nothing(
    postgres: Server, database: str, url: str, bundle: Bundle, signed: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert labcal(["push", str(bundle()), str(signed), "--archive", url]) == 0
    assert "new there 1 runs, 1 calibrations, 3 entries" in capsys.readouterr().out
    there = rows_of(postgres, database)
    of_the_run = {"run": 1, "kept_head": 0, "instrument": 2}
    of_the_file = {"calibration": 1, "effect": 2, "parameter": 25, "document": 2}
    assert {name: len(rows) for name, rows in there.items()} == {**of_the_run, **of_the_file, "audit": 3}
    for _ in range(2):
        assert labcal(["push", str(bundle()), str(signed), "--archive", url]) == 0
        assert labcal(["push", "--archive", url]) == 0
        assert rows_of(postgres, database) == there


def test_the_bytes_come_back(url: str, bundle: Bundle, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pushed = bundle()
    archiving.push(url, [str(pushed)])
    out = tmp_path / "back.zip"
    assert labcal(["archive", "get", "demo-0", "--archive", url, "--out", str(out)]) == 0
    assert load_bundle(out).sha256 == load_bundle(pushed).sha256
    [kept] = (tmp_path / "bundles").rglob("*.zip")
    assert not kept.stat().st_mode & 0o222  # it is never written to again
    kept.chmod(0o600)
    kept.write_bytes(kept.read_bytes()[:-1] + b"x")
    assert labcal(["archive", "get", "demo-0", "--archive", url, "--out", str(tmp_path / "other.zip")]) == 2
    assert "is damaged" in capsys.readouterr().err
    assert not (tmp_path / "other.zip").exists()


def test_only_what_is_finished_goes_and_nobody_waits_for_it(postgres: Server, database: str, url: str) -> None:
    recorded("done")
    recorded("gone", "stopped")
    header = RunHeader("now", "2026-05-01T10:00:00Z", True, "ada", Dut("SN-9"), Reference("none"))
    with Store.open() as store, store.begin(header) as writer:
        found = archiving.push(url)
        assert (found.runs, found.refused) == (1, ())
        writer.commit()  # the run goes on
        assert archiving.push(url, ["now"]).refused == (
            "run now is running: only a finished run goes into the archive",
        )
        writer.finish("finished")
    assert archiving.push(url).runs == 1
    assert archiving.push(url, ["gone"]).refused[0].startswith("run gone is stopped")
    names = sorted(str(row[2]) for row in rows_of(postgres, database)["run"])
    assert names == ["done", "now"]
    instruments = {row[3:7] for row in rows_of(postgres, database)["instrument"]}
    assert instruments == {("reference", "", "", "R7"), ("x", "", "PL155", "S-77")}


def test_the_same_name_at_two_sites_and_at_one(url: str, bundle: Bundle, tmp_path: Path) -> None:
    other = url.replace("site=aalto", "site=glasgow")
    first, second = bundle(), bundle(serial="SN-2")
    with ThreadPoolExecutor() as both:  # at once, and some of it twice
        pushes = [
            both.submit(archiving.push, one, [str(path)]) for one in (url, other) for path in (first, second, first)
        ]
        new = sum(one.result().runs for one in pushes)
    found = archiving.archived_runs(url)
    assert new == 4
    assert sorted((one["site"], one["run_id"], one["dut_serial"]) for one in found) == [
        (site, "demo-0", serial) for site in ("aalto", "glasgow") for serial in ("SN-1", "SN-2")
    ]
    with pytest.raises(InputError, match="there are 4 runs 'demo-0'"):
        archiving.fetch_from_archive(url, "demo-0", None, tmp_path / "y.zip")


@pytest.mark.parametrize("cut", ["pg_terminate_backend(pg_backend_pid())", "1 / 0"])
def test_a_push_cut_in_the_middle_leaves_nothing_half(
    cut: str, postgres: Server, database: str, url: str, bundle: Bundle, signed: Path, tmp_path: Path
) -> None:
    broken = "CREATE FUNCTION cut() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN PERFORM {}; RETURN NEW; END $$"
    with postgres.connect(database) as connection:
        connection.execute(broken.format(cut))
        for table in ("instrument", "parameter"):
            connection.execute(f"CREATE TRIGGER cut BEFORE INSERT ON labcal.{table} EXECUTE FUNCTION cut()")
    told = ""
    try:
        told = " ".join(archiving.push(url, [str(bundle()), str(signed)]).refused)
    except InputError as away:
        told = str(away)
    assert "server closed" in told or "terminating" in told or "division by zero" in told
    assert not any(count(postgres, database)[name] for name in ("run", "instrument", "calibration", "document"))
    with postgres.connect(database) as connection:
        connection.execute("DROP FUNCTION cut CASCADE")
    assert archiving.push(url, [str(bundle()), str(signed)]).runs == 1
    assert len([*(tmp_path / "bundles").rglob("*.zip")]) == 1


def test_a_server_that_is_away_is_one_sentence_and_push_every_goes_on_when_it_is_back(
    postgres: Server, database: str, url: str, bundle: Bundle, capsys: pytest.CaptureFixture[str]
) -> None:
    def hide(name: str, other: str) -> None:
        with postgres.connect() as connection:
            connection.execute(f"ALTER DATABASE {name} RENAME TO {other}")

    pushed, waits = bundle(), list[float]()

    def wait(seconds: float) -> None:
        waits.append(seconds)
        if len(waits) == 2:
            hide("hidden", database)
        if len(waits) == 3:
            raise Stopped

    hide(database, "hidden")
    assert labcal(["push", str(pushed), "--archive", url]) == 2
    told = capsys.readouterr().err
    assert "the archive cannot be reached" in told
    assert "goes there with the next push" in told
    assert len(told.splitlines()) == 1
    heard = list[str]()
    with pytest.raises(Stopped):
        archiving.push_every(60.0, url, [str(pushed)], None, heard.append, wait)
    assert waits == [60.0] * 3
    assert [one.partition(":")[0] for one in heard] == ["postgresql", "run demo-0"]  # that it is away is said once


def test_one_that_cannot_be_pushed_keeps_no_other_back(
    url: str, bundle: Bundle, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copy(GOLDEN / "calibration-2.json", draft := tmp_path / "draft.json")
    assert labcal(["push", str(draft), "no-such-run", str(bundle()), "--archive", url]) == 2
    told = capsys.readouterr()
    assert "new there 1 runs, 0 calibrations" in told.out
    assert "is a draft" in told.err
    assert "(2 not pushed; the others are there)" in told.err


def test_a_calibration_brings_its_run_and_a_run_its_calibrations(url: str, bundle: Bundle, signed: Path) -> None:
    path = bundle("r1")
    stated = json.loads(signed.read_text()) | {"run_id": "r1", "run_sha256": load_bundle(path).sha256}
    signed.write_text(json.dumps(stated))
    session.import_bundle(path)
    found = archiving.push(url, [str(signed)])
    assert (found.runs, found.calibrations) == (1, 1)
    kept = home() / "calibrations"
    kept.mkdir()
    shutil.copy(signed, kept / "r1.json")
    shutil.copy(f"{signed}.sshsig", kept / "r1.json.sshsig")
    elsewhere = url.replace("site=aalto", "site=glasgow")
    found = archiving.push(elsewhere, ["r1"])
    assert (found.runs, found.calibrations) == (1, 1)
    assert {one["measured_utc"] for one in archiving.archived_calibrations(url)} == {"2026-03-02T08:15:00.000Z"}


def test_what_is_there_is_not_verified_again_and_the_log_is_read_once_for_all(
    url: str, signed: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept, looked, key = home() / "calibrations", list[str](), Ed25519PrivateKey.generate()
    kept.mkdir()
    for number in range(3):
        made = replace(certificate.read_calibration(signed), run_id=f"r{number}")
        content = calibration_bytes(made)
        signature = sshsig.sign(content, key).encode()
        (kept / f"r{number}.json").write_bytes(content)
        (kept / f"r{number}.json.sshsig").write_bytes(signature)
        audit.append(home(), "sign", "ada", {"signature": audit.link_of(signature)})
    verify, read = certificate.verify, audit.read
    monkeypatch.setattr(
        certificate, "verify", lambda *all_, **named: (looked.append("file"), verify(*all_, **named))[1]
    )
    monkeypatch.setattr(audit, "read", lambda place: (looked.append("log"), read(place))[1])
    assert archiving.push(url).calibrations == 3
    assert (looked.count("file"), looked.count("log")) == (3, 2)  # whose signatures hold, and to push the log itself
    looked.clear()
    assert archiving.push(url).calibrations == 0
    assert "file" not in looked


def test_a_second_signature_is_added_later_and_who_signed_is_told(url: str, signed: Path) -> None:
    archiving.push(url, [str(signed)])
    assert [one["signers"] for one in archiving.archived_calibrations(url)] == [""]  # it holds for nobody
    signed.with_name("cal.json.sshsig").unlink()
    for name in ("ada", "bob"):
        session.new_key(name, "a long enough phrase")
        session.sign(signed, name, "a long enough phrase")  # the first gives it its number: it is another file then
        assert archiving.push(url, [str(signed)]).calibrations == 1
    found = sorted(sorted(filter(None, one["signers"].split(", "))) for one in archiving.archived_calibrations(url))
    assert found == [[], ["ada", "bob"]]


def test_the_audit_log_goes_along_entry_by_entry_as_it_lies_here(postgres: Server, database: str, url: str) -> None:
    for name in ("a", "b"):
        audit.append(home(), "run", "ada", {"run": name})
        archiving.push(url)
    there = [(row[3], bytes(row[8]), bytes(row[9])) for row in rows_of(postgres, database)["audit"]]
    assert sorted(there) == audit.stored(home())


def test_a_log_that_was_cut_or_put_back_since_it_was_pushed_is_told(url: str, tmp_path: Path) -> None:
    for name in ("a", "b"):
        audit.append(home(), "run", "ada", {"run": name})
    shutil.copy(home() / "audit.sqlite", tmp_path / "before")
    audit.append(home(), "run", "ada", {"run": "c"})
    assert archiving.push(url).refused == ()
    shutil.copy(tmp_path / "before", home() / "audit.sqlite")
    [told] = archiving.push(url).refused
    assert "the audit log was rewritten or put back since it was pushed: entry 4" in told
    for name in ("d", "e"):
        audit.append(home(), "run", "ada", {"run": name})
        pushed = archiving.push(url)
        assert (pushed.entries, len(pushed.refused)) == (0, 1)


def test_verify_asks_when_a_signature_came_and_what_supersedes_the_file(
    url: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A lab that has neither the log nor the later file: the archive has them both."""
    old, new = tmp_path / "old.json", tmp_path / "new.json"
    session.new_key("ada", WORDS)
    shutil.copy(GOLDEN / "calibration-2.json", old)
    fresh(old)
    session.sign(old, "ada", WORDS)
    stated = session.load_calibration(old)
    new.write_bytes(calibration_bytes(replace(stated, number=None, supersedes=sha256(old.read_bytes()).hexdigest())))
    fresh(new)
    session.sign(new, "ada", WORDS)
    archiving.push(url, [str(old), str(new)])
    lab = tmp_path / "signers"
    lab.write_text("".join(f"{one.line()}\n" for one in session.handed_out()))
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "another lab"))
    assert [session.verify(old, lab).status, session.verify(old, lab).checks[0].shown] == ["provisional", None]
    found = session.verify(old, lab, in_archive=asking(url, print))
    assert found.status == "superseded"
    shown = found.checks[0].shown
    assert shown is not None
    assert (shown.by, abs((datetime.now(UTC) - shown.utc).total_seconds()) < 600) == ("archive", True)
    assert "shown by the archive" in found.signed_at(found.checks[0])
    told: list[str] = []
    monkeypatch.setenv("LABCAL_ARCHIVE", "postgresql://nobody@127.0.0.1:9/none")
    assert session.verify(old, lab, in_archive=asking(None, told.append)).status == "provisional"
    assert told[0].startswith("the archive was not asked: ")


def fresh(path: Path) -> None:
    """As nobody has approved or numbered it."""
    draft = replace(session.load_calibration(path), approvers=(), number=None, issued_utc=None)
    path.write_bytes(calibration_bytes(draft))
