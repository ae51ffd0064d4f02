"""Who may measure, approve and release: what each way around it ends in."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal import session
from labcal.certificate import Signer, keys
from labcal.certificate.allowed_signers import own_line, read_allowed_signers
from labcal.certificate.calibration_file import calibration_bytes
from labcal.certificate.signing import Verification, approve, sign, verify
from labcal.certificate.sshsig import public_key_blob
from labcal.cli import execute
from labcal.errors import InputError
from labcal.files.home import home
from labcal.model import Calibration

NOW = datetime(2026, 11, 21, 12, 0, tzinfo=UTC)
PASSPHRASE = "correct horse"


def with_roles(lab: tuple[Signer, ...], **roles: tuple[str, ...]) -> tuple[Signer, ...]:
    return tuple(replace(signer, roles=roles.get(signer.principal, ())) for signer in lab)


def check(path: Path, lab: tuple[Signer, ...]) -> Verification:
    return verify(path, lab, frozenset(), NOW)


def numbered(draft: Calibration) -> Calibration:
    """With what an approval gives."""
    return replace(draft, number="LAB-CAGE-2026-0001", issued_utc="2026-11-21T11:00:00Z")


@pytest.fixture
def signed(draft: Path, lab: tuple[Signer, ...], key: Ed25519PrivateKey, other_key: Ed25519PrivateKey) -> Path:
    """Approved by bob, signed by ada and bob."""
    approve(draft, "bob", issue=numbered)
    sign(draft, "ada", key, lab)
    sign(draft, "bob", other_key, lab)
    return draft


@pytest.fixture
def three(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Ada, Bob and Eve with keys here: Ada measures, Bob approves and releases, Eve has no role."""
    monkeypatch.setenv("LABCAL_PASSPHRASE", PASSPHRASE)
    for name in ("ada", "bob", "eve"):
        session.new_key(name, PASSPHRASE)
    given(tmp_path, "ada", "measure")
    given(tmp_path, "bob", "approve", "release")
    return tmp_path


def given(folder: Path, name: str, *roles: str) -> None:
    (line,) = (entry.signer for entry in session.trusted_keys() if entry.signer.principal == name)
    (folder / name).write_text(replace(line, roles=()).line() + "\n")
    session.trust_keys(folder / name, roles)


@pytest.mark.parametrize(
    ("roles", "status", "why"),
    [
        ({}, "released", None),
        ({"ada": ("release",), "bob": ("approve",)}, "released", None),
        ({"ada": ("measure",), "bob": ("approve", "release")}, "released", None),
        (
            {"ada": ("release",), "bob": ("release",)},
            "provisional",
            "named as approver, but has not the role approve: bob",
        ),
        ({"ada": ("release",)}, "provisional", "named as approver, but has not the role approve: bob"),
        (
            {"ada": ("measure",), "bob": ("approve",)},
            "provisional",
            "nobody but its operator has signed who has the role",
        ),
    ],
)
def test_released_needs_an_approver_and_a_releaser(
    signed: Path, lab: tuple[Signer, ...], roles: dict[str, tuple[str, ...]], status: str, why: str | None
):
    found = check(signed, with_roles(lab, **roles))
    assert found.valid
    assert found.status == status
    assert (why or "") in str(found.provisional)
    assert (found.provisional is None) == (why is None)


def test_the_operator_releases_nothing_under_any_spelling(
    calibration: Calibration, draft: Path, lab: tuple[Signer, ...], key: Ed25519PrivateKey, other_key: Ed25519PrivateKey
):
    draft.write_bytes(calibration_bytes(replace(calibration, operator="\N{CYRILLIC SMALL LETTER A}d.a@lab")))
    approve(draft, "bob")
    sign(draft, "ada", key, lab)
    sign(draft, "bob", other_key, lab)
    may_all = with_roles(lab, ada=("measure", "release"), bob=("approve",))
    assert check(draft, may_all).provisional == "nobody but its operator has signed who has the role release"
    may_not = with_roles(lab, ada=("release",), bob=("approve", "release"))
    assert "has not the role measure" in str(check(draft, may_not).provisional)


def test_roles_are_kept_behind_the_key_where_openssh_has_a_comment(three: Path):
    lines = {s.principal: s for s in read_allowed_signers(keys.trust_list(home()))}
    assert lines["ada"].line().endswith(" labcal:roles=measure")
    assert [lines[name].roles for name in ("ada", "bob", "eve")] == [("measure",), ("approve", "release"), ()]
    given(three, "ada", "release", "approve")
    assert keys.trusted(home())[0].roles == ("approve", "release")
    session.trust_keys(three / "ada")
    assert keys.trusted(home())[0].roles == ("approve", "release")


