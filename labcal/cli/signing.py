"""`labcal approve`, `sign` and `verify`: from a draft to a file others can trust, worked out again on the way."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import typer

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.keys import own_passphrase
from labcal.cli.progress import step_line
from labcal.cli.results import FORCE, JSON, json_path, write_json
from labcal.cli.screen import say
from labcal.files.outputs import claim

if TYPE_CHECKING:
    from labcal.certificate import SignatureCheck, Verification

CALIBRATION = typer.Argument(..., metavar="CAL", help="The calibration file.")

UNTIL = typer.Option(None, "--until", metavar="DATE", help="The last day on which it is good, as in 2027-11-21.")
SUPERSEDES = typer.Option(
    None, "--supersedes", metavar="OLDCAL", help="The calibration file that it takes the place of."
)


@app.command(rich_help_panel="Certificate")
def approve(
    calibration: Path = CALIBRATION,
    name: str = typer.Option(..., "--as", help="The approver; not the operator."),
    until: str | None = UNTIL,
    supersedes: Path | None = SUPERSEDES,
) -> None:
    """Write an approver into a draft, before any signature; refused where its run gives another calibration."""
    from labcal import session
    from labcal.certificate import stated_by_people

    stated = stated_by_people(until, supersedes)
    approvers = session.approve(calibration, name, step_line, stated).approvers
    say(f"{calibration}: approved by {', '.join(approvers)}; their own signature makes it more than a name")


@app.command(rich_help_panel="Certificate")
def sign(calibration: Path = CALIBRATION, key: str = typer.Option(..., help="The person whose key signs.")) -> None:
    """Sign a calibration: the signature goes to CAL.sshsig, a second person's to CAL.2.sshsig.

    Where its run is in the store it is worked out again first, and refused where the run gives another.
    """
    from labcal import session

    say(session.sign(calibration, key, own_passphrase(key), step_line, partial(say, err=True)))
    if not session.load_calibration(calibration).approvers:
        say("PROVISIONAL: no approver is named, and after a signature none can be.")


@app.command(rich_help_panel="Certificate")
def verify(
    calibration: Path = CALIBRATION,
    allowed_signers: Path | None = typer.Option(None, help="Trust this list instead of the lab's."),
    run: str | None = typer.Option(None, metavar="RUN", help="Check too that it came from this run."),
    require: Literal["released"] | None = typer.Option(None, help="Exit code 1 also where it is only provisional."),
    archive: str | None = typer.Option(
        None, metavar="URL", help="Ask this archive too, else that of LABCAL_ARCHIVE: times, and what supersedes it."
    ),
    json_file: str | None = JSON,
    force: bool = FORCE,
) -> int:
    """Check every signature of a calibration, and work it out again where its run is at hand.

    Exit code 0: released or provisional; 1: not valid, not signed, expired or superseded.
    """
    from labcal import session
    from labcal.session.in_archive import asking

    read = [calibration, *([allowed_signers] if allowed_signers else []), *(session.paths(run) if run else [])]
    claim("verify", json_path(json_file), inputs=read, force=force)
    in_archive = asking(archive, partial(say, err=True))
    result = session.verify(calibration, allowed_signers, run, step_line, in_archive=in_archive)
    if json_file is not None:
        write_json(_document(result), json_file, "verify", inputs=read, force=force)
    if json_file != "-":
        _show(result)
    return DONE if result.status in ("released", require or "provisional") else NEGATIVE


def _document(result: Verification) -> dict[str, object]:
    """The contract's JSON object."""
    again = result.recomputed
    return {
        "valid": result.valid,
        "status": result.status,
        "signers": list(result.signers),
        "signatures": [_signature(result, check) for check in result.checks],
        "recomputed": None if again is None else again.same,
        "as_stated": list(again.as_stated) if again else [],
        "why": [*result.faults(), *(again.why if again else ()), *_limits(result)],
    }


def _signature(result: Verification, check: SignatureCheck) -> dict[str, object]:
    """One signature: whose it is, when it was made, and by what that is known: a token, audit log, archive, claim."""
    stated = result.calibration.issued_utc if result.calibration else None
    seen = check.shown
    utc = stated if seen is None else seen.utc.isoformat(timespec="seconds").replace("+00:00", "Z")
    by = "claimed" if seen is None else seen.by
    return {"file": check.file.name, "signer": check.principal, "good": check.objection is None, "utc": utc, "by": by}


def _limits(result: Verification) -> list[str]:
    """Why it is not released, where its signatures hold."""
    until = result.calibration.validity.until if result.calibration else None
    said = [result.provisional] if result.valid and result.provisional else []
    said += [f"validity.until: {until} is past"] if result.valid and result.expired else []
    return said + ([f"superseded by the calibration of run {result.superseded_by}"] if result.superseded_by else [])


def _show(result: Verification) -> None:
    for check in result.checks:
        signer = f"{check.principal or 'unknown'} {check.fingerprint or ''}".strip()
        say(f"{check.file.name}: {check.objection or 'good'} ({signer}); {result.signed_at(check)}")
    for sentence in result.sentences():
        say(sentence)
