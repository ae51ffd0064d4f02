"""The signature of a cage calibration file, `cage.json.sshsig`: as a calibration's, by its approver."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from pathlib import Path

from labcal.certificate.allowed_signers import Signer, with_revocations
from labcal.certificate.calibration_file import LARGEST_BYTES
from labcal.certificate.roles import check_approver
from labcal.certificate.signing import Shown, check_signature
from labcal.errors import InputError
from labcal.files.plain_file import read_limited
from labcal.record.person import same_person

WHAT_TO_DO = "no coil is driven by it: approve its run again (`labcal bench cage`, to another file)"


def cage_signature_file(cage: Path) -> Path:
    """Where the signature of a cage calibration file lies."""
    return cage.with_name(f"{cage.name}.sshsig")


def cage_signer(name: str, trusted: Sequence[Signer]) -> str | None:
    """Whose key of the trust list is that of `name`, however spelled; None where nobody's is."""
    good = [s.principal for s in with_revocations(trusted) if not s.revoked and same_person(s.principal, name)]
    return good[0] if good else None


def check_cage(
    cage: Path,
    approved_by: str,
    trusted: Sequence[Signer],
    revoked: frozenset[bytes],
    now: datetime,
    shown: Shown = lambda file, signature: None,
) -> str | None:
    """What is to be said of the file; None where the person who approved it has signed it.

    Raises InputError where a signature is there that does not hold, of somebody who is not trusted, or another
    person's; and where there is none, in a lab that has given roles.
    """
    if not (file := cage_signature_file(cage)).exists():
        if any(signer.roles for signer in trusted):
            raise InputError(
                f"is not signed, and in this lab an approver with a role signs it; {WHAT_TO_DO}", file=cage
            )
        return f"{cage.name} is not signed: that {approved_by} approved it is a claim."
    found = check_signature(file, read_limited(cage, LARGEST_BYTES), with_revocations(trusted), revoked, now, shown)
    if found.objection is not None:
        raise InputError(f"its signature {file.name}: {found.objection}; {WHAT_TO_DO}", file=cage)
    if not same_person(found.principal or "", approved_by):
        text = f"approved_by: {approved_by} approved it, and {found.principal} signed it; {WHAT_TO_DO}"
        raise InputError(text, file=cage)
    check_approver(found.principal or "", trusted)
    return None
