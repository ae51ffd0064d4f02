from __future__ import annotations

import shutil
import stat
import subprocess
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import keys, pkcs8
from labcal.certificate.allowed_signers import own_line
from labcal.certificate.sshsig import public_key_blob
from labcal.errors import InputError

PASSPHRASE = "correct horse"


@pytest.fixture
def home(tmp_path: Path) -> Path:
    return tmp_path / "home"


def line_of(name: str, key: Ed25519PrivateKey) -> str:
    return own_line(name, public_key_blob(key.public_key())).line() + "\n"


def test_a_key_opens_with_its_passphrase_and_no_other(home: Path):
    signer = keys.new_key(home, "ada@lab.example", "correct horse")
    assert public_key_blob(keys.open_key(home, "ada@lab.example", "correct horse").public_key()) == signer.key
    for wrong in ("correct hors", "", "Correct horse"):
        with pytest.raises(InputError, match="the passphrase is wrong"):
            keys.open_key(home, "ada@lab.example", wrong)


def test_private_keys_are_their_owner_s_alone(home: Path):
    keys.new_key(home, "ada", PASSPHRASE)
    assert stat.S_IMODE((home / "keys").stat().st_mode) == 0o700
    for file in (home / "keys").iterdir():
        assert stat.S_IMODE(file.stat().st_mode) == 0o600, file
    assert b"BEGIN ENCRYPTED PRIVATE KEY" in (home / "keys" / "ada.pem").read_bytes()


def test_a_key_that_others_may_read_is_not_used(home: Path):
    keys.new_key(home, "ada", PASSPHRASE)
    (home / "keys" / "ada.pem").chmod(0o640)
    with pytest.raises(InputError, match="others may read"):
        keys.open_key(home, "ada", PASSPHRASE)


def test_openssl_opens_the_key_file(home: Path):
    openssl = shutil.which("openssl") or pytest.skip("needs openssl, which is not installed")
    signer = keys.new_key(home, "ada", PASSPHRASE)
    command = [
        openssl,
        "pkey",
        "-in",
        str(home / "keys" / "ada.pem"),
        "-passin",
        f"pass:{PASSPHRASE}",
        "-pubout",
        "-outform",
        "DER",
    ]
    public = subprocess.run(command, check=True, capture_output=True).stdout
    assert public[-32:] == signer.key[-32:]
    command[5] = "pass:no"
    assert subprocess.run(command, capture_output=True, check=False).returncode != 0


def test_a_guess_at_the_passphrase_costs_600000_rounds(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.undo()
    openssl = shutil.which("openssl") or pytest.skip("needs openssl, which is not installed")
    pem = pkcs8.locked(Ed25519PrivateKey.generate(), PASSPHRASE)
    told = subprocess.run([openssl, "asn1parse"], input=pem, check=True, capture_output=True).stdout
    assert f":{600_000:06X}".encode() in told


def test_damage_to_a_key_file_is_one_sentence(home: Path):
    keys.new_key(home, "ada", PASSPHRASE)
    file = home / "keys" / "ada.pem"
    whole = file.read_bytes()
    for broken in (b"", whole[:100], whole.replace(b"A", b"B"), whole.replace(b"ENCRYPTED ", b""), b"\xff" * 300):
        file.write_bytes(broken)
        with pytest.raises(InputError) as caught:
            keys.open_key(home, "ada", PASSPHRASE)
        assert str(file) in str(caught.value)


@pytest.mark.parametrize(
    ("passphrase", "why"),
    [
        ("", "empty"),
        ("too short", "has 9 characters and needs 10"),
        ("magnetometer", "a common word alone"),
        ("Magnetometer!", "a common word alone"),
        ("Passw0rd-2026", "a common word alone"),
        ("p4$$w0rd p4$$w0rd", "a common word alone"),
        ("labcal labcal", "a common word alone"),
        ("12345678901", "a row of the keyboard"),
        ("abcdefghijkl", "a row of the keyboard"),
        ("qwertzuiop", "a row of the keyboard"),
        ("0000000000", "over and over"),
        ("abababababab", "over and over"),
        ("ada.lovelace@lab", "the name of the key's own person"),
        ("Ada-Lovelace-1815", "the name of the key's own person"),
    ],
)
def test_a_passphrase_that_is_guessed_first_makes_nothing(home: Path, passphrase: str, why: str):
    with pytest.raises(InputError, match=why):
        keys.new_key(home, "ada.lovelace@lab", passphrase)
    assert not home.exists()


@pytest.mark.parametrize("passphrase", ["correct horse", "magnetometer on fire", "Zürich 47° N", "x7#kQ9!vB2"])
def test_a_passphrase_of_more_than_one_word_is_taken(home: Path, passphrase: str):
    keys.new_key(home, "ada", passphrase)
    keys.open_key(home, "ada", passphrase)


def test_a_key_of_before_opens_with_its_short_passphrase(home: Path):
    keys.new_key(home, "ada", PASSPHRASE)
    key = Ed25519PrivateKey.generate()
    (home / "keys" / "ada.pem").write_bytes(pkcs8.locked(key, "pw"))
    assert public_key_blob(keys.open_key(home, "ada", "pw").public_key()) == public_key_blob(key.public_key())


def test_a_key_is_never_replaced(home: Path):
    keys.new_key(home, "ada", PASSPHRASE)
    before = (home / "keys" / "ada.pem").read_bytes()
    with pytest.raises(InputError, match="has a key already"):
        keys.new_key(home, "ada", "wrong horse battery")
    assert (home / "keys" / "ada.pem").read_bytes() == before


@pytest.mark.parametrize("name", ["", "../ada", "a b", "*", "!ada", "a,b", "ada\n", "-x", "simulated", "x" * 65, "Ä"])
def test_names_that_could_be_a_path_or_a_pattern_are_refused(home: Path, name: str):
    with pytest.raises(InputError):
        keys.new_key(home, name, PASSPHRASE)
    with pytest.raises(InputError):
        keys.open_key(home, name, PASSPHRASE)
    assert not home.exists()


def test_trust_adds_what_another_lab_printed_once(home: Path, tmp_path: Path, key: Ed25519PrivateKey):
    keys.new_key(home, "ada", PASSPHRASE)
    given = tmp_path / "given"
    given.write_text("# from the other lab\n" + line_of("bob", key))
    assert [s.principal for s in keys.trust(home, given)] == ["bob"]
    assert keys.trust(home, given) == ()
    assert [s.principal for s in keys.trusted(home)] == ["ada", "bob"]
    assert [(e.signer.principal, e.private_key_here) for e in keys.entries(home)] == [("ada", True), ("bob", False)]


def test_trust_is_for_calibrations_alone(home: Path, tmp_path: Path, key: Ed25519PrivateKey):
    given = tmp_path / "given"
    given.write_text(line_of("bob", key).replace('namespaces="labcal-calibration" ', ""))
    (signer,) = keys.trust(home, given)
    assert signer.namespaces == "labcal-calibration"


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        ("bob ", "* ", "cannot name a person"),
        ("bob ", "bob,eve ", "cannot name a person"),
        ("bob ", "simulated ", "kept for keys of simulated runs"),
        ("bob ", "bob cert-authority,", "option|plain"),
        ("labcal-calibration", "git", "is for git"),
    ],
)
def test_trust_refuses_all_lines_when_one_is_wrong(
    home: Path, tmp_path: Path, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey, old: str, new: str, what: str
):
    given = tmp_path / "given"
    given.write_text(line_of("carol", other_key) + line_of("bob", key).replace(old, new))
    with pytest.raises(InputError, match=what):
        keys.trust(home, given)
    assert keys.trusted(home) == ()


