"""The lab's keys: private ones under a passphrase, the trust list, and the keys that are trusted no more.

All lie in `HOME/keys`, a folder only its owner may enter: `PRINCIPAL.pem`, `allowed_signers` with the revoked ones in
it, and `revoked_keys` of earlier versions (one public key a line, as `ssh-keygen -r` reads it). A passphrase is never
kept.
"""

from __future__ import annotations

import base64
import os
import stat
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path

from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import pkcs8
from labcal.certificate.administration import (
    NAMESPACE,
    administered_by,
    administrator_file,
    check_list,
    signature_file,
)
from labcal.certificate.agent import AgentKey, Key, in_agent, public_half, signed
from labcal.certificate.allowed_signers import (
    LARGEST_BYTES,
    NEVER,
    ROLES,
    Signer,
    check_principal,
    own_line,
    parse_allowed_signers,
    read_allowed_signers,
    revoked_from,
    signer_of,
    to_trust,
    with_revocations,
)
from labcal.certificate.passphrases import check_passphrase
from labcal.certificate.sshsig import public_key_blob
from labcal.errors import InputError
from labcal.files import atomic
from labcal.files.home import own_folder
from labcal.files.plain_file import read_limited
from labcal.record.person import perhaps_one_person

SIMULATED = "simulated"  # the principal of keys made in memory: good for files that say simulated, and for no other


@dataclass(frozen=True, slots=True)
class KeyEntry:
    """One line of `labcal keys list`."""

    signer: Signer
    private_key_here: bool
    revoked: bool

    def to_hand_out(self) -> Signer:
        """The line as it leaves the lab, its revocation with it."""
        return revoked_from(self.signer, NEVER) if self.revoked and not self.signer.revoked else self.signer


def new_key(home: Path, name: str, passphrase: str) -> Signer:
    """Make an Ed25519 key for `name`, lock it with `passphrase`, and trust it. Raises InputError.

    A key takes the place of a revoked one of the same person, and of no other.
    """
    _check_name(name)
    check_passphrase(passphrase, name)
    path, known, gone = _private(home, name), listed(home), revoked(home)
    _check_spelling(name, known, trust_list(home))
    own = [signer for signer in known if signer.principal == name]
    keys, gone = {signer.key for signer in own}, gone | {signer.key for signer in own if signer.revoked}
    if path.exists() and not (keys and keys <= gone):
        text = f"{name} has a key already; a second one would replace it (`labcal keys revoke {name}` where it is lost)"
        raise InputError(text, file=path)
    if keys - gone:
        raise InputError(f"{name} is trusted already with a key made elsewhere", file=trust_list(home))
    key = Ed25519PrivateKey.generate()
    roles = next((one.roles for one in own if one.roles), ())
    signer = replace(own_line(name, public_key_blob(key.public_key())), roles=roles)
    _keep(path, pkcs8.locked(key, passphrase))
    _edit(home, added=[signer])
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


def has_private_key(home: Path, name: str) -> bool:
    """Whether a key file of `name` lies here, which a passphrase opens."""
    _check_name(name)
    return _private(home, name).exists()


def has_key_at_hand(home: Path, name: str) -> bool:
    """Whether `name` can sign here: by a key file, or by a key of theirs that the SSH agent holds."""
    return has_private_key(home, name) or _agents(home, name)[1] is not None


def signing_key(home: Path, name: str, passphrase: str) -> Key:
    """The key of `name`: the one that lies here, else one in the SSH agent that the list knows as theirs.

    Raises InputError.
    """
    if not has_private_key(home, name):
        theirs, held = _agents(home, name)
        if held is not None:
            return held
        if theirs:
            raise InputError(f"there is no key for {name} here, and no SSH agent here holds theirs; nothing was signed")
    return open_key(home, name, passphrase)


def _agents(home: Path, name: str) -> tuple[list[Signer], AgentKey | None]:
    """The keys of `name` that are good, and the one of them that the SSH agent holds."""
    theirs = [s for s in with_revocations(listed(home)) if s.principal == name and not s.revoked]
    return theirs, in_agent(theirs)


def trust_list(home: Path) -> Path:
    """Where the lab's trust list lies; it need not exist yet."""
    return home / "keys" / "allowed_signers"


def trusted(home: Path) -> tuple[Signer, ...]:
    """Every line of the lab's trust list, in order. Raises InputError, also where who administers it has not signed."""
    path = trust_list(home)
    content = read_limited(path, LARGEST_BYTES) if path.exists() else None
    check_list(path, content)
    return () if content is None else parse_allowed_signers(content, path)


def listed(home: Path) -> tuple[Signer, ...]:
    """Every line of the trust list, whoever signed it: to be looked at and changed, never to be trusted."""
    return read_allowed_signers(path) if (path := trust_list(home)).exists() else ()


def sign_list(home: Path, name: str, key: Key) -> int:
    """Sign the trust list as who administers it, from now on where nobody did; returns how many lines it has.

    Raises InputError: somebody else administers it, or `name` has no key in it that is good.
    """
    own, path = public_half(key), trust_list(home)
    mine = next((s for s in with_revocations(listed(home)) if (s.principal, s.key) == (name, own)), None)
    if mine is None or own in revoked(home):
        raise InputError(f"{name} is not in it with this key, or is revoked", file=path)
    who, gone = administered_by(path, mine), revoked(home)
    _edit(home, lambda signer: revoked_from(signer, NEVER) if signer.key in gone else signer)  # of earlier versions
    content = read_limited(path, LARGEST_BYTES)
    armoured = signed(content, key, NAMESPACE)
    _keep(administrator_file(path), f"{who.line()}\n".encode())
    _keep(signature_file(path), armoured.encode())
    return len(parse_allowed_signers(content, path))


