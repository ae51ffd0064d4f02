"""Who may measure, approve and release; a list that states nobody's roles lets everybody do everything."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from labcal.certificate.allowed_signers import Signer
from labcal.errors import InputError
from labcal.model import Calibration
from labcal.record.person import perhaps_one_person, same_person


def may(name: str, role: str, trusted: Sequence[Signer]) -> bool:
    """Whether the person of exactly this name may do it."""
    stated = any(signer.roles for signer in trusted)
    return not stated or any(role in signer.roles for signer in trusted if signer.principal == name)


def may_measure(operator: str, trusted: Sequence[Signer]) -> bool:
    """Whether the operator, however spelled, may; one who has no key here has no roles to be judged by."""
    known = [signer.principal for signer in trusted if same_person(signer.principal, operator)]
    return not known or any(may(name, "measure", trusted) for name in known)


def objection(calibration: Calibration, signed: Sequence[str], trusted: Sequence[Signer]) -> str | None:
    """Why it is not released by those who `signed`; None where an approver and a releaser are among them.

    Neither is the operator; one person with both roles may be both.
    """
    if not may_measure(calibration.operator, trusted):
        return f"its operator, {calibration.operator}, has not the role measure"
    if without := [name for name in calibration.approvers if not may(name, "approve", trusted)]:
        return f"named as approver, but has not the role approve: {', '.join(without)}"
    others = [name for name in signed if not perhaps_one_person(name, calibration.operator)]
    if not any(may(name, "release", trusted) for name in others):
        return "nobody but its operator has signed who has the role release"
    return None


def check_approver(name: str, trusted: Sequence[Signer]) -> None:
    """Raise InputError where `name` lacks the role of an approver."""
    if not may(name, "approve", trusted):
        raise InputError(f"{name} has not the role approve; {_how('approve')}")


def check_roles(calibration: Calibration, path: Path, trusted: Sequence[Signer], signer: str | None = None) -> None:
    """Raise InputError where somebody has a part in it without the role, `signer` (who is about to sign) among them."""
    if not may_measure(calibration.operator, trusted):
        raise InputError(f"operator: {calibration.operator} has not the role measure; {_how('measure')}", file=path)
    for i, name in enumerate(calibration.approvers):
        if not may(name, "approve", trusted):
            raise InputError(f"approvers[{i}]: {name} has not the role approve; {_how('approve')}", file=path)
    if signer is not None and not any(may(signer, role, trusted) for role in _of_a_signature(calibration, signer)):
        raise InputError(f"{signer} has no role by which to sign it; {_how('release')}", file=path)


def _of_a_signature(calibration: Calibration, signer: str) -> tuple[str, ...]:
    """The roles of which one is needed: the operator signs as who measured it, everybody else as anything."""
    return ("measure",) if same_person(signer, calibration.operator) else ("measure", "approve", "release")


def _how(role: str) -> str:
    return f"nothing was written (`labcal keys trust FILE --role {role}` gives it)"
