from __future__ import annotations

import base64
import shutil
import subprocess
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat, PublicFormat

from labcal.certificate.sshsig import NAMESPACE, BadSignature, fingerprint, parse, public_key_blob, sign

CONTENT = b'{"format":"labcal-calibration/1"}'


@pytest.fixture(scope="module")
def ssh_keygen() -> str:
    return shutil.which("ssh-keygen") or pytest.skip("needs ssh-keygen (OpenSSH 8.2 or newer), which is not installed")


def private_file(key: Ed25519PrivateKey, folder: Path) -> Path:
    path = folder / "id"
    path.write_bytes(key.private_bytes(Encoding.PEM, PrivateFormat.OpenSSH, NoEncryption()))
    path.chmod(0o600)
    return path


def test_a_signature_is_byte_for_byte_what_ssh_keygen_makes(key: Ed25519PrivateKey, tmp_path: Path, ssh_keygen: str):
    content = tmp_path / "cal.json"
    content.write_bytes(CONTENT)
    command = [ssh_keygen, "-Y", "sign", "-f", str(private_file(key, tmp_path)), "-n", NAMESPACE, str(content)]
    subprocess.run(command, check=True, capture_output=True)
    assert (tmp_path / "cal.json.sig").read_text() == sign(CONTENT, key)


def test_ssh_keygen_s_sha256_signature_is_read_too(key: Ed25519PrivateKey, tmp_path: Path, ssh_keygen: str):
    command = [ssh_keygen, "-Y", "sign", "-O", "hashalg=sha256", "-f", str(private_file(key, tmp_path))]
    made = subprocess.run([*command, "-n", NAMESPACE], input=CONTENT, check=True, capture_output=True).stdout
    assert parse(made).hash_name == "sha256"
    parse(made).check(CONTENT)


def test_fingerprint_is_ssh_keygen_s(key: Ed25519PrivateKey, tmp_path: Path, ssh_keygen: str):
    public = tmp_path / "id.pub"
    public.write_bytes(key.public_key().public_bytes(Encoding.OpenSSH, PublicFormat.OpenSSH))
    told = subprocess.run([ssh_keygen, "-l", "-f", str(public)], check=True, capture_output=True, text=True).stdout
    assert fingerprint(public_key_blob(key.public_key())) in told


def test_what_was_signed_holds_and_every_changed_byte_is_noticed(key: Ed25519PrivateKey):
    signature = parse(sign(CONTENT, key).encode())
    signature.check(CONTENT)
    assert signature.public_key == public_key_blob(key.public_key())
    for place in range(len(CONTENT)):
        changed = CONTENT[:place] + bytes([CONTENT[place] ^ 1]) + CONTENT[place + 1 :]
        with pytest.raises(BadSignature, match="does not hold"):
            signature.check(changed)


@pytest.mark.parametrize("changed", [CONTENT + b"\n", CONTENT[:-1], CONTENT.replace(b":", b": "), b"", CONTENT * 2])
def test_added_and_missing_bytes_are_noticed(key: Ed25519PrivateKey, changed: bytes):
    with pytest.raises(BadSignature):
        parse(sign(CONTENT, key).encode()).check(changed)


def test_a_signature_for_another_purpose_does_not_hold(key: Ed25519PrivateKey):
    with pytest.raises(BadSignature, match="made for 'git'"):
        parse(sign(CONTENT, key, namespace="git").encode()).check(CONTENT)


def test_no_changed_bit_of_a_signature_holds(key: Ed25519PrivateKey):
    body = b"".join(sign(CONTENT, key).encode().splitlines()[1:-1])
    blob = base64.b64decode(body)
    for place in range(len(blob)):
        broken = base64.encodebytes(blob[:place] + bytes([blob[place] ^ 0x10]) + blob[place + 1 :])
        with pytest.raises(BadSignature):
            parse(b"-----BEGIN SSH SIGNATURE-----\n" + broken + b"-----END SSH SIGNATURE-----\n").check(CONTENT)


def test_no_truncated_armour_is_read(key: Ed25519PrivateKey):
    whole = sign(CONTENT, key).encode()
    for length in range(len(whole) - 1):
        with pytest.raises(BadSignature):
            parse(whole[:length])


def test_bytes_after_the_signature_are_refused(key: Ed25519PrivateKey):
    blob = base64.b64decode(b"".join(sign(CONTENT, key).encode().splitlines()[1:-1]))
    longer = b"-----BEGIN SSH SIGNATURE-----\n" + base64.encodebytes(blob + b"x") + b"-----END SSH SIGNATURE-----\n"
    for more in (longer, sign(CONTENT, key).encode() * 2, sign(CONTENT, key).encode() + b"more"):
        with pytest.raises(BadSignature):
            parse(more)
