"""Who approves and signs a calibration here, and whose signatures hold."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from datetime import UTC, datetime
from functools import partial
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal

from labcal import certificate
from labcal.certificate import Stated, Verification, read_allowed_signers
from labcal.certificate.allowed_signers import with_revocations
from labcal.certificate.calibration_file import LARGEST_BYTES
from labcal.certificate.signing import LARGEST_SIGNATURE_BYTES
from labcal.certificate.timestamp import ShownTime, shown_utc
from labcal.errors import InputError
from labcal.files.home import home
from labcal.files.plain_file import read_limited
from labcal.model import Calibration
from labcal.session.approved import check_approved, keep_approved
from labcal.session.audited import note_file, noted_utc
from labcal.session.in_archive import InArchive
from labcal.session.numbering import check_clock, check_number, issuing, keep_signed
from labcal.session.sources import Source, run_bundle
from labcal.session.stamping import authorities, stamp
from labcal.session.trust import handed_out
from labcal.session.working_out import Progress, recomputed

NOTHING_STATED = Stated()
SUPERSEDING = "superseding"  # signed calibrations that took the place of others
CALIBRATIONS = "calibrations"  # the window's drafts and certificates, in labcal's folder


def approve(
    calibration: Path, name: str, progress: Progress = lambda step: None, stated: Stated = NOTHING_STATED
) -> Calibration:
    """Write the approver, somebody of the trust list, into a draft. Raises InputError where its run gives another.

    With what they state beside its numbers, and with the number and the date of the certificate.
    """
    with issuing(calibration) as issue:
        examine = _same_as_its_run(calibration, progress)
        approved = certificate.approve(calibration, name, examine, stated.on, issue)
    keep_approved(approved)
    note_file("approve", name, calibration, number=approved.number)
    return approved


def sign(
    calibration: Path,
    name: str,
    passphrase: str,
    progress: Progress = lambda step: None,
    on_remark: Callable[[str], None] = lambda remark: None,
) -> Path:
    """Sign the calibration as `name`; returns the signature's path. Raises InputError where its run gives another.

    `on_remark` gets what came of asking for a time stamp, where the laboratory names an authority.
    """
    key = certificate.keys.signing_key(home(), name, passphrase)
    examine = _same_as_its_run(calibration, progress, name)
    with issuing(calibration) as issue:
        written = certificate.sign(calibration, name, key, handed_out(), examine, shown=shown, issue=issue)
    content = calibration.read_bytes()
    signed = certificate.parse_calibration(content, calibration)
    keep_signed(signed, content)
    note_file("sign", name, calibration, written, signed.number)
    certificate.keep_superseding(signatures(calibration), home() / SUPERSEDING)
    if (said := stamp(written, signed.run_id)) is not None:
        on_remark(said)
    return written


def _same_as_its_run(path: Path, progress: Progress, signer: str | None = None) -> Callable[[Calibration], None]:
    def examine(stated: Calibration) -> None:
        certificate.check_approvers(stated, path, certificate.keys.names(home()))
        certificate.check_roles(stated, path, certificate.keys.trusted(home()), signer)
        certificate.check_stated(stated, path, datetime.now(UTC))
        check_clock(stated, path, datetime.now(UTC))
        if signer is not None:
            check_number(stated, path)
        nobody_yet = stated.number is None  # approved it: it can be made again
        if (found := recomputed(stated, progress=progress, closely=nobody_yet)).same is False:
            text = f"its run does not give what it states, and nothing was written ({'; '.join(found.why)})"
            raise InputError(f"{text}: make the draft again", file=path)
        check_approved(stated, path)

    return examine


def verify(
    calibration: Path,
    allowed_signers: Path | None = None,
    run: Source | None = None,
    progress: Progress = lambda step: None,
    *,
    only_kept: bool = False,
    in_archive: InArchive | None = None,
) -> Verification:
    """Check every signature of the calibration against the lab's trust list, or the one that is named.

    Where one holds it is worked out again from its run, `run` or that of the store; with `only_kept` nothing is.
    The archive is asked, by `in_archive`, when signatures came there and what supersedes the file.
    """
    bundle = None if run is None else run_bundle(run)
    run_sha256, chain = (bundle.sha256, bundle.stated_chain) if bundle else (None, None)
    with TemporaryDirectory() as there:
        came = {} if in_archive is None else _asked(in_archive, calibration, Path(there))
        found = signatures(calibration, allowed_signers, run_sha256, chain, came)
        if found.calibration is None or not found.valid:
            return found
        found = replace(found, recomputed=recomputed(found.calibration, bundle, progress, only_kept=only_kept))
        certificate.keep_superseding(found, home() / SUPERSEDING)
        folders, check = [home() / SUPERSEDING, home() / CALIBRATIONS, Path(there)], partial(_later, allowed_signers)
        return replace(found, superseded_by=certificate.superseded_by(found, folders, check))


def _later(allowed_signers: Path | None, path: Path) -> Verification:
    return signatures(path, allowed_signers)


def _asked(in_archive: InArchive, calibration: Path, folder: Path) -> Mapping[str, datetime]:
    made = [read_limited(file, LARGEST_SIGNATURE_BYTES) for file in certificate.signature_files(calibration)]
    return in_archive(read_limited(calibration, LARGEST_BYTES), made, folder)


def signatures(
    path: Path,
    allowed_signers: Path | None = None,
    run_sha256: str | None = None,
    chain: Mapping[str, Any] | None = None,
    came: Mapping[str, datetime] | None = None,
    noted: Mapping[str, datetime] | None = None,
) -> Verification:
    """The signatures alone, against the lab's trust list or the one that is named; whom the lab revoked is revoked.

    `came` says when each, by its SHA-256, came to the archive; `noted` when the audit log took it down, where the
    caller has read that for many files at once.
    """
    own = handed_out()
    signers = with_revocations(read_allowed_signers(allowed_signers), own) if allowed_signers else own
    revoked = certificate.keys.revoked(home())
    return certificate.verify(
        path, signers, revoked, datetime.now(UTC), run_sha256, chain, shown=partial(shown, came=came, noted=noted)
    )


def shown(
    file: Path,
    signature: bytes,
    came: Mapping[str, datetime] | None = None,
    noted: Mapping[str, datetime] | None = None,
) -> ShownTime | None:
    """Since when a signature is shown to be there, the earliest that is shown: by a token beside it of an authority
    that this lab trusts, by the lab's audit log, or by when it `came` to the archive.
    """
    digest = sha256(signature).hexdigest()
    seen: list[tuple[datetime | None, Literal["token", "audit log", "archive"]]] = [
        (shown_utc(file, signature, authorities()), "token"),
        (noted_utc(signature) if noted is None else noted.get(digest), "audit log"),
        ((came or {}).get(digest), "archive"),
    ]
    return min((ShownTime(utc, by) for utc, by in seen if utc is not None), key=lambda one: one.utc, default=None)
