from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate.allowed_signers import Signer, own_line, read_allowed_signers
from labcal.certificate.sshsig import NAMESPACE, public_key_blob
from labcal.errors import InputError

NOW = datetime(2026, 11, 21, 12, 0, tzinfo=UTC)
KEY = "ssh-ed25519 AAAAC3NzaC1lZDI1NTE5AAAAINdamAGCsQq31Uv+08lkBzoO4XLz2qYjJa8CGmj3B1Ea"  # RFC 8032, 7.1, test 1


def read(tmp_path: Path, text: str) -> tuple[Signer, ...]:
    path = tmp_path / "allowed_signers"
    path.write_text(text)
    return read_allowed_signers(path)


def test_a_line_written_is_read_again(tmp_path: Path, key: Ed25519PrivateKey):
    signer = own_line("ada@lab.example", public_key_blob(key.public_key()))
    assert signer.line() == f'ada@lab.example namespaces="{NAMESPACE}" {KEY}'
    dated = Signer(signer.principal, signer.key_type, signer.key, "a,b*", NOW, NOW.replace(year=2027))
    assert read(tmp_path, f"# people\n\n{signer.line()}\n{dated.line()} a comment\n") == (signer, dated)


@pytest.mark.parametrize(
    ("options", "objection"),
    [
        ("", None),
        (f'namespaces="{NAMESPACE}"', None),
        ('namespaces="git,labcal-*"', None),
        ('namespaces="git"', "is trusted for git"),
        ('namespaces="labcal-*,!labcal-calibration"', "is trusted for"),
        ('namespaces="labcal-[c]alibration"', "is trusted for"),
        ('valid-before="20260101"', "only until 2026-01-01"),
        ('valid-before="20270101",valid-after="20250101Z"', None),
        ('valid-after="202611211201Z"', "only after"),
        ('valid-after="20261121115959Z"', None),
        ("cert-authority", "certificate authority"),
        (f'namespaces="{NAMESPACE}",valid-before="20260101"', "only until"),
    ],
)
def test_options_are_honoured(tmp_path: Path, options: str, objection: str | None):
    (signer,) = read(tmp_path, f"ada {options} {KEY}\n")
    if objection is None:
        assert signer.objection(NAMESPACE, NOW) is None
    else:
        assert objection in str(signer.objection(NAMESPACE, NOW))


@pytest.mark.parametrize(
    ("line", "what"),
    [
        (KEY, "person it belongs to"),
        ("ada", "person, options, key type, key"),
        (f"ada\x1b[2J {KEY}", "control character"),
        ("ada ssh-ed25519", "person, options, key type, key"),
        ("ada ssh-ed25519 AAAA", "not whole"),
        (f"ada {KEY[:-4]}", "not whole"),
        (f"ada {KEY.replace('ssh-ed25519', 'ssh-rsa')}", "not whole, or not ssh-rsa"),
        (f"ada no-touch-required {KEY}", "option"),
        (f"ada namespaces {KEY}", "option"),
        (f'ada valid-before="tomorrow" {KEY}', "YYYYMMDD"),
        (f'ada valid-before="20261332" {KEY}', "YYYYMMDD"),
        (f'ada namespaces="git {KEY}', "quotation mark"),
        (f'ada namespaces="git";x {KEY}', "cannot be read"),
    ],
)
def test_a_broken_line_is_named(tmp_path: Path, line: str, what: str):
    with pytest.raises(InputError, match=what) as caught:
        read(tmp_path, f"# one\n{line}\n")
    assert caught.value.line == 2


def test_a_list_that_is_no_text_is_refused(tmp_path: Path):
    (tmp_path / "list").write_bytes(b"\xff\xfe")
    with pytest.raises(InputError, match="UTF-8"):
        read_allowed_signers(tmp_path / "list")
