"""The trust list: an OpenSSH allowed_signers file (ssh-keygen(1), ALLOWED SIGNERS), one person's key a line.

labcal checks Ed25519 keys, and those of FIDO security keys. Lines with keys of other types and certificate authorities
are read, never trusted. What OpenSSH has no option for stands behind the key, where it has a comment:
`labcal:roles=approve,release`, and `labcal:revoked`, which says why `valid-before` is there.
"""

from __future__ import annotations

import base64
import binascii
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from fnmatch import fnmatchcase
from pathlib import Path

from labcal.certificate.sshsig import KEY_TYPE, NAMESPACE, SECURITY_KEY_TYPE, BadSignature, raw_public_key
from labcal.errors import InputError
from labcal.files.plain_file import read_limited

LARGEST_BYTES = 2**20
KEY_TYPES = (KEY_TYPE, "ssh-rsa", "ecdsa-sha2-", "sk-ssh-ed25519", "sk-ecdsa-sha2-")  # beginnings

ROLES = ("measure", "approve", "release")
NEVER = datetime(1970, 1, 1, tzinfo=UTC)  # `valid-before` of a key that was revoked altogether
FOREVER = datetime.max.replace(tzinfo=UTC)

_OWN = "labcal:"  # begins a word of ours behind a key
_PRINCIPAL = re.compile(r"[A-Za-z0-9][A-Za-z0-9._@+-]{0,63}\Z")
_FIELD = re.compile(r'((?:[^\s"]|"[^"]*")+)(?:\s+|\Z)')
_OPTION = re.compile(r'([A-Za-z-]+)(?:="([^"]*)")?(?:,|\Z)')
_STAMP = {8: "%Y%m%d", 12: "%Y%m%d%H%M", 14: "%Y%m%d%H%M%S"}


@dataclass(frozen=True, slots=True)
class Signer:
    """One line: whose key (`key`, SSH wire format), and for what and when it is good. None is no limit."""

    principal: str
    key_type: str
    key: bytes
    namespaces: str | None = None  # patterns apart by commas
    valid_after: datetime | None = None
    valid_before: datetime | None = None
    authority: bool = False
    roles: tuple[str, ...] = ()
    revoked: bool = False  # from `valid_before` on

    def objection(self, namespace: str, now: datetime) -> str | None:
        """Why this line does not vouch for a signature of `namespace` at `now`; None where it does."""
        if self.authority:
            return "is trusted as a certificate authority only, which labcal does not support"
        if self.namespaces is not None and not _matches(namespace, self.namespaces):
            return f"is trusted for {self.namespaces}, not for {namespace}"
        if self.valid_after and now < self.valid_after:
            return f"is trusted only after {self.valid_after:%Y-%m-%d %H:%M}"
        if self.revoked and (self.valid_before is None or now >= self.valid_before):
            return self.revocation()
        if self.valid_before and now > self.valid_before:
            return f"was trusted only until {self.valid_before:%Y-%m-%d %H:%M}"
        return None

    def revocation(self) -> str:
        """Since when it is revoked, in words."""
        dated = self.valid_before is not None and self.valid_before > NEVER
        return f"is revoked from {self.valid_before:%Y-%m-%d}" if dated else "is revoked"

    def line(self) -> str:
        """The line that OpenSSH reads, without its end."""
        options = ["cert-authority"] if self.authority else []
        options += [f'namespaces="{self.namespaces}"'] if self.namespaces is not None else []
        for name, when in (("valid-after", self.valid_after), ("valid-before", self.valid_before)):
            options += [f'{name}="{when.astimezone(UTC):%Y%m%d%H%M%SZ}"'] if when else []
        key = base64.b64encode(self.key).decode()
        own = [f"{_OWN}roles={','.join(self.roles)}"] if self.roles else []
        own += [f"{_OWN}revoked"] if self.revoked else []
        return " ".join([self.principal, *([",".join(options)] if options else []), self.key_type, key, *own])


def own_line(principal: str, key: bytes) -> Signer:
    """The entry of somebody whose key is good for calibrations alone."""
    return Signer(principal, KEY_TYPE, key, namespaces=NAMESPACE)


def read_allowed_signers(path: Path) -> tuple[Signer, ...]:
    """Every line's signer. Raises InputError with file, line and what is wrong with it."""
    return parse_allowed_signers(read_limited(path, LARGEST_BYTES), path)


def parse_allowed_signers(content: bytes, path: Path) -> tuple[Signer, ...]:
    """Every line's signer of the file `path`, which holds `content`. Raises InputError."""
    try:
        lines = content.decode().splitlines()
    except UnicodeDecodeError:
        raise InputError("is not text in UTF-8", file=path) from None
    signers = []
    for number, line in enumerate(lines, start=1):
        try:
            signers.append(signer_of(line))
        except ValueError as error:
            raise InputError(str(error), file=path, line=number) from None
    return tuple(filter(None, signers))


def signer_of(line: str) -> Signer | None:
    """Whom one line names; None for a remark or an empty one. Raises ValueError."""
    stated = line.strip()
    return _signer(stated) if stated and not stated.startswith("#") else None


def with_revocations(signers: Sequence[Signer], revocations: Iterable[Signer] = ()) -> tuple[Signer, ...]:
    """The list with every line of a key that one line revokes revoked from the same time on.

    So a second line of that key, in the list or beside `revocations`, vouches for nothing that the first does not.
    """
    since = dict[bytes, datetime]()
    for one in (*signers, *revocations):
        if one.revoked:
            since[one.key] = min(since.get(one.key, FOREVER), one.valid_before or NEVER)
    return tuple(revoked_from(one, since[one.key]) if one.key in since else one for one in signers)