def test_a_list_brings_no_roles_along(three: Path, key: Ed25519PrivateKey):
    stranger = replace(own_line("mallory", public_key_blob(key.public_key())), roles=("approve", "release"))
    (three / "theirs").write_text(stranger.line() + "\n")
    session.trust_keys(three / "theirs")
    assert keys.trusted(home())[-1].principal == "mallory"
    assert keys.trusted(home())[-1].roles == ()
    eve = keys.trusted(home())[2]
    (three / "eve").write_text(replace(eve, roles=("release",)).line() + "\n")
    session.trust_keys(three / "eve")
    assert keys.trusted(home())[2] == eve


@pytest.mark.parametrize("word", ["labcal:roles=king", "labcal:roles=", "labcal:roles=approve,", "labcal:role=approve"])
def test_a_role_that_there_is_not_is_named(three: Path, word: str):
    (three / "wrong").write_text(f"{keys.trusted(home())[2].line()} {word}\n")
    with pytest.raises(InputError, match=r"role that there is not|does not know"):
        session.trust_keys(three / "wrong")


@pytest.mark.usefixtures("three")
@pytest.mark.parametrize("name", ["ada", "eve", "\N{CYRILLIC SMALL LETTER A}da", "B.ob"])
def test_nobody_approves_without_the_role(draft: Path, name: str, capsys: pytest.CaptureFixture[str]):
    before = draft.read_bytes()
    assert execute(["approve", str(draft), "--as", name]) == 2
    assert "has not the role approve" in (said := capsys.readouterr().err) or "nobody of the trust list" in said
    assert draft.read_bytes() == before


@pytest.mark.usefixtures("three")
def test_nobody_signs_without_a_role_nor_what_somebody_approved_without(draft: Path):
    with pytest.raises(InputError, match="eve has no role by which to sign it"):
        session.sign(draft, "eve", PASSPHRASE)
    approve(draft, "ada")  # as another program may write it
    with pytest.raises(InputError, match=r"approvers\[0\]: ada has not the role approve"):
        session.sign(draft, "bob", PASSPHRASE)
    assert not list(draft.parent.glob("*.sshsig*"))


def test_what_was_measured_without_the_role_is_neither_approved_nor_signed(
    three: Path, calibration: Calibration, draft: Path
):
    draft.write_bytes(calibration_bytes(replace(calibration, operator="E. ve")))
    for step in (lambda: session.approve(draft, "bob"), lambda: session.sign(draft, "bob", PASSPHRASE)):
        with pytest.raises(InputError, match=r"operator: E\. ve has not the role measure"):
            step()
    given(three, "bob", "approve", "release")
    draft.write_bytes(calibration_bytes(replace(calibration, operator="bob")))
    with pytest.raises(InputError, match="operator: bob has not the role measure"):
        session.sign(draft, "bob", PASSPHRASE)


@pytest.mark.usefixtures("three")
def test_nobody_approves_a_cage_without_the_role(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    assert execute(["bench", "cage", "some-run", "--as", "ada", "--out", str(tmp_path / "cage.json")]) == 2
    assert "ada has not the role approve" in capsys.readouterr().err
    assert execute(["bench", "cage", "some-run", "--as", "bob", "--out", str(tmp_path / "cage.json")]) == 2
    assert "has not the role" not in capsys.readouterr().err  # there is no such run
    assert not (tmp_path / "cage.json").exists()


def test_a_new_key_after_a_lost_one_has_the_roles_of_the_person(three: Path):
    session.revoke_keys("bob")
    assert session.new_key("bob", PASSPHRASE).roles == ("approve", "release")
    assert session.new_key("carol", PASSPHRASE).roles == ()


def test_the_listing_shows_roles_and_trust_gives_them(three: Path, capsys: pytest.CaptureFixture[str]):
    assert execute(["keys", "trust", str(three / "ada"), "--role", "approve", "--role", "measure"]) == 0
    assert "ada" in (said := capsys.readouterr().out)
    assert "may measure, approve" in said
    assert execute(["keys", "list"]) == 0
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    of_ada = next(i for i, row in enumerate(rows) if row[0] == "ada")
    assert (rows[of_ada][-1], rows[of_ada + 1]) == ("measure", ["approve"])
    assert next(row for row in rows if row[0] == "eve")[-1] == "none"
    assert execute(["keys", "trust", str(three / "ada"), "--role", "king"]) == 2
