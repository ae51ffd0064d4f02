"""A key that is revoked: what it signed before stays where that is shown, and no list brings it back."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal import session
from labcal.certificate import Signer, keys
from labcal.certificate.allowed_signers import NEVER, own_line, read_allowed_signers, revoked_from
from labcal.certificate.calibration_file import calibration_bytes
from labcal.certificate.signing import Verification, approve, sign, verify
from labcal.certificate.sshsig import public_key_blob
from labcal.certificate.timestamp import ShownTime
from labcal.cli import execute
from labcal.errors import InputError
from labcal.files.home import home
from labcal.model import Calibration

NOW = datetime(2026, 11, 21, 12, 0, tzinfo=UTC)
STOLEN = datetime(2026, 10, 1, tzinfo=UTC)
PASSPHRASE = "correct horse"


def check(path: Path, lab: tuple[Signer, ...], shown: datetime | None = None) -> Verification:
    return verify(path, lab, frozenset(), NOW, shown=lambda file, signature: shown and ShownTime(shown, "token"))


@pytest.fixture
def stolen(lab: tuple[Signer, ...]) -> tuple[Signer, ...]:
    """Ada's key is revoked from the first of October."""
    return (revoked_from(lab[0], STOLEN), lab[1])


def line_of(name: str, key: Ed25519PrivateKey) -> Signer:
    return own_line(name, public_key_blob(key.public_key()))


def test_what_is_shown_to_be_from_before_stays_valid(draft: Path, stolen: tuple[Signer, ...], key: Ed25519PrivateKey):
    sign(draft, "ada", key)
    assert check(draft, stolen, STOLEN - timedelta(seconds=1)).valid
    late = check(draft, stolen, STOLEN)
    assert [c.objection for c in late.checks] == ["its key is revoked from 2026-10-01"]


def test_a_claimed_time_shows_nothing_and_that_is_said(
    calibration: Calibration, draft: Path, stolen: tuple[Signer, ...], key: Ed25519PrivateKey
):
    draft.write_bytes(calibration_bytes(replace(calibration, issued_utc="2026-09-01T10:00:00Z")))
    sign(draft, "ada", key)
    found = check(draft, stolen)
    assert not found.valid
    assert found.checks[0].objection == (
        "its key is revoked from 2026-10-01; a time that is only claimed does not show that it signed before"
    )


def test_a_second_line_of_a_revoked_key_vouches_for_nothing(
    draft: Path, lab: tuple[Signer, ...], stolen: tuple[Signer, ...], key: Ed25519PrivateKey
):
    sign(draft, "ada", key)
    for both in ((*lab, *stolen), (*stolen, *lab)):
        assert not check(draft, both).valid
    altogether = revoked_from(lab[0], NEVER)
    assert not check(draft, (*lab, altogether), STOLEN - timedelta(days=900)).valid


def test_a_key_that_expires_is_judged_at_the_shown_time(draft: Path, lab: tuple[Signer, ...], key: Ed25519PrivateKey):
    sign(draft, "ada", key)
    expired = (replace(lab[0], valid_before=STOLEN), lab[1])
    assert not check(draft, expired).valid
    assert check(draft, expired, STOLEN - timedelta(days=1)).valid
    assert not check(draft, (replace(lab[0], valid_after=STOLEN),), STOLEN - timedelta(days=1)).valid


def test_revoked_from_a_date_can_become_earlier_and_never_later(home_of_its_own: Path):
    signer = keys.new_key(home(), "ada", PASSPHRASE)
    assert keys.revoke(home(), "ada", STOLEN) == 1
    assert keys.revoked(home()) == frozenset()
    for later in (STOLEN, STOLEN + timedelta(days=1)):
        with pytest.raises(InputError, match="revoked already"):
            keys.revoke(home(), "ada", later)
    assert keys.revoke(home(), "ada", STOLEN - timedelta(days=1)) == 1
    assert keys.revoke(home(), "ada") == 1
    assert keys.revoked(home()) == {signer.key}
    assert keys.trusted(home())[0].valid_before == NEVER


@pytest.mark.parametrize("since", [NEVER, STOLEN])
def test_a_revocation_travels_and_an_old_list_does_not_undo_it(
    tmp_path: Path, lab: tuple[Signer, ...], since: datetime
):
    old, new = tmp_path / "old", tmp_path / "new"
    old.write_text("".join(f"{s.line()}\n" for s in lab))
    session.trust_keys(old)
    session.revoke_keys("ada", since)
    new.write_text("".join(f"{entry.to_hand_out().line()}\n" for entry in session.trusted_keys()))
    other = tmp_path / "other"
    keys.trust(other, old)
    (changed,) = keys.trust(other, new)
    assert changed.revoked
    for lists in (old, new, old):
        assert keys.trust(other, lists) == ()
    assert [(s.principal, s.revoked, s.valid_before) for s in keys.trusted(other)] == [
        ("ada", True, since),
        ("bob", False, None),
    ]
    never_heard_of_her = tmp_path / "third"
    keys.trust(never_heard_of_her, new)
    assert keys.trust(never_heard_of_her, old) == ()
    assert keys.trusted(never_heard_of_her)[0].revoked


