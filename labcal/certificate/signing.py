"""Approving, signing and verifying a calibration file.

A signature is a person's word for exact bytes; a name under `approvers` is a claim until its owner signs too. So a
file that names no approver, or one who has not signed, is PROVISIONAL: valid, and said to be so.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, date, datetime, timedelta
from pathlib import Path
from typing import Any, Literal

from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import roles, sshsig
from labcal.certificate.agent import Key, public_half, signed
from labcal.certificate.allowed_signers import NEVER, Signer, own_line, with_revocations
from labcal.certificate.calibration_file import LARGEST_BYTES, calibration_bytes, parse_calibration
from labcal.certificate.keys import SIMULATED
from labcal.certificate.recomputed import Recomputed, not_stated
from labcal.certificate.sshsig import NAMESPACE, BadSignature, public_key_blob
from labcal.certificate.timestamp import ShownTime, claimed
from labcal.errors import InputError
from labcal.files import atomic
from labcal.files.plain_file import read_limited
from labcal.model import Calibration
from labcal.record.person import check_person, perhaps_one_person, same_person

LARGEST_SIGNATURE_BYTES = 2**14
MOST_SIGNATURES = 99  # beside one file
CLOCKS_DIFFER = timedelta(minutes=10)  # between the computers of a lab
Status = Literal["released", "provisional", "unsigned", "invalid", "expired", "superseded"]
Shown = Callable[[Path, bytes], ShownTime | None]  # a signature's file and bytes: since when they are shown to be there
Examine = Callable[[Calibration], object]  # raises InputError where something else does not hold of it
Revise = Callable[[Calibration], Calibration]


@dataclass(frozen=True, slots=True)
class SignatureCheck:
    """What one signature file came to: `objection` is None where it holds and its signer is trusted.

    `shown` is when it was there already, and by what its signer cannot have made; None where nothing shows that.
    """

    file: Path
    principal: str | None
    fingerprint: str | None
    objection: str | None
    shown: ShownTime | None = None


@dataclass(frozen=True, slots=True)
class Verification:
    """What all signatures of a calibration came to; `run_matches` is None where no run was named.

    `recomputed` says what came of working it out again; None where nobody asked.
    """

    file: Path
    content: bytes  # what was checked
    checks: tuple[SignatureCheck, ...]
    calibration: Calibration | None  # where at least one signature holds
    run_matches: bool | None = None
    recomputed: Recomputed | None = None
    expired: bool = False
    same_chain: bool = True  # where both that run and the calibration state the head of a hash chain
    trusted: tuple[Signer, ...] = ()  # the list that it was checked against
    superseded_by: str | None = None  # the run of the calibration that took its place, where one is known
    ahead: bool = False  # issued later than this computer's clock

    @property
    def valid(self) -> bool:
        """At least one signature, every one of them good, the run (where named) is the one, and gives these numbers."""
        good = bool(self.checks) and all(c.objection is None for c in self.checks)
        return good and self.run_matches is not False and (self.recomputed is None or self.recomputed.holds)

    @property
    def status(self) -> Status:
        """One word for programs (contract: verify)."""
        if not self.checks:
            return "unsigned"
        if not self.valid:
            return "invalid"
        if self.expired or self.superseded_by:
            return "expired" if self.expired else "superseded"
        return "provisional" if self.provisional else "released"

    @property
    def signers(self) -> tuple[str, ...]:
        """Who signed, of those signatures that hold."""
        return tuple(c.principal for c in self.checks if c.objection is None and c.principal)

    @property
    def provisional(self) -> str | None:
        """Why nobody but the signer stands for it yet; None where every approver named has signed."""
        if (c := self.calibration) is not None and (held := c.not_measured()):
            return f"its run did not measure {', '.join(held)}"
        if c is None or not (named := c.approvers):
            return "no approver is named"
        if not c.operator.strip():
            return "nobody is said to have measured it, so that nobody who approves it is another person"
        if self.ahead:
            return "issued_utc is later than this computer's clock: one of them is wrong"
        if own := [name for name in named if perhaps_one_person(name, c.operator)]:
            return f"named as approver, but is the operator: {', '.join(own)}"
        if missing := [name for name in named if name not in self.signers]:
            return f"named as approver, but has not signed: {', '.join(missing)}"
        if lacking := roles.objection(c, self.signers, self.trusted):
            return lacking
        if unstated := not_stated(c):
            return unstated
        return None if self.recomputed is None or self.recomputed.same else "its numbers were not confirmed by its run"

    def signed_at(self, check: SignatureCheck) -> str:
        """When that signature was made, with what says so."""
        stated = self.calibration.issued_utc if self.calibration else None
        return claimed(stated) if check.shown is None else check.shown.in_words(stated)

    def faults(self) -> list[str]:
        """What is against its signatures and its run, a sentence each."""
        said = [f"{c.file.name} ({c.principal or 'unknown'}): {c.objection}" for c in self.checks if c.objection]
        said += [] if self.checks else [f"{self.file.name} carries no signature"]
        return said + (["run_sha256: it was not made from the run that was named"] if self.run_matches is False else [])

    def limits(self) -> list[str]:
        """What keeps a file whose signatures hold from being used without a thought, a sentence each."""
        said = [f"PROVISIONAL: {self.provisional}."] if self.valid and self.provisional else []
        said += [left] if self.calibration and (left := self.calibration.unexplained()) else []
        until = self.calibration.validity.until if self.calibration else None
        said += [f"EXPIRED: it was good until {until}."] if self.expired else []
        return said + ([f"SUPERSEDED: by the calibration of run {self.superseded_by}."] if self.superseded_by else [])

    def remarks(self) -> list[str]:
        """What somebody who uses its numbers has to hear; nothing where it is released."""
        if not self.checks:
            return [f"UNSIGNED: {self.file.name} carries no signature: a draft that nobody stands for."]
        return self.limits() if self.valid else [f"NOT VALID: {'; '.join(self.against())}."]

    def against(self) -> list[str]:
        """What is against its signatures, its run and its numbers."""
        again = self.recomputed
        return [*self.faults(), *(again.why if again and not again.holds else ())]

    def sentences(self) -> list[str]:
        """What a person has to know, the verdict first."""
        if not self.checks:
            return [f"NOT VALID: {self.file.name} carries no signature."]
        said = [f"VALID: signed by {', '.join(self.signers)}." if self.valid else "NOT VALID."]
        if self.run_matches is False:
            what = "run_sha256" if self.same_chain else "the head of its hash chain"
            said.append(f"It was not made from the run that was named ({what} differs).")
        if self.run_matches and (self.recomputed is None or self.recomputed.same):
            said.append("It was made from the run that was named.")
        said += self.recomputed.sentences() if self.recomputed else []
        said += self.limits()
        if self.calibration and self.calibration.simulated:
            said.append("SIMULATED: it describes no real sensor.")
        return said


def approve(
    path: Path,
    name: str,
    examine: Examine = lambda draft: None,
    revise: Revise = lambda draft: draft,
    issue: Revise = lambda draft: draft,
) -> Calibration:
    """Write `name` among the approvers of the draft at `path`, once `examine` has seen it. Raises InputError.

    `revise` makes of the draft what is approved; `issue` gives it number and date, when all else is well.

    Refused after any signature (its bytes would no longer be the signed ones), for the operator, as two persons
    look at a calibration, or it stays PROVISIONAL, and where its run did not measure all of the map.
    """
    name = " ".join(name.split())
    check_person(name)
    draft = parse_calibration(read_limited(path, LARGEST_BYTES), path)
    if signed := signature_files(path):
        raise InputError(f"is signed already ({signed[0].name}); only a draft can be approved", file=path)
    if not name:
        raise InputError("the approver has no name", file=path)
    if held := ", ".join(draft.not_measured()):
        what = f"its run did not measure {held}: nobody can approve that; turn about the other body axes as well"
        raise InputError(what, file=path)
    if not draft.operator.strip():
        raise InputError("operator: nobody is said to have measured it, so nobody can be another person", file=path)
    if perhaps_one_person(name, draft.operator):
        raise InputError(f"{name} is the operator, {draft.operator}; another person approves", file=path)
    if any(perhaps_one_person(name, other) for other in draft.approvers):
        raise InputError(f"{name} has approved it already", file=path)
    approved = replace(revise(draft), approvers=(*draft.approvers, name))
    examine(approved)
    issued = issue(approved)
    atomic.write_bytes(path.resolve(), calibration_bytes(issued))
    return issued


def check_approvers(calibration: Calibration, path: Path, known: Collection[str]) -> None:
    """Raise InputError where an approver is not of the names `known`, is the operator, or is there twice."""
    for i, name in enumerate(calibration.approvers):
        others = [calibration.operator, *calibration.approvers[:i]]
        if twin := next((other for other in others if perhaps_one_person(name, other)), None):
            text = f"approvers[{i}]: {name} and {twin}, who has another part in it, are one person"
            raise InputError(f"{text}; nothing was written", file=path)
        if name not in known:
            text = f"approvers[{i}]: {name} is nobody of the trust list, whose signatures count; nothing was written"
            raise InputError(f"{text} (`labcal keys new` makes a key, in the window New key)", file=path)


def sign(
    path: Path,
    name: str,
    key: Key,
    signers: Sequence[Signer] = (),
    examine: Examine = lambda calibration: None,
    *,
    shown: Shown = lambda file, signature: None,
    issue: Revise | None = None,
) -> Path:
    """Sign the bytes at `path` as `name` and write the signature beside them; returns its path.

    `signers` is the trust list: it tells whose the signatures are that are there already. One whose key is revoked,
    and not `shown` to be from before, is set aside (`….revoked`), and the new one takes its place. `examine` sees the
    calibration that is about to be signed; where nobody has, and it has no number, `issue` gives it number and date.
    Raises InputError for a file that is no calibration, for somebody who has signed it or whose key is revoked, and
    where an earlier signature does not hold.
    """
    content = read_limited(path, LARGEST_BYTES)
    calibration = parse_calibration(content, path)
    own = public_half(key)
    revoked = {s.key: s for s in with_revocations(signers) if s.revoked}
    if own in revoked:
        raise InputError(f"the key of {name} {revoked[own].revocation()}; `labcal keys new` makes another")
    person = {own} | {s.key for s in signers if same_person(s.principal, name)}
    there, spent = _expected(path), list[Path]()
    for file in there:
        earlier, text = _holding(file, content)
        at = _at(shown(file, text), datetime.now(UTC))
        if (line := revoked.get(earlier.public_key)) and line.objection(NAMESPACE, at):
            spent.append(file)
        elif earlier.public_key in person:
            raise InputError(f"{name} has signed it already ({file.name}); a second person signs next", file=path)
    examine(calibration)
    fresh = issue if not there and calibration.number is None else None
    content = calibration_bytes(fresh(calibration)) if fresh else content
    target, armoured = spent[0] if spent else _signature_path(path, len(there) + 1), signed(content, key)
    if spent:
        atomic.write_bytes(target.with_name(f"{target.name}.revoked"), target.read_bytes())
    if fresh:  # now that it is signed: an agent may have refused
        atomic.write_bytes(path.resolve(), content)
    atomic.write_text(target, armoured)
    return target


def sign_simulated(path: Path, allowed_signers: Path) -> Path:
    """Sign a simulated calibration with a key that lives in memory only, and write its trust list.

    `verify` takes that principal for files that say simulated and no other. Raises InputError for a real one.
    """
    if not parse_calibration(read_limited(path, LARGEST_BYTES), path).simulated:
        raise InputError("is not simulated; a key kept in memory signs nothing real", file=path)
    key = Ed25519PrivateKey.generate()
    atomic.write_text(allowed_signers, own_line(SIMULATED, public_key_blob(key.public_key())).line() + "\n")
    return sign(path, SIMULATED, key)


def verify(
    path: Path,
    signers: Sequence[Signer],
    revoked: frozenset[bytes],
    now: datetime,
    run_sha256: str | None = None,
    chain: Mapping[str, Any] | None = None,
    *,
    shown: Shown = lambda file, signature: None,
) -> Verification:
    """Check every signature of the calibration at `path` against `signers`, and its run where one is named.

    The run is identified by `run_sha256`, and by the head of its hash `chain` where both have one.
    A key is judged at the time at which its signature is `shown` to have been there, else `now`.
    The bytes are read once; a file beside them is never asked whom to trust. Raises InputError where `path` cannot be
    read, or a trusted person signed something that is no calibration.
    """
    content, trusted = read_limited(path, LARGEST_BYTES), with_revocations(signers)
    checks = _once_each([check_signature(file, content, trusted, revoked, now, shown) for file in _expected(path)])
    if all(check.objection for check in checks):
        return Verification(path, content, checks, None)
    calibration = parse_calibration(content, path)
    if not calibration.simulated:
        checks = tuple(_real(check) for check in checks)
    until = calibration.validity.until
    same_chain = not (chain and calibration.chain) or dict(calibration.chain) == dict(chain)
    return Verification(
        path,
        content,
        checks,
        calibration,
        None if run_sha256 is None else calibration.run_sha256 == run_sha256 and same_chain,
        same_chain=same_chain,
        expired=until is not None and date.fromisoformat(until) < now.date(),
        trusted=trusted,
        ahead=datetime.fromisoformat(calibration.issued_utc or NEVER.isoformat()) > now + CLOCKS_DIFFER,
    )


def signature_files(path: Path) -> list[Path]:
    """The signature files that lie beside the calibration at `path`, in order of signing."""
    named = (_signature_path(path, number) for number in range(1, MOST_SIGNATURES + 1))
    return [file for file in named if os.path.lexists(file)]  # asked one by one: a folder may hold thousands of files


def _signature_path(path: Path, number: int) -> Path:
    return path.with_name(f"{path.name}.sshsig" if number == 1 else f"{path.name}.{number}.sshsig")


def _expected(path: Path) -> list[Path]:
    """The signature files there are, and those that must once have been there for the later ones to exist."""
    there = signature_files(path)
    return sorted({*there, *(_signature_path(path, n + 1) for n in range(len(there)))}, key=lambda f: (len(f.name), f))


def check_signature(
    file: Path, content: bytes, signers: Sequence[Signer], revoked: frozenset[bytes], now: datetime, shown: Shown
) -> SignatureCheck:
    """What the signature in `file` of these bytes comes to, by a trust list and the keys that are `revoked`."""
    try:
        armoured = read_limited(file, LARGEST_SIGNATURE_BYTES)
        signature = sshsig.parse(armoured)
    except FileNotFoundError:
        return SignatureCheck(file, None, None, "is missing, though a later signature is there")
    except (BadSignature, InputError) as error:
        return SignatureCheck(file, None, None, error.what if isinstance(error, InputError) else str(error))
    seen = shown(file, armoured)
    at = _at(seen, now)
    mine = [s for s in signers if s.key == signature.public_key]
    mine.sort(key=lambda signer: signer.objection(NAMESPACE, at) is not None)  # one line that vouches is enough
    objection = _objection(signature, content, mine, revoked, at)
    if objection and seen is None and mine and mine[0].revoked and (mine[0].valid_before or NEVER) > NEVER:
        objection += "; a time that is only claimed does not show that it signed before"
    principal = mine[0].principal if mine else None
    return SignatureCheck(file, principal, sshsig.fingerprint(signature.public_key), objection, seen)


def _objection(
    signature: sshsig.Signature, content: bytes, mine: Sequence[Signer], revoked: frozenset[bytes], at: datetime
) -> str | None:
    try:
        signature.check(content)
    except BadSignature as error:
        return str(error)
    if signature.public_key in revoked:
        return "its key is revoked"
    if not mine:
        return "its key is nobody's in the trust list"
    objection = mine[0].objection(NAMESPACE, at)
    return f"its key {objection}" if objection else None


def _once_each(checks: Sequence[SignatureCheck]) -> tuple[SignatureCheck, ...]:
    """A second signature by the same person, or by the same key, is none: it would pass one person off as two."""
    kept: list[SignatureCheck] = []
    for check in checks:
        repeated = any(_same_hand(check, other) for other in kept)
        if check.objection is None and repeated:
            check = replace(check, objection=f"repeats the signature of {check.principal}")
        kept.append(check)
    return tuple(kept)


def _same_hand(one: SignatureCheck, other: SignatureCheck) -> bool:
    return one.fingerprint == other.fingerprint or same_person(one.principal or "", other.principal or "")


def _real(check: SignatureCheck) -> SignatureCheck:
    if check.objection is None and check.principal == SIMULATED:
        return replace(check, objection="its key is good for simulated files only, and this file says it is real")
    return check


def _holding(file: Path, content: bytes) -> tuple[sshsig.Signature, bytes]:
    """The signature in `file`, and its bytes. Raises InputError where it does not hold."""
    try:
        armoured = read_limited(file, LARGEST_SIGNATURE_BYTES)
        signature = sshsig.parse(armoured)
        signature.check(content)
    except BadSignature as error:
        raise InputError(f"{error}; nothing was signed", file=file) from None
    return signature, armoured


def _at(shown: ShownTime | None, now: datetime) -> datetime:
    """The time at which a key is judged."""
    return now if shown is None else shown.utc