def revoked_from(signer: Signer, when: datetime) -> Signer:
    """The line revoked from `when` on, or from before that where it was good until then only."""
    return replace(signer, revoked=True, valid_before=min(when, signer.valid_before or when))


def to_trust(signer: Signer) -> Signer:
    """The line as it enters the lab's own list: one person, one Ed25519 key, calibrations alone. Raises ValueError."""
    check_principal(signer.principal)
    if signer.authority or signer.key_type not in (KEY_TYPE, SECURITY_KEY_TYPE):
        raise ValueError(f"{signer.principal}: only plain {KEY_TYPE} keys can be trusted here, and {SECURITY_KEY_TYPE}")
    if signer.namespaces is not None and not _matches(NAMESPACE, signer.namespaces):
        raise ValueError(f"{signer.principal}: the line is for {signer.namespaces}, not for {NAMESPACE}")
    return replace(signer, namespaces=NAMESPACE)


def check_principal(name: str) -> None:
    """Raise ValueError unless `name` can stand for one person in a trust list and in a file's name."""
    if not _PRINCIPAL.match(name):
        raise ValueError(f"{name!r} cannot name a person: use 1 to 64 of A-Z a-z 0-9 . _ @ + -, as in ada@lab.example")


def _signer(line: str) -> Signer:
    if not line.replace("\t", " ").isprintable():
        raise ValueError("holds a control character")
    fields, rest = _fields(line)
    if _is_key_type(fields[0]):
        raise ValueError("begins with a key: put the person it belongs to before it")
    options = "" if len(fields) < 2 or _is_key_type(fields[1]) else fields.pop(1)
    if len(fields) < 3 or not _is_key_type(fields[1]):
        raise ValueError("is not: person, options, key type, key")
    principal, key_type, text = fields[0].strip('"'), fields[1], fields[2]
    signer = _with_options(Signer(principal, key_type, _key(key_type, text)), options)
    return _with_own_words(signer, [*fields[3:], *rest.split()])


def _fields(line: str) -> tuple[list[str], str]:
    """Its first words, four at most, and what is left of it."""
    fields: list[str] = []
    place = 0
    while place < len(line) and len(fields) < 4:
        if not (found := _FIELD.match(line, place)):
            raise ValueError("has a quotation mark without its second")
        fields.append(found[1])
        place = found.end()
    return fields, line[place:]


def _with_own_words(signer: Signer, comment: Sequence[str]) -> Signer:
    for word in comment:
        if word == f"{_OWN}revoked":
            signer = replace(signer, revoked=True)
        elif word.startswith(f"{_OWN}roles="):
            named = word.partition("=")[2].split(",")
            if strange := [role for role in named if role not in ROLES]:
                raise ValueError(f"names a role that there is not: {strange[0]!r}; there are {', '.join(ROLES)}")
            signer = replace(signer, roles=tuple(role for role in ROLES if role in named))
        elif word.startswith(_OWN):
            raise ValueError(f"says something that this version does not know: {word}")
    return signer


def _key(key_type: str, text: str) -> bytes:
    try:
        key = base64.b64decode(text, validate=True)
        if key_type in (KEY_TYPE, SECURITY_KEY_TYPE):
            raw_public_key(key)
        if key[4 : 4 + len(key_type)] != key_type.encode():
            raise BadSignature
    except (binascii.Error, BadSignature):
        raise ValueError(f"has a key that is not whole, or not {key_type}") from None
    return key


def _with_options(signer: Signer, options: str) -> Signer:
    place = 0
    while place < len(options):
        if not (found := _OPTION.match(options, place)):
            raise ValueError(f"has options that cannot be read: {options[place:]}")
        signer = _with_option(signer, found[1].lower(), found[2])
        place = found.end()
    return signer


def _with_option(signer: Signer, name: str, value: str | None) -> Signer:
    match name:
        case "cert-authority" if value is None:
            return replace(signer, authority=True)
        case "namespaces" if value:
            return replace(signer, namespaces=value)
        case "valid-after" if value:
            return replace(signer, valid_after=_stamp(value))
        case "valid-before" if value:
            return replace(signer, valid_before=_stamp(value))
    raise ValueError(f"has an option that is not known or not whole: {name}")


def _stamp(text: str) -> datetime:
    """A time as ssh-keygen writes it: YYYYMMDD[HHMM[SS]], local, or UTC with a Z at the end."""
    digits = text.removesuffix("Z")
    try:
        when = datetime.strptime(digits, _STAMP[len(digits)])
    except (KeyError, ValueError):
        raise ValueError(f"has a time that is not YYYYMMDD[HHMM[SS]][Z]: {text}") from None
    return when.replace(tzinfo=UTC) if text.endswith("Z") else when.astimezone()


def _matches(text: str, patterns: str) -> bool:
    """OpenSSH's pattern list: `*` and `?`, `!` before a pattern refuses (ssh_config(5), PATTERNS)."""
    stated = [p.strip() for p in patterns.split(",")]
    if any(p.startswith("!") and _like(text, p[1:]) for p in stated):
        return False
    return any(not p.startswith("!") and _like(text, p) for p in stated)


def _like(text: str, pattern: str) -> bool:
    return fnmatchcase(text, pattern.replace("[", "[[]"))  # a bracket means itself


def _is_key_type(word: str) -> bool:
    return word.startswith(KEY_TYPES)
