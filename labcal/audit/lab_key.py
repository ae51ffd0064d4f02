"""The lab's own key. It signs the audit log and nothing else, and is used without a passphrase: nobody is asked."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from cryptography.exceptions import UnsupportedAlgorithm
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey, Ed25519PublicKey
from cryptography.hazmat.primitives.serialization import (
    Encoding,
    NoEncryption,
    PrivateFormat,
    PublicFormat,
    load_pem_private_key,
    load_ssh_public_key,
)

from labcal.errors import InputError
from labcal.files import atomic
from labcal.files.home import FILE

NAME = "lab-key.pem"


def made(folder: Path) -> Ed25519PrivateKey:
    """A new key, kept in `folder` for this user alone (0600)."""
    key = Ed25519PrivateKey.generate()
    content = key.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, NoEncryption())
    atomic.write_bytes(folder / NAME, content, FILE)
    return key


def kept(folder: Path) -> Ed25519PrivateKey | None:
    """The key that is kept in `folder`; None where none is. Raises InputError: others may read it, or it is no key."""
    path = folder / NAME
    if not path.exists():
        return None
    if os.name == "posix" and (mode := stat.S_IMODE(path.stat().st_mode)) & 0o077:
        raise InputError(f"others may read the lab's key (mode {mode:o}); it is not used until `chmod 600`", file=path)
    try:
        key = load_pem_private_key(path.read_bytes(), None)
    except (ValueError, TypeError, UnsupportedAlgorithm):
        key = None
    if not isinstance(key, Ed25519PrivateKey):
        raise InputError("is not the lab's key: no Ed25519 key in PEM without a passphrase", file=path)
    return key


def public_text(key: Ed25519PublicKey) -> str:
    """The public half as OpenSSH writes it."""
    return key.public_bytes(Encoding.OpenSSH, PublicFormat.OpenSSH).decode()


def from_public_text(text: str) -> Ed25519PublicKey:
    """The public key that `text` states. Raises ValueError."""
    try:
        key = load_ssh_public_key(text.encode())
    except UnsupportedAlgorithm as error:
        raise ValueError(str(error)) from None
    if not isinstance(key, Ed25519PublicKey):
        raise ValueError("no Ed25519 key")
    return key
