"""A colleague who may push for a lab and means no good: what the archive says of other runs stays true, or is found."""

from __future__ import annotations

import shutil
from hashlib import sha256
from itertools import count
from pathlib import Path

import pytest
from conftest import GOLDEN, Bundle, rows_of
from postgres import Server

from labcal import session
from labcal.cli import execute as labcal
from labcal.errors import InputError
from labcal.files.home import home
from labcal.session import archiving
from labcal.session.in_archive import known_there
from labcal.store import Store, load_bundle

NUMBERS = count()
OTHER = "0" * 64
ODD = ("O'Brien", '%s "100%" :x $1', "é𝛼 {0}", "x'; DROP TABLE labcal.run --", "back\\slash")


@pytest.fixture
def mallory(postgres: Server, url: str) -> str:
    """A role that may push for the lab `evil`, and for `aalto` too."""
    name = f"mallory{next(NUMBERS)}"
    with postgres.connect() as connection:
        connection.execute(f"CREATE ROLE {name} LOGIN")
    for lab in ("evil", "aalto"):
        archiving.grant_in_archive(url, name, lab, "push")
    return name


def add_run(
    postgres: Server, database: str, by: str, site: str, digest: str, *, bundle: str = "", run: str = "r"
) -> None:
    values = (
        site,
        digest,
        run,
        "2019-01-01",
        "finished",
        True,
        *["S", "M", "nT", "", "", "none", ""],
        0,
        None,
        bundle,
        0,
    )
    with postgres.connect(database, by) as connection:
        marks = ", ".join(["%s"] * (len(values) + 2))
        connection.execute(f"INSERT INTO labcal.run VALUES ({marks})", (*values, "2019-01-01", by))


def pushed_as_evil(url: str, mallory: str, path: Path) -> None:
    archiving.push(url.replace("site=aalto", "site=evil").replace("//keeper@", f"//{mallory}@"), [str(path)])


def test_another_run_is_not_given_out_under_a_run_s_hash(
    postgres: Server, database: str, url: str, bundle: Bundle, mallory: str, tmp_path: Path
) -> None:
    digest, out = load_bundle(bundle()).sha256, tmp_path / "x.zip"
    pushed_as_evil(url, mallory, bundle(serial="FORGED"))
    [forged] = rows_of(postgres, database)["run"]
    add_run(postgres, database, mallory, "evil", digest, bundle=str(forged[15]))
    with pytest.raises(InputError, match=r"that evil names for run .* is another run"):
        archiving.fetch_from_archive(url, digest, None, out)
    assert not out.exists()
    archiving.push(url, [str(bundle())])
    archiving.fetch_from_archive(url, digest, None, out)
    assert load_bundle(out).sha256 == digest


def test_a_run_called_by_another_s_hash_hides_it_from_nobody(url: str, bundle: Bundle, tmp_path: Path) -> None:
    digest = load_bundle(bundle()).sha256
    archiving.push(url, [str(bundle()), str(bundle(run_id=digest))])
    archiving.fetch_from_archive(url, digest, None, tmp_path / "x.zip")
    assert load_bundle(tmp_path / "x.zip").sha256 == digest


def test_a_watch_writes_nowhere_but_in_its_folder(
    postgres: Server, database: str, url: str, bundle: Bundle, mallory: str, tmp_path: Path
) -> None:
    pushed_as_evil(url, mallory, bundle())
    [row] = rows_of(postgres, database)["run"]
    add_run(postgres, database, mallory, "evil", str(tmp_path / "elsewhere"), bundle=str(row[15]))
    before = {*tmp_path.iterdir()}
    labcal(["watch", "--archive", url, "--once", "--out", str(tmp_path / "out")])
    assert {*tmp_path.iterdir()} - before == {tmp_path / "out"}


def test_what_is_only_said_to_be_there_is_pushed(
    postgres: Server, database: str, url: str, bundle: Bundle, mallory: str
) -> None:
    session.import_bundle(bundle("r1"))
    with Store.open() as store:
        head = store.head_of("r1")
    (home() / "calibrations").mkdir()
    kept = shutil.copy(GOLDEN / "calibration-2.json", home() / "calibrations" / "r1.json")
    signature = Path(f"{kept}.sshsig")
    signature.write_text("no one's")
    of, own = (sha256(Path(one).read_bytes()).hexdigest() for one in (kept, signature))
    with postgres.connect(database, mallory) as connection:
        connection.execute("INSERT INTO labcal.kept_head VALUES ('aalto', %s, %s)", (head, OTHER))
        document = "INSERT INTO labcal.document VALUES ('aalto', %s, %s, 'signature', 'x', '', '', '')"
        connection.execute(document, (of, own))
    found = archiving.push(url)
    assert (found.runs, found.calibrations) == (1, 1)


def test_a_false_row_under_a_true_hash_is_told_to_whoever_pushes(
    postgres: Server, database: str, url: str, bundle: Bundle, mallory: str
) -> None:
    add_run(postgres, database, mallory, "aalto", load_bundle(bundle()).sha256)
    [told] = archiving.push(url, [str(bundle())]).refused
    assert "the catalogue says run_id r, and it is demo-0; started_utc 2019" in told


def test_nobody_says_when_a_run_came(postgres: Server, database: str, url: str, mallory: str) -> None:
    add_run(postgres, database, mallory, "aalto", OTHER)
    [found] = archiving.archived_runs(url)
    assert found["started_utc"].startswith("2019")
    assert not found["pushed_utc"].startswith("2019")


