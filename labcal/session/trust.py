"""Whose signatures this lab accepts, and the keys of its own people."""

from __future__ import annotations

from pathlib import Path

from labcal import certificate
from labcal.certificate import Entry, Signer
from labcal.files.home import home


def new_key(name: str, passphrase: str) -> Signer:
    """Make a private key for `name` under `passphrase`, and trust its public half."""
    return certificate.keys.new_key(home(), name, passphrase)


def trusted_keys() -> tuple[Entry, ...]:
    """Everybody in the lab's trust list."""
    return certificate.keys.entries(home())


def trust_keys(allowed_signers: Path) -> tuple[Signer, ...]:
    """Take the lines of an allowed_signers file into the lab's trust list; returns the new ones."""
    return certificate.keys.trust(home(), allowed_signers)


def revoke_keys(name: str) -> int:
    """Accept no signature any more by the keys of `name`; returns how many keys those are."""
    return certificate.keys.revoke(home(), name)
