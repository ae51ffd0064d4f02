"""`labcal approve`, `sign` and `verify`: from a draft to a file others can trust."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.keys import passphrase
from labcal.cli.screen import say

if TYPE_CHECKING:
    from labcal.certificate import Verification

CALIBRATION = typer.Argument(..., metavar="CAL", help="The calibration file.")


@app.command(rich_help_panel="Certificate")
def approve(
    calibration: Path = CALIBRATION, name: str = typer.Option(..., "--as", help="The approver; not the operator.")
) -> None:
    """Write an approver into a draft, before any signature."""
    from labcal import session

    approvers = session.approve(calibration, name).approvers
    say(f"{calibration}: approved by {', '.join(approvers)}; their own signature makes it more than a name")


@app.command(rich_help_panel="Certificate")
def sign(calibration: Path = CALIBRATION, key: str = typer.Option(..., help="The person whose key signs.")) -> None:
    """Sign a calibration: the signature goes to CAL.sshsig, a second person's to CAL.2.sshsig."""
    from labcal import session

    say(session.sign(calibration, key, passphrase(f"Passphrase of {key}: ")))
    if not session.load_calibration(calibration).approvers:
        say("PROVISIONAL: no approver is named, and after a signature none can be.")


@app.command(rich_help_panel="Certificate")
def verify(
    calibration: Path = CALIBRATION,
    allowed_signers: Path | None = typer.Option(None, help="Trust this list instead of the lab's."),
    run: str | None = typer.Option(None, metavar="RUN", help="Check too that it came from this run."),
) -> int:
    """Check every signature of a calibration. Exit code 0: valid; 1: not."""
    from labcal import session

    result = session.verify(calibration, allowed_signers, run)
    _show(result)
    return DONE if result.valid else NEGATIVE


def _show(result: Verification) -> None:
    for check in result.checks:
        signer = f"{check.principal or 'unknown'} {check.fingerprint or ''}".strip()
        say(f"{check.file.name}: {check.objection or 'good'} ({signer})")
    for sentence in result.sentences():
        say(sentence)
