"""Who approves and signs a calibration here, and whose signatures hold."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from labcal import certificate
from labcal.certificate import Stated, Verification, read_allowed_signers
from labcal.certificate.allowed_signers import with_revocations
from labcal.certificate.timestamp import ShownTime, shown_utc
from labcal.errors import InputError
from labcal.files.home import home
from labcal.model import Calibration
from labcal.session.audited import note_file, noted_utc
from labcal.session.numbering import check_number, issuing, keep_signed
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
    note_file("approve", name, calibration)
    return approved


def sign(
    calibration: Path,
    name: str,
    passphrase: str,
    progress: Progress = lambda step: None,
    tell: Callable[[str], None] = lambda remark: None,
) -> Path:
    """Sign the calibration as `name`; returns the signature's path. Raises InputError where its run gives another.

    `tell` hears what came of asking for a time stamp, where the laboratory names an authority.
    """
    key = certificate.keys.signing_key(home(), name, passphrase)
    examine = _same_as_its_run(calibration, progress, name)
    with issuing(calibration) as issue:
        written = certificate.sign(calibration, name, key, handed_out(), examine, shown=shown, issue=issue)
    content = calibration.read_bytes()
    signed = certificate.parse_calibration(content, calibration)
    keep_signed(signed, content)
    note_file("sign", name, calibration, written)
    certificate.keep_superseding(signatures(calibration), home() / SUPERSEDING)
    if (said := stamp(written, signed.run_id)) is not None:
        tell(said)
    return written


def _same_as_its_run(path: Path, progress: Progress, signer: str | None = None) -> Callable[[Calibration], None]:
    def examine(stated: Calibration) -> None:
        certificate.check_approvers(stated, path, certificate.keys.names(home()))
        certificate.check_roles(stated, path, certificate.keys.trusted(home()), signer)
        if signer is not None:
            check_number(stated, path.read_bytes())
        if (found := recomputed(stated, progress=progress)).same is False:
            told = f"its run does not give what it states, and nothing was written ({'; '.join(found.why)})"
            raise InputError(f"{told}: make the draft again", file=path)

    return examine


def verify(
    calibration: Path,
    allowed_signers: Path | None = None,
    run: Source | None = None,
    progress: Progress = lambda step: None,
    *,
    only_kept: bool = False,
) -> Verification:
    """Check every signature of the calibration against the lab's trust list, or the one that is named.

    Where one holds it is worked out again from its run, `run` or that of the store; with `only_kept` nothing is.
    """
    bundle = None if run is None else run_bundle(run)
    sha256, chain = (bundle.sha256, bundle.stated_chain) if bundle else (None, None)
    found = signatures(calibration, allowed_signers, sha256, chain)
    if found.calibration is None or not found.valid:
        return found
    found = replace(found, recomputed=recomputed(found.calibration, bundle, progress, only_kept=only_kept))
    certificate.keep_superseding(found, home() / SUPERSEDING)
    folders = [home() / SUPERSEDING, home() / CALIBRATIONS]
    return replace(found, superseded_by=certificate.superseded_by(found, folders, signatures))


def signatures(
    path: Path,
    allowed_signers: Path | None = None,
    sha256: str | None = None,
    chain: Mapping[str, Any] | None = None,
) -> Verification:
    """The signatures alone, against the lab's trust list or the one that is named; whom the lab revoked is revoked."""
    own = handed_out()
    signers = with_revocations(read_allowed_signers(allowed_signers), own) if allowed_signers else own
    revoked = certificate.keys.revoked(home())
    return certificate.verify(path, signers, revoked, datetime.now(UTC), sha256, chain, shown=shown)


def shown(file: Path, signature: bytes) -> ShownTime | None:
    """Since when a signature is shown to be there, the earliest that is shown: by a token beside it of an authority
    that this lab trusts, or by the lab's audit log.
    """
    token, noted = shown_utc(file, signature, authorities()), noted_utc(signature)
    seen = [ShownTime(token, "token")] if token is not None else []
    seen += [ShownTime(noted, "audit log")] if noted is not None else []
    return min(seen, key=lambda one: one.utc, default=None)
