from __future__ import annotations

import shutil
import subprocess
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import Signer, Verification, read_allowed_signers, read_calibration, sshsig
from labcal.certificate.allowed_signers import own_line
from labcal.certificate.keys import SIMULATED
from labcal.certificate.signing import approve, sign, sign_simulated, signature_files, verify
from labcal.certificate.sshsig import public_key_blob
from labcal.errors import InputError
from labcal.record.person import perhaps_one_person, same_person

NOW = datetime(2026, 11, 21, 12, 0, tzinfo=UTC)
Lab = tuple[Signer, ...]


def check(path: Path, lab: Lab, **more: str) -> Verification:
    return verify(path, lab, frozenset(), NOW, **more)


def objection(path: Path, lab: Lab) -> str:
    result = check(path, lab)
    assert not result.valid
    return "; ".join(str(c.objection) for c in result.checks)


def test_two_persons_sign_and_both_hold(draft: Path, lab: Lab, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey):
    numbered = {"number": "LAB-CAGE-2026-0001", "issued_utc": "2026-11-21T11:00:00Z"}
    approve(draft, "bob", issue=lambda draft: replace(draft, **numbered))
    assert sign(draft, "ada", key, lab).name == "cal.json.sshsig"
    assert check(draft, lab).provisional == "named as approver, but has not signed: bob"
    assert sign(draft, "bob", other_key, lab).name == "cal.json.2.sshsig"
    result = check(draft, lab)
    assert result.valid
    assert result.signers == ("ada", "bob")
    assert result.provisional is None
    assert sorted(p.name for p in draft.parent.iterdir()) == ["cal.json", "cal.json.2.sshsig", "cal.json.sshsig"]


def test_ssh_keygen_alone_accepts_the_file_and_refuses_it_after_any_change(
    draft: Path, lab: Lab, key: Ed25519PrivateKey, tmp_path: Path
):
    tool = shutil.which("ssh-keygen") or pytest.skip("needs ssh-keygen (OpenSSH 8.2 or newer), which is not installed")
    signature = sign(draft, "ada", key, lab)
    (tmp_path / "allowed_signers").write_text("".join(f"{s.line()}\n" for s in lab))

    def accepts(content: bytes, who: str = "ada", namespace: str = sshsig.NAMESPACE) -> bool:
        where = ["-f", str(tmp_path / "allowed_signers"), "-s", str(signature)]
        command = [tool, "-Y", "verify", *where, "-I", who, "-n", namespace]
        return subprocess.run(command, input=content, capture_output=True, check=False).returncode == 0

    content = draft.read_bytes()
    assert accepts(content)
    assert not accepts(content + b"\n")
    assert not accepts(content.replace(b"120", b"121"))
    assert not accepts(content, who="bob")
    assert not accepts(content, namespace="git")


def test_a_file_without_a_signature_is_not_valid(draft: Path, lab: Lab):
    result = check(draft, lab)
    assert not result.valid
    assert "carries no signature" in result.sentences()[0]


@pytest.mark.parametrize(
    "change",
    [
        lambda c: c + b"\n",
        lambda c: c + b"\x00",
        lambda c: c[:-1],
        lambda c: c.replace(b"112.5", b"112.6"),
        lambda c: c.replace(b",", b",\r\n"),
        lambda c: b"\xef\xbb\xbf" + c,
        lambda c: b'{"K":[[9,0,0],[0,9,0],[0,0,9]],' + c[1:],  # a double key
        lambda c: b"",
    ],
)
def test_any_change_of_the_file_is_noticed(draft: Path, lab: Lab, key: Ed25519PrivateKey, change: object):
    sign(draft, "ada", key, lab)
    draft.write_bytes(change(draft.read_bytes()))
    assert "does not hold" in objection(draft, lab)


def test_a_stranger_s_key_is_not_valid(draft: Path, lab: Lab, key: Ed25519PrivateKey):
    sign(draft, "ada", key, lab)
    assert "nobody's in the trust list" in objection(draft, lab[1:])
    assert "nobody's in the trust list" in objection(draft, ())