def trust(home: Path, file: Path, roles: Collection[str] = ()) -> tuple[Signer, ...]:
    """Take the lines of the allowed_signers file `file` into the lab's list, all or none; returns what that changed.

    `roles` become those of everybody it names, whatever it says of roles itself; without any, theirs stay. What it
    says is revoked is revoked here, and what is revoked here stays so. Raises InputError: a line that is not one
    person's Ed25519 key for calibrations, or a key that is another person's already (two names for one key would let
    one person sign twice).
    """
    before = listed(home)
    if not (lines := read_allowed_signers(file)):
        raise InputError("holds nobody's key", file=file)
    stated, new = _checked(lines, before, file)
    revocations = [signer for signer in stated if signer.revoked]
    named, given = {s.principal for s in stated}, tuple(role for role in ROLES if role in roles)
    had = {signer.principal: signer.roles for signer in before if signer.roles}

    def changed(signer: Signer) -> Signer:
        [tightened] = with_revocations([signer], revocations)
        return replace(tightened, roles=given) if given and signer.principal in named else tightened

    without = [replace(signer, roles=had.get(signer.principal, ())) for signer in new]  # roles are not brought along
    _edit(home, changed, map(changed, without))
    return tuple(signer for signer in listed(home) if signer not in before)


def _checked(lines: Sequence[Signer], before: Sequence[Signer], file: Path) -> tuple[list[Signer], list[Signer]]:
    """The lines as they may enter the list, and those of them that it lacks; no key that is revoked there comes back.

    Raises InputError.
    """
    stated, known = list[Signer](), list(before)
    for line in lines:
        signer = _stated(line, known, file)
        same = [s for s in known if s.key == signer.key]
        stated.append(signer)
        if not same or not (signer.revoked or any(s.revoked or s == replace(signer, roles=s.roles) for s in same)):
            known.append(signer)
    return stated, known[len(before) :]


def _stated(stated: Signer, known: Sequence[Signer], file: Path) -> Signer:
    """The line as it may enter the list of those who are `known`. Raises InputError."""
    try:
        signer = to_trust(stated)
        _check_name(signer.principal)
    except ValueError as error:
        raise InputError(str(error), file=file) from None
    _check_spelling(signer.principal, known, file)
    if owner := next((s.principal for s in known if s.key == signer.key and s.principal != signer.principal), None):
        raise InputError(f"the key of {signer.principal} is {owner}'s already", file=file)
    return signer


def revoke(home: Path, name: str, since: datetime = NEVER) -> int:
    """Accept no signature by any present key of `name`, but what is shown to be from before `since`.

    Returns how many keys those are. Raises InputError where none is left that is not revoked from then already.
    """
    gone = revoked(home)
    own = [s for s in listed(home) if s.principal == name and s.key not in gone]
    keys = {s.key for s in own if not (s.revoked and (s.valid_before or NEVER) <= since)}
    if not keys:
        raise InputError(f"{name} is not in the trust list, or revoked already", file=trust_list(home))
    _edit(home, lambda signer: revoked_from(signer, since) if signer.key in keys else signer)
    return len(keys)


def revoked(home: Path) -> frozenset[bytes]:
    """The keys of which no signature counts, in SSH wire format. Raises InputError with file and line."""
    keys = {s.key for s in listed(home) if s.revoked and (s.valid_before or NEVER) <= NEVER}
    path = home / "keys" / "revoked_keys"
    if not path.exists():
        return frozenset(keys)
    for number, line in enumerate(read_limited(path, 2**20).decode(errors="replace").splitlines(), start=1):
        if words := line.partition("#")[0].split():
            try:
                keys.add(base64.b64decode(words[1], validate=True))
            except (IndexError, ValueError):
                raise InputError("is not: key type, key", file=path, line=number) from None
    return frozenset(keys)


def entries(home: Path, *, only_listed: bool = False) -> tuple[KeyEntry, ...]:
    """Everybody in the trust list, whether their private key is here, and whether they are revoked.

    `only_listed`: to be looked at, whoever signed the list.
    """
    gone = revoked(home)
    known = listed(home) if only_listed else trusted(home)
    return tuple(KeyEntry(s, _private(home, s.principal).exists(), s.revoked or s.key in gone) for s in known)


def names(home: Path) -> frozenset[str]:
    """Everybody who has a key in the trust list that is not revoked."""
    return frozenset(entry.signer.principal for entry in entries(home) if not entry.revoked)


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
        if other.principal != name and perhaps_one_person(other.principal, name):
            text = f"{name} and {other.principal}, who is trusted, are two spellings of one name; name them apart"
            raise InputError(text, file=file)


def _private(home: Path, name: str) -> Path:
    return home / "keys" / f"{name}.pem"


def _edit(home: Path, change: Callable[[Signer], Signer] = lambda signer: signer, added: Iterable[Signer] = ()) -> None:
    """Write the trust list with each line changed and some added; remarks stay, and lines that nothing changes."""
    path = trust_list(home)
    before = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    after = [*(_changed(line, change) for line in before), *(signer.line() for signer in added)]
    if after != before:
        _keep(path, "".join(f"{line}\n" for line in after).encode())


def _changed(line: str, change: Callable[[Signer], Signer]) -> str:
    signer = signer_of(line)
    return line if signer is None or (new := change(signer)) == signer else new.line()


def _keep(path: Path, content: bytes) -> None:
    own_folder(own_folder(path.parent.parent) / path.parent.name)
    atomic.write_bytes(path, content, mode=0o600)
