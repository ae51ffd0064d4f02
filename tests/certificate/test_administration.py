"""The trust list under its administrator's signature: an edit of it counts for nothing until they sign again."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from labcal import session
from labcal.certificate import Signer, keys, sshsig
from labcal.certificate.administration import NAMESPACE
from labcal.cli import execute
from labcal.errors import InputError
from labcal.files.home import home

PASSPHRASE = "correct horse"


@pytest.fixture
def folder(home_of_its_own: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of a list of Ada, who administers it, and Bob."""
    for name in ("ada", "bob"):
        session.new_key(name, PASSPHRASE)
    assert session.sign_trust_list("ada", PASSPHRASE) == 2
    return home() / "keys"


def eve_s_line(lab: tuple[Signer, ...]) -> str:
    return replace(lab[0], principal="eve").line() + "\n"


def edited(path: Path, change: Callable[[str], str]) -> None:
    path.write_text(change(path.read_text()))


def refused(draft: Path, match: str) -> None:
    """Nobody verifies, signs, approves or hands out by this list."""
    steps: list[Callable[[], object]] = [
        lambda: session.verify(draft),
        lambda: session.sign(draft, "bob", PASSPHRASE),
        lambda: session.approve(draft, "bob"),
        lambda: session.hand_out(draft, draft.parent),
        session.trusted_keys,
    ]
    for step in steps:
        with pytest.raises(InputError, match=match):
            step()
    assert not list(draft.parent.glob("*.sshsig"))


def test_openssh_checks_the_list_by_its_administrator(folder: Path):
    tool = shutil.which("ssh-keygen") or pytest.skip("needs ssh-keygen, which is not installed")
    of_ada = ["-f", str(folder / "administrator"), "-I", "ada", "-n", NAMESPACE, "-s"]
    command = [tool, "-Y", "verify", *of_ada, str(folder / "allowed_signers.sshsig")]
    content = (folder / "allowed_signers").read_bytes()
    assert subprocess.run(command, input=content, capture_output=True, check=False).returncode == 0
    assert subprocess.run(command, input=content + b" ", capture_output=True, check=False).returncode != 0


@pytest.mark.usefixtures("folder")
def test_a_signed_list_is_used_as_before(draft: Path):
    session.sign(draft, "bob", PASSPHRASE)
    assert session.verify(draft).valid


def test_an_edited_list_trusts_nobody(folder: Path, draft: Path, lab: tuple[Signer, ...]):
    edited(folder / "allowed_signers", lambda text: text + eve_s_line(lab))
    refused(draft, "was changed since ada, who administers it, signed it")
    edited(folder / "allowed_signers", lambda text: text.replace(eve_s_line(lab), ""))
    assert session.trusted_keys()
    edited(folder / "allowed_signers", lambda text: text.replace("\n", " labcal:roles=release\n", 1))
    refused(draft, "was changed since ada")


@pytest.mark.parametrize(
    ("lost", "match"),
    [
        ("allowed_signers", "administered by ada, and is gone"),
        ("allowed_signers.sshsig", "was changed since ada"),
        ("administrator", "which says whose signature counts, is gone"),
    ],
)
def test_a_list_of_which_something_is_gone_trusts_nobody(folder: Path, draft: Path, lost: str, match: str):
    (folder / lost).unlink()
    refused(draft, match)


def test_nobody_but_the_administrator_signs_the_list(folder: Path, draft: Path, lab: tuple[Signer, ...]):
    with pytest.raises(InputError, match="is administered by ada, who alone signs it"):
        session.sign_trust_list("bob", PASSPHRASE)
    edited(folder / "allowed_signers", lambda text: text + eve_s_line(lab))
    bob = keys.open_key(home(), "bob", PASSPHRASE)
    content = (folder / "allowed_signers").read_bytes()
    (folder / "allowed_signers.sshsig").write_text(sshsig.sign(content, bob, NAMESPACE))
    refused(draft, "signed by somebody else")
    ada = keys.open_key(home(), "ada", PASSPHRASE)
    (folder / "allowed_signers.sshsig").write_text(sshsig.sign(content, ada))  # for calibrations, not for the list
    refused(draft, "was changed since ada")


def test_a_second_line_makes_nobody_a_second_administrator(folder: Path, draft: Path, lab: tuple[Signer, ...]):
    edited(folder / "administrator", lambda text: text + eve_s_line(lab).replace("calibration", "trust-list"))
    refused(draft, "is not one line of one person")


def test_a_new_key_and_a_revocation_wait_for_the_administrator(
    folder: Path, draft: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.setenv("LABCAL_PASSPHRASE", PASSPHRASE)
    assert execute(["keys", "new", "--name", "carol"]) == 0
    assert "labcal keys sign --key ada" in capsys.readouterr().err
    refused(draft, "was changed since ada")
    assert execute(["keys", "list"]) == 0
    said = capsys.readouterr()
    assert "NOT TRUSTED" in said.err
    assert "carol" in said.out
    monkeypatch.setenv("LABCAL_PASSPHRASE", PASSPHRASE)
    assert execute(["keys", "sign", "--key", "ada"]) == 0
    assert [entry.signer.principal for entry in session.trusted_keys()] == ["ada", "bob", "carol"]
    session.revoke_keys("bob")
    refused(draft, "was changed since ada")
    session.sign_trust_list("ada", PASSPHRASE)
    assert [entry.revoked for entry in session.trusted_keys()] == [False, True, False]


def test_what_an_earlier_version_revoked_is_in_what_is_signed(folder: Path):
    bob = session.trusted_keys()[1].signer
    (folder / "revoked_keys").write_text(f"{' '.join(bob.line().split()[-2:])} bob\n")
    session.sign_trust_list("ada", PASSPHRASE)
    (folder / "revoked_keys").unlink()
    assert [entry.revoked for entry in session.trusted_keys()] == [False, True]


def test_who_is_revoked_administers_nothing(folder: Path):
    session.revoke_keys("ada")
    with pytest.raises(InputError, match="or is revoked"):
        session.sign_trust_list("ada", PASSPHRASE)