def test_a_trust_list_beside_the_file_is_not_asked(draft: Path, lab: Lab, key: Ed25519PrivateKey):
    sign(draft, "eve", key)
    (draft.parent / "allowed_signers").write_text(lab[0].line() + "\n")
    assert "nobody's in the trust list" in objection(draft, lab[1:])


def test_a_signature_for_another_purpose_is_not_valid(draft: Path, lab: Lab, key: Ed25519PrivateKey):
    (draft.parent / "cal.json.sshsig").write_text(sshsig.sign(draft.read_bytes(), key, namespace="file"))
    assert "made for 'file'" in objection(draft, lab)


def test_revoked_expired_and_otherwise_limited_keys_do_not_count(draft: Path, lab: Lab, key: Ed25519PrivateKey):
    sign(draft, "ada", key, lab)
    assert not verify(draft, lab, frozenset({lab[0].key}), NOW).valid
    assert "only until" in objection(draft, (replace(lab[0], valid_before=datetime(2026, 1, 1, tzinfo=UTC)),))
    assert "only after" in objection(draft, (replace(lab[0], valid_after=datetime(2027, 1, 1, tzinfo=UTC)),))
    assert "trusted for git" in objection(draft, (replace(lab[0], namespaces="git"),))
    assert "certificate authority" in objection(draft, (replace(lab[0], authority=True),))


def test_one_line_that_vouches_is_enough(draft: Path, lab: Lab, key: Ed25519PrivateKey):
    sign(draft, "ada", key, lab)
    expired = replace(lab[0], valid_before=datetime(2026, 1, 1, tzinfo=UTC))
    assert check(draft, (expired, lab[0])).valid


def test_one_bad_signature_of_two_is_enough_to_refuse(
    draft: Path, lab: Lab, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey
):
    sign(draft, "ada", key, lab)
    second = sign(draft, "bob", other_key, lab)
    second.write_text(sshsig.sign(b"something else", other_key))
    assert objection(draft, lab) == "None; does not hold: the file is not the one that was signed"


def test_a_first_signature_that_was_taken_away_is_missed(
    draft: Path, lab: Lab, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey
):
    first = sign(draft, "ada", key, lab)
    sign(draft, "bob", other_key, lab)
    first.unlink()
    assert "is missing" in objection(draft, lab)


def test_nobody_signs_twice(draft: Path, lab: Lab, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey):
    sign(draft, "ada", key, lab)
    with pytest.raises(InputError, match="ada has signed it already"):
        sign(draft, "ada", key, lab)
    ada_again = own_line("ada", lab[1].key)  # a second key of the same person
    with pytest.raises(InputError, match="ada has signed it already"):
        sign(draft, "ada", other_key, (lab[0], ada_again))
    assert len(signature_files(draft)) == 1


def test_a_copied_signature_is_no_second_person(draft: Path, lab: Lab, key: Ed25519PrivateKey):
    first = sign(draft, "ada", key, lab)
    shutil.copy(first, draft.parent / "cal.json.2.sshsig")
    assert "repeats the signature of ada" in objection(draft, lab)


def test_a_second_person_does_not_sign_below_a_broken_signature(
    draft: Path, lab: Lab, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey
):
    sign(draft, "ada", key, lab)
    draft.write_bytes(draft.read_bytes().replace(b"112.5", b"112.6"))
    with pytest.raises(InputError, match="nothing was signed"):
        sign(draft, "bob", other_key, lab)


def test_only_a_calibration_is_signed(tmp_path: Path, key: Ed25519PrivateKey):
    path = tmp_path / "note.json"
    path.write_text("{}")
    with pytest.raises(InputError):
        sign(path, "ada", key)
    assert list(tmp_path.iterdir()) == [path]


def test_a_trusted_signature_of_something_else_is_wrong_input(tmp_path: Path, lab: Lab, key: Ed25519PrivateKey):
    path = tmp_path / "note.json"
    path.write_text("{}")
    (tmp_path / "note.json.sshsig").write_text(sshsig.sign(b"{}", key))
    with pytest.raises(InputError, match="field required"):
        check(path, lab)


