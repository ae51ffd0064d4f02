"""Whose signatures this lab accepts, and the keys of its own people."""

from __future__ import annotations

from pathlib import Path

from labcal import certificate
from labcal.certificate import Entry, Signer
from labcal.certificate.sshsig import fingerprint
from labcal.files.home import home
from labcal.session.audited import note


def new_key(name: str, passphrase: str) -> Signer:
    """Make a private key for `name` under `passphrase`, and trust its public half."""
    made = certificate.keys.new_key(home(), name, passphrase)
    note("key", person=name, key=fingerprint(made.key))
    return made


def trusted_keys() -> tuple[Entry, ...]:
    """Everybody in the lab's trust list."""
    return certificate.keys.entries(home())


def trust_keys(allowed_signers: Path) -> tuple[Signer, ...]:
    """Take the lines of an allowed_signers file into the lab's trust list; returns the new ones."""
    new_ones = certificate.keys.trust(home(), allowed_signers)
    for signer in new_ones:
        note("trust", person=signer.principal, key=fingerprint(signer.key))
    return new_ones


def revoke_keys(name: str) -> int:
    """Accept no signature any more by the keys of `name`; returns how many keys those are."""
    revoked = certificate.keys.revoke(home(), name)
    note("revoke", person=name, keys=str(revoked))
    return revoked
