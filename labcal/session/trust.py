"""Whose signatures this lab accepts, and the keys of its own people."""

from __future__ import annotations

from collections.abc import Collection
from datetime import datetime
from pathlib import Path

from labcal import certificate
from labcal.certificate import KeyEntry, Signer
from labcal.certificate.allowed_signers import NEVER
from labcal.certificate.sshsig import fingerprint
from labcal.errors import InputError
from labcal.files.home import home
from labcal.session.audited import note


def new_key(name: str, passphrase: str) -> Signer:
    """Make a private key for `name` under `passphrase`, and trust its public half."""
    made = certificate.keys.new_key(home(), name, passphrase)
    note("key", person=name, key=fingerprint(made.key))
    return made


def trusted_keys() -> tuple[KeyEntry, ...]:
    """Everybody in the lab's trust list. Raises InputError where who administers it has not signed it."""
    return certificate.keys.entries(home())


def listed_keys() -> tuple[tuple[KeyEntry, ...], str | None]:
    """Everybody in the trust list to be looked at, and why nobody of them is trusted, where that is so."""
    try:
        return trusted_keys(), None
    except InputError as error:
        return certificate.keys.entries(home(), only_listed=True), error.what


def asks_passphrase(name: str) -> bool:
    """Whether `name` signs by a key that lies here; else an SSH agent does, which asks by itself."""
    return certificate.keys.has_private_key(home(), name)


def sign_trust_list(name: str, passphrase: str) -> int:
    """Sign the trust list as who administers it; the first who does so is the administrator. Returns its lines."""
    key = certificate.keys.signing_key(home(), name, passphrase)
    return certificate.keys.sign_list(home(), name, key)


def handed_out() -> tuple[Signer, ...]:
    """The lab's trust list as it leaves the lab: who is revoked is in it, and says so."""
    return tuple(entry.to_hand_out() for entry in trusted_keys())


def trust_keys(allowed_signers: Path, roles: Collection[str] = ()) -> tuple[Signer, ...]:
    """Take the lines of an allowed_signers file into the lab's trust list, with `roles`; returns what that changed."""
    changed = certificate.keys.trust(home(), allowed_signers, roles)
    for signer in changed:
        note("trust", person=signer.principal, key=fingerprint(signer.key))
    return changed


def revoke_keys(name: str, since: datetime | None = None) -> int:
    """Accept no signature by the keys of `name`, but what is shown to be from before `since`; returns how many keys."""
    revoked = certificate.keys.revoke(home(), name, since or NEVER)
    note("revoke", person=name, keys=str(revoked))
    return revoked
