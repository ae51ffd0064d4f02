"""The trust list under the signature of who administers it, once somebody does.

Beside `allowed_signers` lie `administrator` (one line of the same form: whose key) and `allowed_signers.sshsig`, as
`ssh-keygen -Y sign -n labcal-trust-list` writes it. Who may write this folder can take both away, or put back a list
that was signed before: it tells a slip and an edit from what somebody answers for, and no more.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from labcal.certificate import sshsig
from labcal.certificate.allowed_signers import Signer, read_allowed_signers
from labcal.certificate.sshsig import BadSignature
from labcal.errors import InputError
from labcal.files.plain_file import read_limited

NAMESPACE = "labcal-trust-list"
LARGEST_BYTES = 2**14


def administrator_file(trust_list: Path) -> Path:
    """Where the line of who administers the list lies, if anybody does."""
    return trust_list.with_name("administrator")


def signature_file(trust_list: Path) -> Path:
    """Where the signature of the list lies."""
    return trust_list.with_name(f"{trust_list.name}.sshsig")


def administrator(trust_list: Path) -> Signer | None:
    """Who administers the list; None where nobody does. Raises InputError."""
    if not (path := administrator_file(trust_list)).exists():
        return None
    lines = read_allowed_signers(path)
    if len(lines) != 1 or lines[0].namespaces != NAMESPACE:
        raise InputError(f'is not one line of one person with namespaces="{NAMESPACE}"', file=path)
    return lines[0]


def check_list(trust_list: Path, content: bytes | None) -> None:
    """Raise InputError where somebody administers the list and has not signed these bytes; None: there is no list."""
    who = administrator(trust_list)
    if who is None:
        if signature_file(trust_list).exists():
            text = f"is signed, and {administrator_file(trust_list).name}, which says whose signature counts, is gone"
            raise InputError(text, file=trust_list)
        return
    if (why := _objection(who, trust_list, content)) is not None:
        how = f"nobody is trusted until `labcal keys sign --key {who.principal}`, after a look at `labcal keys list`"
        raise InputError(f"{why}; {how}", file=trust_list)


def _objection(who: Signer, trust_list: Path, content: bytes | None) -> str | None:
    if content is None:
        return f"is administered by {who.principal}, and is gone"
    try:
        signature = sshsig.parse(read_limited(signature_file(trust_list), LARGEST_BYTES))
        if signature.public_key != who.key:
            return f"is administered by {who.principal}, and signed by somebody else"
        signature.check(content, NAMESPACE)
    except (FileNotFoundError, BadSignature):
        return f"was changed since {who.principal}, who administers it, signed it"
    return None


def administered_by(trust_list: Path, mine: Signer) -> Signer:
    """The administrator's line, which `mine`, a line of the list, becomes or is. Raises InputError where it is not."""
    who = administrator(trust_list)
    if mine.revoked:
        raise InputError(f"the key of {mine.principal} {mine.revocation()}; it signs no trust list")
    if who is None:
        return replace(mine, namespaces=NAMESPACE, roles=(), valid_after=None, valid_before=None)
    if (who.principal, who.key) != (mine.principal, mine.key):
        raise InputError(f"is administered by {who.principal}, who alone signs it", file=trust_list)
    return who