@pytest.mark.parametrize("content", [b"", b"\xff", b"-----BEGIN SSH SIGNATURE-----", b"x" * 20_000])
def test_a_broken_signature_file_does_not_hold(draft: Path, lab: Lab, content: bytes):
    (draft.parent / "cal.json.sshsig").write_bytes(content)
    assert objection(draft, lab)


def test_the_run_is_checked_by_its_digest(draft: Path, lab: Lab, key: Ed25519PrivateKey):
    sign(draft, "ada", key, lab)
    assert check(draft, lab, run_sha256="ab" * 32).valid
    other = check(draft, lab, run_sha256="cd" * 32)
    assert not other.valid
    assert "not made from the run" in " ".join(other.sentences())


def test_a_link_is_verified_by_what_it_points_at(draft: Path, lab: Lab, key: Ed25519PrivateKey, tmp_path: Path):
    link = tmp_path / "link.json"
    link.symlink_to(draft)
    sign(link, "ada", key, lab)
    assert (tmp_path / "link.json.sshsig").exists()
    assert check(link, lab).valid
    draft.write_bytes(draft.read_bytes() + b" ")
    assert not check(link, lab).valid


def test_approving_through_a_link_keeps_the_link(draft: Path, tmp_path: Path):
    link = tmp_path / "link.json"
    link.symlink_to(draft)
    approve(link, "bob")
    assert link.is_symlink()
    assert read_calibration(draft).approvers == ("bob",)


def test_a_signature_never_writes_through_a_link(draft: Path, lab: Lab, key: Ed25519PrivateKey, tmp_path: Path):
    victim = tmp_path / "victim"
    victim.write_text("precious")
    (draft.parent / "cal.json.sshsig").symlink_to(victim)
    with pytest.raises(InputError):
        sign(draft, "ada", key, lab)
    assert victim.read_text() == "precious"


def test_an_unapproved_signed_file_is_provisional(draft: Path, lab: Lab, key: Ed25519PrivateKey):
    sign(draft, "ada", key, lab)
    result = check(draft, lab)
    assert result.valid
    assert "PROVISIONAL: no approver is named." in result.sentences()
    assert "SIMULATED" in result.sentences()[-1]


def test_the_operator_cannot_approve_nor_anybody_twice(draft: Path):
    with pytest.raises(InputError, match="is the operator"):
        approve(draft, "grace  HÄBERLI")
    approve(draft, " Bob  Baker ")
    assert read_calibration(draft).approvers == ("Bob Baker",)
    with pytest.raises(InputError, match="approved it already"):
        approve(draft, "bob baker")
    with pytest.raises(InputError, match="no name"):
        approve(draft, "  ")


@pytest.mark.parametrize("name", ["grace.häberli", "Grace-Häberli", "GRACE_HÄBERLI", "grace.häberli@lab"])
def test_the_operator_cannot_approve_in_another_spelling(draft: Path, name: str):
    with pytest.raises(InputError, match="is the operator, Grace Häberli"):
        approve(draft, name)
    assert read_calibration(draft).approvers == ()