def test_a_dated_revocation_elsewhere_does_not_soften_our_own(tmp_path: Path, lab: tuple[Signer, ...]):
    (tmp_path / "list").write_text(lab[0].line() + "\n")
    session.trust_keys(tmp_path / "list")
    session.revoke_keys("ada")
    (tmp_path / "theirs").write_text(revoked_from(lab[0], STOLEN).line() + "\n")
    assert session.trust_keys(tmp_path / "theirs") == ()
    assert keys.revoked(home()) == {lab[0].key}


def test_a_named_list_that_does_not_know_is_told_by_the_lab_s_own(
    draft: Path, tmp_path: Path, lab: tuple[Signer, ...], key: Ed25519PrivateKey
):
    (tmp_path / "named").write_text("".join(f"{s.line()}\n" for s in lab))
    session.trust_keys(tmp_path / "named")
    sign(draft, "ada", key)
    assert session.verify(draft, tmp_path / "named").valid
    session.revoke_keys("ada", STOLEN)
    found = session.verify(draft, tmp_path / "named")
    assert "its key is revoked from 2026-10-01" in str(found.checks[0].objection)


def test_what_is_handed_out_says_who_is_revoked(draft: Path, tmp_path: Path, lab: tuple[Signer, ...]):
    (tmp_path / "list").write_text("".join(f"{s.line()}\n" for s in lab))
    session.trust_keys(tmp_path / "list")
    (home() / "keys" / "revoked_keys").write_text(f"ssh-ed25519 {lab[1].line().split()[-1]} bob\n")  # as 0.1 kept it
    session.revoke_keys("ada", STOLEN)
    (tmp_path / "given").mkdir()
    session.hand_out(draft, tmp_path / "given")
    given = read_allowed_signers(tmp_path / "given" / "allowed_signers")
    assert [(s.principal, s.revocation()) for s in given if s.revoked] == [
        ("ada", "is revoked from 2026-10-01"),
        ("bob", "is revoked"),
    ]


def test_who_is_revoked_signs_and_approves_nothing_more(draft: Path, real_draft: Path):
    session.new_key("ada", PASSPHRASE)
    session.revoke_keys("ada", STOLEN)
    with pytest.raises(InputError, match="the key of ada is revoked"):
        session.sign(draft, "ada", PASSPHRASE)
    with pytest.raises(InputError, match="ada is nobody of the trust list"):
        session.approve(draft, "ada")


@pytest.mark.parametrize("since", [NEVER, STOLEN])
def test_a_revoked_signer_s_file_is_signed_again_by_a_new_key(draft: Path, since: datetime):
    for name in ("ada", "bob"):
        session.new_key(name, PASSPHRASE)
    session.approve(draft, "bob")
    for name in ("ada", "bob"):
        session.sign(draft, name, PASSPHRASE)
    content = draft.read_bytes()
    session.revoke_keys("ada", since)
    assert not session.verify(draft).valid
    session.new_key("ada", PASSPHRASE)
    assert session.sign(draft, "ada", PASSPHRASE).name == "cal.json.sshsig"
    found = session.verify(draft)
    assert found.signers == ("ada", "bob")
    assert draft.read_bytes() == content
    assert sorted(p.name for p in draft.parent.glob("cal.json*")) == [
        "cal.json",
        "cal.json.2.sshsig",
        "cal.json.sshsig",
        "cal.json.sshsig.revoked",
    ]
    with pytest.raises(InputError, match="ada has signed it already"):
        session.sign(draft, "ada", PASSPHRASE)


def test_another_person_may_sign_in_the_place_of_who_is_revoked_but_nobody_twice(draft: Path):
    for name in ("ada", "bob", "eve"):
        session.new_key(name, PASSPHRASE)
    session.sign(draft, "ada", PASSPHRASE)
    session.sign(draft, "bob", PASSPHRASE)
    session.revoke_keys("ada")
    with pytest.raises(InputError, match="bob has signed it already"):
        session.sign(draft, "bob", PASSPHRASE)
    assert session.sign(draft, "eve", PASSPHRASE).name == "cal.json.sshsig"
    assert session.verify(draft).signers == ("eve", "bob")


def test_an_approver_whose_key_was_revoked_has_not_signed(
    draft: Path, lab: tuple[Signer, ...], key: Ed25519PrivateKey, other_key: Ed25519PrivateKey
):
    approve(draft, "bob")
    sign(draft, "bob", other_key, lab)
    sign(draft, "ada", key, (lab[0], revoked_from(lab[1], NEVER)))
    assert check(draft, lab).provisional == "named as approver, but has not signed: bob"


@pytest.mark.parametrize("date", ["yesterday", "2026-13-01", "", "20261001"])
def test_a_date_that_is_none_revokes_nothing(date: str, capsys: pytest.CaptureFixture[str]):
    session.new_key("ada", PASSPHRASE)
    assert execute(["keys", "revoke", "ada", "--from", date]) == 2
    assert "is no date" in capsys.readouterr().err
    assert not session.trusted_keys()[0].revoked


def test_the_command_says_that_a_claimed_time_does_not_count(capsys: pytest.CaptureFixture[str]):
    session.new_key("ada", PASSPHRASE)
    assert execute(["keys", "revoke", "ada", "--from", "2026-10-01"]) == 0
    assert "only claims to be from before does not count" in capsys.readouterr().out
    assert execute(["keys", "list"]) == 0
    assert "revoked from" in " ".join(capsys.readouterr().out.split())
