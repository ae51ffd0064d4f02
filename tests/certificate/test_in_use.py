"""A calibration in use: whether it is signed, until when it is good, and what took its place."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import date
from hashlib import sha256
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal import session
from labcal.certificate import Signer, Stated, read_calibration, signing, state, stated_by_people
from labcal.certificate.calibration_file import calibration_bytes
from labcal.cli import execute
from labcal.errors import InputError
from labcal.files.home import home
from labcal.model import Calibration, Validity

READINGS = "t_s,segment,mode,dut_x,dut_y,dut_z,i_eps,temp_dut\n" + "".join(
    f"{t},a,nominal,40000,1000,60000,0.25,20\n" for t in range(5)
)


@pytest.fixture
def readings(tmp_path: Path) -> Path:
    (tmp_path / "in.csv").write_text(READINGS)
    return tmp_path / "in.csv"


@pytest.fixture
def trusting(lab: tuple[Signer, ...], tmp_path: Path) -> None:
    (tmp_path / "signers").write_text("".join(f"{signer.line()}\n" for signer in lab))
    session.trust_keys(tmp_path / "signers")


def applied(path: Path, readings: Path, *words: str) -> int:
    return execute(["apply", str(path), str(readings), "--out", str(readings.with_name("out.csv")), "--force", *words])


def status_of(path: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    capsys.readouterr()
    code = execute(["verify", str(path), "--json", "-"])
    told = json.loads(capsys.readouterr().out)
    return code, told["status"], "; ".join(told["why"])


def later_than(path: Path, calibration: Calibration, name: str = "later.json", **changes: object) -> Path:
    """A calibration of a later run that supersedes the one at `path`."""
    of = sha256(path.read_bytes()).hexdigest()
    later = replace(calibration, run_id="r-later", run_sha256="cd" * 32, **({"supersedes": of} | changes))
    (path.parent / name).write_bytes(calibration_bytes(later))
    return path.parent / name


@pytest.mark.usefixtures("trusting")
def test_apply_says_how_the_file_stands_and_refuses_where_a_signature_is_required(
    draft: Path, readings: Path, key: Ed25519PrivateKey, capsys: pytest.CaptureFixture[str]
):
    assert applied(draft, readings) == 0
    said = capsys.readouterr()
    assert "UNSIGNED: cal.json carries no signature" in said.err
    assert "UNSIGNED" not in said.out
    (readings.with_name("out.csv")).unlink()
    unread = readings.with_name("unread.csv")
    unread.write_text("dut_x,dut_y\n1,2\n")
    assert applied(draft, unread) == 2
    assert capsys.readouterr().err.count("\n") == 1  # a refusal is one sentence
    assert applied(draft, readings, "--require-signature") == 2
    assert "is not validly signed (cal.json carries no signature)" in capsys.readouterr().err
    assert not readings.with_name("out.csv").exists()
    signing.sign(draft, "ada", key)
    assert applied(draft, readings, "--require-signature") == 0
    assert "PROVISIONAL: no approver is named." in capsys.readouterr().err


@pytest.mark.usefixtures("trusting")
def test_what_was_changed_or_signed_by_a_stranger_is_not_used_where_a_signature_is_required(
    draft: Path, readings: Path, key: Ed25519PrivateKey, capsys: pytest.CaptureFixture[str]
):
    signing.sign(draft, "mallory", Ed25519PrivateKey.generate())
    assert applied(draft, readings, "--require-signature") == 2
    assert "its key is nobody's in the trust list" in capsys.readouterr().err
    signing.signature_files(draft)[0].unlink()
    signing.sign(draft, "ada", key)
    draft.write_bytes(draft.read_bytes().replace(b"112.5", b"112.6"))
    assert applied(draft, readings, "--require-signature") == 2
    assert "the file is not the one that was signed" in capsys.readouterr().err
    assert applied(draft, readings) == 0
    assert "NOT VALID" in capsys.readouterr().err


@pytest.mark.usefixtures("trusting")
def test_an_expired_file_says_so_to_who_applies_and_who_verifies_it(
    calibration: Calibration, draft: Path, readings: Path, key: Ed25519PrivateKey, capsys: pytest.CaptureFixture[str]
):
    draft.write_bytes(calibration_bytes(replace(calibration, validity=Validity((0.0, 60e3), None, (), "2025-01-31"))))
    signing.sign(draft, "ada", key)
    code, status, why = status_of(draft, capsys)
    assert (code, status) == (1, "expired")
    assert "validity.until: 2025-01-31 is past" in why
    assert applied(draft, readings) == 0
    assert "EXPIRED: it was good until 2025-01-31." in capsys.readouterr().err


@pytest.mark.usefixtures("trusting")
def test_what_took_its_place_is_known_once_it_was_seen_signed(
    calibration: Calibration,
    draft: Path,
    readings: Path,
    key: Ed25519PrivateKey,
    capsys: pytest.CaptureFixture[str],
):
    signing.sign(draft, "ada", key)
    later = later_than(draft, calibration)
    assert status_of(draft, capsys)[:2] == (0, "provisional")
    signing.sign(later, "ada", key)
    assert session.verify(later).valid
    later.unlink()  # what was seen is kept
    code, status, why = status_of(draft, capsys)
    assert (code, status) == (1, "superseded")
    assert "superseded by the calibration of run r-later" in why
    assert applied(draft, readings) == 0
    assert "SUPERSEDED: by the calibration of run r-later." in capsys.readouterr().err
    session.revoke_keys("ada")
    assert session.verify(draft).superseded_by is None


@pytest.mark.usefixtures("trusting")
def test_signing_what_supersedes_another_is_enough_to_know(calibration: Calibration, draft: Path):
    session.new_key("eve", "correct horse")
    session.sign(draft, "eve", "correct horse")
    session.sign(later_than(draft, calibration), "eve", "correct horse")
    assert session.verify(draft).status == "superseded"


@pytest.mark.usefixtures("trusting")
@pytest.mark.parametrize("forged", ["unsigned", "stranger", "another DUT", "not simulated", "edited"])
def test_nobody_takes_a_calibration_out_of_use_with_a_file_of_no_weight(
    calibration: Calibration, draft: Path, key: Ed25519PrivateKey, forged: str
):
    signing.sign(draft, "ada", key)
    changes: dict[str, object] = {
        "another DUT": {"dut": replace(calibration.dut, serial="FM-08")},
        "not simulated": {"simulated": False},
    }.get(forged, {})
    folder = home() / "calibrations"
    folder.mkdir(parents=True)
    later = later_than(draft, calibration, **changes).rename(folder / "later.json")
    if forged != "unsigned":
        signing.sign(later, "ada", Ed25519PrivateKey.generate() if forged == "stranger" else key)
    if forged == "edited":
        later.write_bytes(later.read_bytes().replace(b"r-later", b"r-other"))
    session.verify(later)
    assert session.verify(draft).status == "provisional"


def test_the_last_day_and_the_predecessor_are_stated_with_the_approval(
    calibration: Calibration, draft: Path, tmp_path: Path
):
    for name in ("ada", "bob"):
        session.new_key(name, "correct horse")
    old = tmp_path / "old.json"
    old.write_bytes(calibration_bytes(replace(calibration, run_id="r-old", supersedes=None)))
    assert execute(["approve", str(draft), "--as", "ada", "--until", "2999-12-31", "--supersedes", str(old)]) == 0
    found = read_calibration(draft)
    assert (found.validity.until, found.supersedes) == ("2999-12-31", sha256(old.read_bytes()).hexdigest())
    assert replace(found.validity, until=None) == replace(calibration.validity, until=None)
    assert execute(["approve", str(draft), "--as", "bob", "--until", "2999-12-30"]) == 2  # ada saw another day
    assert execute(["approve", str(draft), "--as", "bob", "--until", "2999-12-31"]) == 0
    assert read_calibration(draft).approvers == ("ada", "bob")


@pytest.mark.parametrize("until", ["2020-01-01", "tomorrow", "2027-02-30", "", "20271121"])
def test_a_last_day_that_is_past_or_none_changes_nothing(draft: Path, until: str, capsys: pytest.CaptureFixture[str]):
    session.new_key("bob", "correct horse")
    before = draft.read_bytes()
    assert execute(["approve", str(draft), "--as", "bob", "--until", until]) == 2
    assert "until: " in capsys.readouterr().err
    assert draft.read_bytes() == before


def test_nothing_supersedes_the_calibration_of_another_sensor(calibration: Calibration, draft: Path, tmp_path: Path):
    other = tmp_path / "other.json"
    other.write_bytes(calibration_bytes(replace(calibration, dut=replace(calibration.dut, serial="FM-08"))))
    with pytest.raises(InputError, match="a calibration of FM-08, not of FM-07"):
        stated_by_people(None, other).on(calibration)
    (tmp_path / "note").write_text("{}")
    with pytest.raises(InputError):
        stated_by_people(None, tmp_path / "note")
    assert stated_by_people("2026-11-21", None, date(2026, 11, 21)).until == "2026-11-21"


def test_what_is_superseded_is_never_written_over(
    calibration: Calibration, tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    old = tmp_path / "old.json"
    old.write_bytes(before := calibration_bytes(calibration))
    given = ["--out", str(old), "--supersedes", str(old), "--force"]
    for command in ("fit", "close-loop"):
        assert execute([command, "some-run", *given]) == 2
        assert "is what this command reads" in capsys.readouterr().err
    assert old.read_bytes() == before


@pytest.mark.usefixtures("trusting")
def test_who_works_alone_states_it_in_the_draft_and_nobody_after_a_signature_or_an_approval(
    draft: Path, calibration: Calibration, key: Ed25519PrivateKey
):
    before = draft.read_bytes()
    state(draft, Stated())
    assert draft.read_bytes() == before
    older = later_than(draft, calibration, "older.json", supersedes=None)
    state(draft, stated_by_people("2099-12-31", older))
    found = read_calibration(draft)
    assert (found.validity.until, found.supersedes) == ("2099-12-31", sha256(older.read_bytes()).hexdigest())
    session.new_key("bob.smith", "correct horse")
    session.approve(draft, "bob.smith")
    with pytest.raises(InputError, match=r"bob\.smith approved it as it is"):
        state(draft, Stated("2098-12-31"))
    signing.sign(draft, "ada", key)
    with pytest.raises(InputError, match="is signed already"):
        state(draft, Stated("2098-12-31"))