def test_an_approver_who_is_the_operator_in_another_spelling_leaves_it_provisional(
    draft: Path, lab: Lab, other_key: Ed25519PrivateKey
):
    approve(draft, "bob")
    draft.write_bytes(draft.read_bytes().replace("Grace Häberli".encode(), b"B.O.B"))  # as another tool may write it
    sign(draft, "bob", other_key, lab)
    assert check(draft, lab).valid
    assert check(draft, lab).provisional == "named as approver, but is the operator: bob"


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        ("J. Doe", "j.doe", True),
        ("J. Doe", "J Doe", True),
        ("J. Doe", "jdoe@lab", True),
        ("j.doe@bern", "j.doe@zurich", False),
        ("J. Doe", "J. Dow", False),
        ("ada", "ad.a+2", False),
        ("", " .", False),
        ("ada", "\N{CYRILLIC SMALL LETTER A}d\N{CYRILLIC SMALL LETTER A}", True),
        ("Beta Ore", "\N{GREEK CAPITAL LETTER BETA}eta \N{CYRILLIC CAPITAL LETTER O}re", True),
        ("ada", "a\N{ZERO WIDTH SPACE}da", True),
        ("Grace Häberli", "grace.haberli", True),
        ("Grace Häberli", "grace.haeberli", True),
        ("Søren", "soren", True),
        ("bob.keller", "bob.ke11er", True),
        ("Bo Otto", "b0.0tt0", True),
        ("bill.lee", "biIl.lee", True),
        ("McIver", "mciver", True),
        ("ada", "\N{LATIN SMALL LETTER ALPHA}da", True),
        ("Ole", "\N{ARMENIAN CAPITAL LETTER OH}le", True),
        ("ali", "all", False),
        ("operator1", "operator2", False),
        ("Anna", "Anno", False),
        ("Sean O'Brien", "sean.obrien", True),
        ("Sean O\N{RIGHT SINGLE QUOTATION MARK}Brien", "sean.obrien", True),
        ("Sean O\N{MODIFIER LETTER APOSTROPHE}Brien", "sean.obrien", True),
        ("Doe, J.", "jdoe", True),
        ("Doe, Mary Ann", "mary.ann.doe", True),
        ("Dr. J. Doe", "j.doe", True),
        ("Dr.", "Prof.", False),
        ("J. Doe (QA)", "j.roe", False),
        ("Jane Doe", "j.doe", False),
    ],
)
def test_spelling_makes_no_second_person(one: str, other: str, same: bool):
    assert same_person(one, other) == same_person(other, one) == same


@pytest.mark.parametrize(
    ("one", "other", "perhaps"),
    [
        ("Jane Doe", "j.doe", True),
        ("Jane Doe", "jdoe@lab", True),
        ("Doe, Jane", "j.doe", True),
        ("Jane Mary Doe", "J. M. Doe", True),
        ("Jane Doe", "doe", False),
        ("Jane Doe", "john.doe", False),
        ("Jane Doe", "j.dow", False),
        ("J. Doe", "j.doe", True),
        ("ada", "a", False),
    ],
)
def test_initials_show_no_second_person(one: str, other: str, perhaps: bool):
    assert perhaps_one_person(one, other) == perhaps_one_person(other, one) == perhaps


def test_the_operator_cannot_approve_by_initials(draft: Path):
    with pytest.raises(InputError, match="is the operator, Grace Häberli"):
        approve(draft, "g.haeberli")


def test_two_spellings_of_one_signer_are_one_signature(draft: Path, lab: Lab, key: Ed25519PrivateKey):
    sign(draft, "ada", key, lab)
    second = Ed25519PrivateKey.generate()
    sign(draft, "bea", second, lab)
    twice = (lab[0], own_line("A.da@lab", public_key_blob(second.public_key())))
    assert "repeats the signature of A.da@lab" in objection(draft, twice)


def test_nobody_approves_after_a_signature(draft: Path, lab: Lab, key: Ed25519PrivateKey):
    sign(draft, "ada", key, lab)
    before = draft.read_bytes()
    with pytest.raises(InputError, match="signed already"):
        approve(draft, "bob")
    assert draft.read_bytes() == before


def test_a_key_kept_in_memory_is_good_for_simulated_files_only(
    draft: Path, real_draft: Path, key: Ed25519PrivateKey, tmp_path: Path
):
    with pytest.raises(InputError, match="signs nothing real"):
        sign_simulated(real_draft, tmp_path / "allowed_signers")
    assert not (tmp_path / "allowed_signers").exists()
    sign_simulated(draft, tmp_path / "allowed_signers")
    assert check(draft, read_allowed_signers(tmp_path / "allowed_signers")).valid
    forged = own_line(SIMULATED, sshsig.public_key_blob(key.public_key()))
    sign(real_draft, SIMULATED, key)
    assert "good for simulated files only" in objection(real_draft, (forged,))