def test_a_damaged_bundle_is_found_and_made_whole_by_a_push_of_its_run(
    url: str, bundle: Bundle, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    session.import_bundle(bundle())
    archiving.push(url)
    assert labcal(["archive", "check", "--archive", url]) == 0
    [kept] = (tmp_path / "bundles").rglob("*.zip")
    good = kept.read_bytes()
    kept.chmod(0o600)
    kept.write_bytes(good[:-9] + b"x" * 9)
    assert labcal(["archive", "check", "--archive", url]) == 2
    kept.unlink()
    assert labcal(["archive", "check", "--archive", url]) == 2
    told = capsys.readouterr().err
    assert "is damaged" in told
    assert "is not there" in told
    archiving.push(url, ["demo-0"])
    assert kept.read_bytes() == good


@pytest.mark.parametrize(
    ("deed", "told"),
    [
        ("INSERT INTO labcal.parameter VALUES ('aalto', %s, 999, 'figure', 'offset x', 1, 1, 'nT')", "its parameters"),
        ("INSERT INTO labcal.effect VALUES ('aalto', %s, 99, 'offset-drift', '', '', false)", "its effects"),
        ("INSERT INTO labcal.instrument VALUES ('aalto', %s, 99, '', '', '', 'R-1', '')", "its instruments"),
        (f"INSERT INTO labcal.document VALUES ('aalto', %s, '{OTHER}', 'report', 'CAL.pdf', '', '', '')", "'CAL.pdf'"),
    ],
)
def test_rows_that_were_added_to_a_calibration_are_found(
    deed: str, told: str, postgres: Server, database: str, url: str, mallory: str, tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    made = Path(shutil.copy(GOLDEN / "calibration-2.json", tmp_path / "cal.json"))
    (tmp_path / "cal.json.sshsig").write_text("no one's")
    archiving.push(url, [str(made)])
    assert archiving.check_archive(url, None) == []
    with postgres.connect(database, mallory) as connection:
        connection.execute(deed, (sha256(made.read_bytes()).hexdigest(),))
    assert labcal(["archive", "check", "--archive", url]) == 2
    assert told in capsys.readouterr().err


def test_no_signature_beside_a_later_file_hides_another(
    postgres: Server, database: str, url: str, mallory: str, tmp_path: Path
) -> None:
    content = (GOLDEN / "calibration-2.json").read_bytes()
    with postgres.connect(database, mallory) as connection:
        row = "'r', 'r', true, 'S', 'M', 'nT', '', NULL, NULL, %s, 'later', now(), CURRENT_USER"
        connection.execute(
            f"INSERT INTO labcal.calibration VALUES ('aalto', 'c', {row})", (sha256(content).hexdigest(),)
        )
        for digest, name in (("a", "x.sshsig"), ("b", "y.sshsig"), ("c", "../z"), ("d", "")):
            document = "INSERT INTO labcal.document VALUES ('aalto', 'c', %s, 'signature', %s, '', '', %s)"
            connection.execute(document, (digest, name, digest))
    known_there(url, content, [], tmp_path)
    signatures = {path.name: path.read_bytes() for path in tmp_path.glob("*.sshsig")}
    assert sorted(signatures) == ["0.json.2.sshsig", "0.json.3.sshsig", "0.json.4.sshsig", "0.json.sshsig"]
    assert sorted(signatures.values()) == [b"a", b"b", b"c", b"d"]


def test_what_another_site_says_supersedes_a_calibration_bears_its_name(
    postgres: Server, database: str, url: str, mallory: str, tmp_path: Path
) -> None:
    made = Path(shutil.copy(GOLDEN / "calibration-2.json", tmp_path / "cal.json"))
    (tmp_path / "cal.json.sshsig").write_text("no one's")
    archiving.push(url, [str(made)])
    with postgres.connect(database, mallory) as connection:
        row = "'r', 'better', true, 'S', 'M', 'nT', '', NULL, NULL, %s, 'later', now(), CURRENT_USER"
        digest = sha256(made.read_bytes()).hexdigest()
        connection.execute(f"INSERT INTO labcal.calibration VALUES ('evil', 'c', {row})", (digest,))
    [found] = [one for one in archiving.archived_calibrations(url) if one["site"] == "aalto"]
    assert found["superseded_by"] == "better of evil"


@pytest.mark.parametrize("serial", [*ODD, "\ud800", "\x00"])
def test_whatever_a_serial_is_a_question_is_answered_or_refused_in_a_sentence(
    serial: str, url: str, bundle: Bundle, capsys: pytest.CaptureFixture[str]
) -> None:
    if serial in ODD:
        archiving.push(url, [str(bundle("odd", serial.replace("/", "")))])
        assert labcal(["archive", "runs", "--archive", url]) == 0
        assert serial in capsys.readouterr().out
    asked = [["calibrations", "--dut", serial], ["calibrations", "--instrument", serial, "--effect", serial]]
    for words in [*asked, ["get", serial, "--out", "x.zip"], ["grant", serial, "--lab", serial, "--may", "read"]]:
        assert labcal(["archive", *words, "--archive", url]) in (0, 2)
    assert "a fault of labcal's own" not in capsys.readouterr().err


@pytest.mark.parametrize("role", ["O'Brien", '100% "weird" :x'])
def test_whatever_a_role_is_called_it_is_given_its_right(role: str, postgres: Server, url: str) -> None:
    from psycopg import sql

    with postgres.connect() as connection:
        connection.execute(sql.SQL("CREATE ROLE {} LOGIN").format(sql.Identifier(role)))
    for may in ("push", "read", "nothing"):
        assert labcal(["archive", "grant", role, "--lab", role, "--may", may, "--archive", url]) == 0