def test_one_key_cannot_be_two_persons(home: Path, tmp_path: Path, key: Ed25519PrivateKey):
    given = tmp_path / "given"
    given.write_text(line_of("bob", key) + line_of("eve", key))
    with pytest.raises(InputError, match="the key of eve is bob's already"):
        keys.trust(home, given)


def test_a_private_key_is_no_trust_list(home: Path, tmp_path: Path):
    keys.new_key(home, "ada", PASSPHRASE)
    with pytest.raises(InputError):
        keys.trust(home, home / "keys" / "ada.pem")


def test_revoked_keys_stay_revoked(home: Path):
    signer = keys.new_key(home, "ada", PASSPHRASE)
    assert keys.revoke(home, "ada") == 1
    assert keys.revoked(home) == {signer.key}
    assert keys.entries(home)[0].revoked
    with pytest.raises(InputError, match="revoked already"):
        keys.revoke(home, "ada")


def test_a_damaged_revocation_list_is_not_passed_over(home: Path):
    keys.new_key(home, "ada", PASSPHRASE)
    (home / "keys" / "revoked_keys").write_text("# lost\nssh-ed25519 ???\n")
    with pytest.raises(InputError, match="line 2"):
        keys.revoked(home)


def test_a_lost_key_is_revoked_and_another_made(home: Path):
    first = keys.new_key(home, "ada", "long forgotten")
    with pytest.raises(InputError, match="labcal keys revoke ada"):
        keys.new_key(home, "ada", "a newer one")
    keys.revoke(home, "ada")
    second = keys.new_key(home, "ada", "a newer one")
    assert public_key_blob(keys.open_key(home, "ada", "a newer one").public_key()) == second.key
    assert first.key in keys.revoked(home)
    assert second.key not in keys.revoked(home)
    assert [signer.key for signer in keys.trusted(home)] == [first.key, second.key]


def test_another_spelling_makes_no_second_person(home: Path, tmp_path: Path, key: Ed25519PrivateKey):
    keys.new_key(home, "j.doe", PASSPHRASE)
    with pytest.raises(InputError, match="two spellings of one name"):
        keys.new_key(home, "JDoe@lab", PASSPHRASE)
    (tmp_path / "list").write_text(line_of("J.Doe", key))
    with pytest.raises(InputError, match="two spellings of one name"):
        keys.trust(home, tmp_path / "list")


def test_a_list_of_nobody_is_refused_even_where_others_are_trusted(home: Path, tmp_path: Path):
    keys.new_key(home, "ada", PASSPHRASE)
    (tmp_path / "list").write_text("# nobody\n")
    with pytest.raises(InputError, match="nobody's key"):
        keys.trust(home, tmp_path / "list")


def test_a_passphrase_may_hold_bytes_that_are_no_text(home: Path):
    keys.new_key(home, "ada", "correct \udcff horse")
    keys.open_key(home, "ada", "correct \udcff horse")
