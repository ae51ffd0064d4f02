"""The lab's keys: private ones under a passphrase, the trust list, and the keys that are trusted no more.

All lie in `HOME/keys`, a folder only its owner may enter: `PRINCIPAL.pem`, `allowed_signers`, `revoked_keys`
(one public key a line, as `ssh-keygen -r` reads it). A passphrase is never kept.
"""

from __future__ import annotations

import base64
import os
import stat
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import pkcs8
from labcal.certificate.allowed_signers import (
    Signer,
    check_principal,
    own_line,
    read_allowed_signers,
    to_trust,
)
from labcal.certificate.calibration_file import read_limited
from labcal.certificate.sshsig import KEY_TYPE, public_key_blob
from labcal.errors import InputError
from labcal.files import atomic
from labcal.files.home import own_folder
from labcal.record.person import same_person

SIMULATED = "simulated"  # the principal of keys made in memory: good for files that say simulated, and for no other


@dataclass(frozen=True, slots=True)
class Entry:
    """One line of `labcal keys list`."""

    signer: Signer
    private_key_here: bool
    revoked: bool


def new_key(home: Path, name: str, passphrase: str) -> Signer:
    """Make an Ed25519 key for `name`, lock it with `passphrase`, and trust it. Raises InputError.

    A key takes the place of a revoked one of the same person, and of no other.
    """
    _check_name(name)
    if not passphrase:
        raise InputError("the passphrase is empty; nothing was made")
    path, known, gone = _private(home, name), trusted(home), revoked(home)
    _check_spelling(name, known, trust_list(home))
    keys = {signer.key for signer in known if signer.principal == name}
    if path.exists() and not (keys and keys <= gone):
        told = f"{name} has a key already; a second one would replace it (`labcal keys revoke {name}` where it is lost)"
        raise InputError(told, file=path)
    if keys - gone:
        raise InputError(f"{name} is trusted already with a key made elsewhere", file=trust_list(home))
    key = Ed25519PrivateKey.generate()
    signer = own_line(name, public_key_blob(key.public_key()))
    _keep(path, pkcs8.locked(key, passphrase))
    _add(home, [signer])
    return signer


def open_key(home: Path, name: str, passphrase: str) -> Ed25519PrivateKey:
    """The private key of `name`. Raises InputError: no such key, others may read it, or a wrong passphrase."""
    _check_name(name)
    path = _private(home, name)
    if not path.exists():
        raise InputError(f"there is no key for {name} here; `labcal keys new --name {name}` makes one", file=path)
    if os.name == "posix" and (mode := stat.S_IMODE(path.stat().st_mode)) & 0o077:
        raise InputError(f"others may read this key (mode {mode:o}); it is not used until `chmod 600`", file=path)
    try:
        return pkcs8.unlocked(read_limited(path, 2**16), passphrase)
    except ValueError as error:
        raise InputError(str(error), file=path) from None


def trust_list(home: Path) -> Path:
    """Where the lab's trust list lies; it need not exist yet."""
    return home / "keys" / "allowed_signers"


def trusted(home: Path) -> tuple[Signer, ...]:
    """Every line of the lab's trust list, in order. Raises InputError."""
    return read_allowed_signers(path) if (path := trust_list(home)).exists() else ()


def trust(home: Path, file: Path) -> tuple[Signer, ...]:
    """Add the lines of the allowed_signers file `file` to the lab's list, all or none; returns those that were new.

    Raises InputError: a line that is not one person's Ed25519 key for calibrations, or a key that is another
    person's already (two names for one key would let one person sign twice).
    """
    known, new = list(trusted(home)), list[Signer]()
    if not (lines := read_allowed_signers(file)):
        raise InputError("holds nobody's key", file=file)
    for stated in lines:
        try:
            signer = to_trust(stated)
            _check_name(signer.principal)
        except ValueError as error:
            raise InputError(str(error), file=file) from None
        _check_spelling(signer.principal, known, file)
        if owner := next((s.principal for s in known if s.key == signer.key and s.principal != signer.principal), None):
            raise InputError(f"the key of {signer.principal} is {owner}'s already", file=file)
        if signer not in known:
            known.append(signer)
            new.append(signer)
    _add(home, new)
    return tuple(new)


def revoke(home: Path, name: str) -> int:
    """Never again accept a signature by any key `name` is trusted with now; returns how many. Raises InputError."""
    keys = {s.key for s in trusted(home) if s.principal == name} - revoked(home)
    if not keys:
        raise InputError(f"{name} is not in the trust list, or revoked already", file=trust_list(home))
    lines = [f"{KEY_TYPE} {base64.b64encode(key).decode()} {name}" for key in sorted(keys)]
    _append(home / "keys" / "revoked_keys", lines)
    return len(keys)


def revoked(home: Path) -> frozenset[bytes]:
    """The keys that are trusted no more, in SSH wire format. Raises InputError with file and line."""
    path = home / "keys" / "revoked_keys"
    if not path.exists():
        return frozenset()
    keys = set()
    for number, line in enumerate(read_limited(path, 2**20).decode(errors="replace").splitlines(), start=1):
        if words := line.partition("#")[0].split():
            try:
                keys.add(base64.b64decode(words[1], validate=True))
            except (IndexError, ValueError):
                raise InputError("is not: key type, key", file=path, line=number) from None
    return frozenset(keys)


def entries(home: Path) -> tuple[Entry, ...]:
    """Everybody in the trust list, whether their private key is here, and whether they are revoked."""
    gone = revoked(home)
    return tuple(Entry(s, _private(home, s.principal).exists(), s.key in gone) for s in trusted(home))


def names(home: Path) -> frozenset[str]:
    """Everybody who has a key in the trust list that is not revoked."""
    gone = revoked(home)
    return frozenset(signer.principal for signer in trusted(home) if signer.key not in gone)


def _check_name(name: str) -> None:
    try:
        check_principal(name)
    except ValueError as error:
        raise InputError(str(error)) from None
    if name.lower() == SIMULATED:
        raise InputError(f"the name {SIMULATED!r} is kept for keys of simulated runs")


def _check_spelling(name: str, known: Iterable[Signer], file: Path) -> None:
    """Refuse a name that another person's differs from by its spelling alone: it would pass one person off as two."""
    for other in known:
        if other.principal != name and same_person(other.principal, name):
            told = f"{name} and {other.principal}, who is trusted, are two spellings of one name; name them apart"
            raise InputError(told, file=file)


def _private(home: Path, name: str) -> Path:
    return home / "keys" / f"{name}.pem"


def _add(home: Path, signers: list[Signer]) -> None:
    _append(trust_list(home), [signer.line() for signer in signers])


def _append(path: Path, lines: list[str]) -> None:
    before = path.read_text(encoding="utf-8") if path.exists() else ""
    if before and not before.endswith("\n"):
        before += "\n"
    _keep(path, (before + "".join(f"{line}\n" for line in lines)).encode())


def _keep(path: Path, content: bytes) -> None:
    own_folder(own_folder(path.parent.parent) / path.parent.name)
    atomic.write_bytes(path, content, mode=0o600)
