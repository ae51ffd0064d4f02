"""A time that is shown: a token of a time-stamping authority beside the signature, made here by `openssl ts`."""

from __future__ import annotations

import shutil
import subprocess
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from labcal import session
from labcal.files.home import home

PASSPHRASE = "correct horse"
CONFIG = """
[req]
distinguished_name = dn
[dn]
[tsa_cert]
basicConstraints = critical,CA:FALSE
keyUsage = critical,digitalSignature
extendedKeyUsage = critical,timeStamping
[tsa]
default_tsa = here
[here]
serial = {folder}/serial
signer_cert = {folder}/ca.pem
certs = {folder}/ca.pem
signer_key = {folder}/ca.key
signer_digest = sha256
default_policy = 1.2.3.4.1
digests = sha256, sha512
accuracy = secs:1
"""


def authority(folder: Path) -> Path:
    """A time-stamping authority of its own in `folder`."""
    openssl = shutil.which("openssl") or pytest.skip("needs openssl, which is not installed")
    folder.mkdir()
    (folder / "ts.cnf").write_text(CONFIG.format(folder=folder))
    (folder / "serial").write_text("01\n")
    new = [
        "req",
        "-x509",
        "-newkey",
        "rsa:2048",
        "-nodes",
        "-subj",
        "/CN=time",
        "-days",
        "30",
        "-extensions",
        "tsa_cert",
    ]
    where = ["-config", str(folder / "ts.cnf"), "-keyout", str(folder / "ca.key"), "-out", str(folder / "ca.pem")]
    subprocess.run([openssl, *new, *where], check=True, capture_output=True)
    return folder


def stamp(signature: Path, by: Path, of: bytes | None = None) -> None:
    """A token for the signature file beside it, or for other bytes."""
    data = by / "data"
    data.write_bytes(signature.read_bytes() if of is None else of)
    query, reply = by / "query", signature.with_name(f"{signature.name}.tsr")
    ask = ["openssl", "ts", "-query", "-data", str(data), "-sha256", "-cert", "-out", str(query)]
    answer = ["openssl", "ts", "-reply", "-queryfile", str(query), "-config", str(by / "ts.cnf"), "-out", str(reply)]
    for command in (ask, answer):
        subprocess.run(command, check=True, capture_output=True)


def day(days: int) -> datetime:
    return datetime.now(UTC) + timedelta(days=days)


def test_what_a_trusted_authority_stamped_before_outlives_its_key(draft: Path, tmp_path: Path):
    ours, theirs = authority(tmp_path / "ours"), authority(tmp_path / "theirs")
    session.new_key("ada", PASSPHRASE)
    signature = session.sign(draft, "ada", PASSPHRASE)
    session.revoke_keys("ada", day(1).replace(hour=0))  # as seen from the day after
    shutil.copy(ours / "ca.pem", home() / "keys" / "timestamp_ca.pem")

    def shown() -> datetime | None:
        return session.verify(draft).checks[0].shown_utc

    assert shown() is None
    stamp(signature, ours)
    seen = shown()
    assert seen is not None
    assert abs(seen - day(0)) < timedelta(minutes=30)
    for forge in (
        lambda: stamp(signature, theirs),  # an authority that nobody trusts
        lambda: stamp(signature, ours, b"another signature"),
        lambda: signature.with_name(f"{signature.name}.tsr").write_bytes(b"\x30\x03no"),
    ):
        forge()
        assert shown() is None


def test_the_shown_time_decides_and_not_the_clock(draft: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    ours = authority(tmp_path / "ours")
    session.new_key("ada", PASSPHRASE)
    signature = session.sign(draft, "ada", PASSPHRASE)
    shutil.copy(ours / "ca.pem", home() / "keys" / "timestamp_ca.pem")
    stamp(signature, ours)
    session.revoke_keys("ada", day(1))
    monkeypatch.setattr("labcal.session.signing.datetime", Later)
    assert session.verify(draft).valid
    (tmp_path / "given").mkdir()
    session.hand_out(draft, tmp_path / "given")
    assert (tmp_path / "given" / f"{signature.name}.tsr").exists()
    signature.with_name(f"{signature.name}.tsr").unlink()
    assert "is revoked from" in str(session.verify(draft).checks[0].objection)
    session.new_key("ada", PASSPHRASE)


class Later(datetime):
    """A clock two days on."""

    @classmethod
    def now(cls, tz: object = None) -> datetime:
        """Two days from now."""
        return day(2)
